// SPDX-License-Identifier: BSL-1.0
#include <single_particle/analysis.hpp>
#include <single_particle/options.hpp>

#include <doctest/doctest.h>

#include <string>

#include <riprap/output/file.hpp>
#include <support/message_of.hpp>
#include <support/temporary_file.hpp>

using riprap::test::contains;
using riprap::test::message_of;
using single_particle::chosen_case;
using single_particle::Options;

namespace {

std::string refusal(const Options& options) {
  return message_of([&] { (void)analyse(chosen_case(options)); });
}

Options square_with(const std::string& force) {
  return {.polygon = "0 0, 0.02 0, 0.02 0.02, 0 0.02",
          .wkt = "",
          .forces = {force, "0.01 0.02 0 -100"}};
}

}  // namespace

TEST_CASE("forces whose stress overflows are refused, and do not count as no failure") {
  for (const std::string force : {"1e308", "-1e308", "1e300", "1e150"}) {
    const std::string message = refusal(square_with("0.01 0 0 " + force));
    CHECK_MESSAGE(contains(message, "force"), message);
  }
  CHECK(refusal(square_with("0.01 0 0 100")) == "");
}

TEST_CASE("forces and vertices are read strictly") {
  for (const std::string force : {"", "0 0 1", "0 0 1 2 3", "0 0 1 nan", "0 0 1 inf", "0 0 1 1e999",
                                  "0 0 1 0x10", "0,0,1,2", "0 0 1 2N"})
    CHECK_MESSAGE(contains(refusal(square_with(force)), "--force = '" + force + "'"), force);
  for (const std::string polygon :
       {" ", ",", "0 0, 1 0, 1 1,", "0 0, 1 0 1 1", "0 0 1, 1 0 1, 1 1 1", "0 0; 1 0; 1 1",
        "0 0, 1 0, 1 nan", "(0 0, 1 0, 1 1)"}) {
    Options options = square_with("0 0 1 1");
    options.polygon = polygon;
    CHECK_MESSAGE(contains(refusal(options), "--polygon vertex "), polygon);
  }
}

TEST_CASE("a file of well-known text is read, or refused with its name and the place") {
  const riprap::test::TemporaryFile file;
  Options options = square_with("0.01 0 0 100");
  options.polygon = "";
  options.wkt = file.path();
  riprap::write_file(file.path(), "POLYGON ((0 0, 0 0.02, 0.02 0.02, 0.02 0, 0 0))\n");
  CHECK(chosen_case(options).polygon.size() == 4);
  riprap::write_file(file.path(), "POLYGON((0 0,1 1 0,0 1,0 0))");
  CHECK(contains(refusal(options), "--wkt = " + file.path() + ": well-known text, character 18"));
  options.wkt = "/no/such/file";
  CHECK(refusal(options) == "--wkt = /no/such/file: must be a file that can be read");
}
