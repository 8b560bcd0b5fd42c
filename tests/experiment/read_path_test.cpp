// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/experiment/read_path.hpp>
#include <sstream>
#include <string>
#include <variant>

using namespace riprap;

namespace {

LoadingPath<> read(const std::string& text) {
  std::istringstream in(text);
  return read_path(in, "path.toml");
}

std::string error_of(const std::string& text) {
  try {
    (void)read(text);
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

const std::string oedometer = R"(# An oedometer test.
confining_pressure = 2e6  # Pa

[preparation]
rest_unbalanced_force = 2e-3

[[stage]]
name = "loading # 1"
axis_1.control = "fixed"
axis_2.control = "engineering rate"
axis_2.inertial_number = 1e-3
end.condition = "stress"
end.of = "mean"
end.stress = 8e6
record_every = 0.001
breakage = false
at_cap = "error"
most_steps = 5000

[[stage]]
name = "shear"
axis_1.control = "stress"
axis_1.stress = 2e6
axis_1.inertial_number = 2e-3
axis_1.tolerance = 0.05
axis_2.control = "logarithmic rate"
axis_2.inertial_number = 0
axis_2.per_second = -0.25
axis_2.smooth = false
end.condition = "strain"
end.of = "volume"
end.strain = -0.01
)";

// Half the rate of the other axis.
struct Half {
  static constexpr const char* name = "half";
  double share = 0.5;
  double rate(const auto& /*view*/, int /*axis*/, double other) const { return share * other; }
  static void for_each_parameter(auto& self, auto&& visit) { visit("share", self.share); }
};

}  // namespace

TEST_CASE("a path is read with all of its stages and values") {
  const LoadingPath<> path = read(oedometer);
  CHECK(path.confining_pressure == 2e6);
  REQUIRE(path.stages.size() == 5);
  CHECK(path.stages[0].name == "compaction");
  CHECK(std::get<RestReached>(path.stages[1].end).unbalanced_force == 2e-3);
  CHECK(std::get<ControlledStress>(path.stages[2].axis_1).stress == 2e6);

  const LoadingStage<>& loading = path.stages[3];
  CHECK(loading.name == "loading # 1");
  CHECK(loading.part == Stage::loading);
  CHECK(std::holds_alternative<Fixed>(loading.axis_1));
  CHECK(std::get<EngineeringRate>(loading.axis_2).rate_of_strain.inertial_number == 1e-3);
  CHECK(std::get<EngineeringRate>(loading.axis_2).smooth);
  CHECK(std::get<StressReached>(loading.end).of == StressOf::mean);
  CHECK(std::get<StressReached>(loading.end).stress == 8e6);
  CHECK(loading.record_every == 0.001);
  CHECK(!loading.breakage);
  CHECK(loading.friction);
  CHECK(loading.at_cap == AtCap::error);
  CHECK(loading.most_steps == 5000);

  const LoadingStage<>& shear = path.stages[4];
  CHECK(std::get<ControlledStress>(shear.axis_1).control.expected_rate.inertial_number == 2e-3);
  CHECK(std::get<ControlledStress>(shear.axis_1).control.tolerance == 0.05);
  CHECK(std::get<LogarithmicRate>(shear.axis_2).rate_of_strain.per_second == -0.25);
  CHECK(!std::get<LogarithmicRate>(shear.axis_2).smooth);
  CHECK(std::get<StrainReached>(shear.end).of == StrainOf::volume);
  CHECK(std::get<StrainReached>(shear.end).strain == -0.01);
}

TEST_CASE("a program's own control and condition are read by their names") {
  std::istringstream in("[[stage]]\nname = \"a\"\naxis_1.control = \"half\"\naxis_1.share = 0.25\n"
                        "axis_2.control = \"fixed\"\nend.condition = \"steps\"\nend.steps = 3\n");
  const auto path = read_path<LoadingStage<AxisControlOr<Half>>>(in, "own.toml");
  CHECK(std::get<Half>(path.stages[0].axis_1).share == 0.25);
  CHECK(std::get<StepsMade>(path.stages[0].end).steps == 3);
}

TEST_CASE("errors name file, line, key and rule") {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = oedometer;
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return error_of(text.replace(at, from.size(), to));
  };
  CHECK(changed("2e6  # Pa", "two") ==
        "path.toml, line 2: confining_pressure = two: must be a finite number");
  CHECK(changed("confining_pressure", "pressure") ==
        "path.toml, line 2: pressure = 2e6: the name is none of confining_pressure");
  CHECK(
      changed("axis_1.control = \"fixed\"", "axis_1.control = \"fix\"") ==
      "path.toml, line 9: axis_1.control = \"fix\": must be one of \"fixed\", \"engineering "
      "rate\", \"logarithmic rate\", \"constant volume\", \"stress\", \"free\", \"stress ratio\", "
      "\"mean stress\"");
  CHECK(changed("end.of = \"mean\"", "end.of = \"means\"") ==
        "path.toml, line 13: end.of = \"means\": must be one of \"axis 1\", \"axis 2\", \"mean\", "
        "\"difference\"");
  CHECK(changed("breakage = false", "breakage = no") ==
        "path.toml, line 16: breakage = no: must be true or false");
  CHECK(changed("most_steps = 5000", "most_steps = 0.5") ==
        "path.toml, line 18: most_steps = 0.5: must be a whole number, 0 or above");
  CHECK(changed("axis_2.inertial_number = 1e-3", "axis_2.inertia = 1e-3")
            .starts_with("path.toml, line 11: axis_2.inertia = 1e-3: the name is none of name, "
                         "axis_1.control, axis_2.control, axis_2.inertial_number, "));
  CHECK(changed("axis_2.inertial_number = 1e-3\n", "") ==
        "path.toml, line 7: stage 'loading # 1': axis_2.inertial_number = 0: must be other than 0, "
        "or per_second must, and not both");
  CHECK(changed("name = \"shear\"\n", "") == "path.toml, line 20: [[stage]] has no name");
  CHECK(changed("end.condition = \"stress\"\n", "") ==
        "path.toml, line 7: [[stage]] has no end.condition");
  CHECK(changed("breakage = false", "name = \"again\"") ==
        "path.toml, line 16: name: comes twice, first in line 8");
  CHECK(changed("[preparation]", "[prepare]") ==
        "path.toml, line 4: 'prepare': must be [preparation], once and first, or [[stage]]");
  CHECK(changed("[preparation]", "[preparation") ==
        "path.toml, line 4: '[preparation': must be [NAME] or [[NAME]]");
  CHECK(changed("2e-3", "-2e-3") ==
        "path.toml, line 4: Preparation.rest_unbalanced_force = -0.002: must be a finite number "
        "above 0");
  CHECK(changed("\"loading # 1\"", "\"loading") ==
        "path.toml, line 8: name = \"loading: the string has no end");
  CHECK(error_of("confining_pressure = 1e6\n") == "path.toml: no stages: must have one or more");
}
