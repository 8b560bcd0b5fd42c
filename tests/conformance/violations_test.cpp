// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <limits>
#include <utility>

#include <riprap/conformance/violations.hpp>

using namespace riprap;

TEST_CASE("where every comparison holds no violation is reported") {
  AxiomCheck check;
  check.equal("equal", 1.05, 1, 0.1);
  check.equal("equal without end", std::numeric_limits<double>::infinity(),
              std::numeric_limits<double>::infinity(), 0);
  check.at_least("least", 2, 2);
  check.at_most("most", 2, 2);
  check.holds("true", true);
  CHECK(check.violations().empty());
  CHECK(to_text(check.violations()) == "");
}

TEST_CASE("a violation names the axiom, the numbers and the place") {
  AxiomCheck check;
  check.equal("near", 1.25, 1, 0.125);
  check.at("depth", 0.5);
  check.at_least("high", 1, 2);
  check.at_most("low", 3, 2);
  check.holds("true", false);
  CHECK(to_text(std::move(check).violations()) ==
        "near: found 1.25, expected 1 to within 0.125\n"
        "high: found 1, expected 2 or more, at depth = 0.5\n"
        "low: found 3, expected 2 or less, at depth = 0.5\n"
        "true: found no, expected yes, at depth = 0.5\n");
}

TEST_CASE("only the first failure of an axiom is reported") {
  AxiomCheck check;
  check.at_least("high", 1, 2);
  check.at_least("high", 0, 2);
  check.equal("near", 0, 2, 0);
  CHECK(check.violations() ==
        Violations{"high: found 1, expected 2 or more", "near: found 0, expected 2 to within 0"});
}

TEST_CASE("a result that is not a number satisfies no comparison") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  AxiomCheck check;
  check.equal("equal", nan, 0, 1);
  check.equal("to nothing", 0, nan, 1);
  check.at_least("least", nan, 0);
  check.at_most("most", nan, 0);
  CHECK(check.violations().size() == 4);
}
