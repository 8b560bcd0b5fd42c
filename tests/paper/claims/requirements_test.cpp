// SPDX-License-Identifier: BSL-1.0
#include <paper/claims/requirements.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <paper/made_up_study.hpp>

using report::Met;
using riprap::test::made_up_study;

TEST_CASE("the four outcomes are met where all is as the paper has it, and not the other way") {
  for (const bool as_claimed : {true, false})
    for (const report::Requirement& r :
         report::requirements(made_up_study({.as_claimed = as_claimed}))) {
      CAPTURE(r.text);
      CAPTURE(r.numbers);
      CHECK(r.met == (as_claimed ? Met::yes : Met::no));
    }
}

TEST_CASE("a single sample is enough, as means need no scatter") {
  for (const report::Requirement& r : report::requirements(made_up_study({.samples = 1})))
    CHECK(r.met == Met::yes);
}

TEST_CASE("a fall of friction counts from 0.03 on") {
  report::Results results;
  const auto add = [&](double pressure, double peak) {
    report::Run run;
    run.pressure = pressure;
    for (const char* name : {"axial_strain", "volumetric_strain", "coordination_number",
                             "sin_phi_eq_14", "sin_phi_eq_15"})
      run.curve[name] = {0, 0.2};
    run.curve["sin_phi"] = {0, peak};
    results.runs.push_back(run);
  };
  add(0.5e6, 0.60);
  add(14e6, 0.571);
  CHECK(report::requirements(results)[0].met == Met::no);
  results.runs.clear();
  add(0.5e6, 0.60);
  add(14e6, 0.569);
  CHECK(report::requirements(results)[0].met == Met::yes);
  CHECK(report::requirements(results)[0].numbers == "0.600 to 0.569, a fall of 0.031");
  // There is no run with breakage.
  CHECK(report::requirements(results)[1].met == Met::not_judged);
}
