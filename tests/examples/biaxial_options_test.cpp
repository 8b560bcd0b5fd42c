// SPDX-License-Identifier: BSL-1.0
#include <biaxial/options.hpp>
#include <biaxial/policies.hpp>

#include <doctest/doctest.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <variant>
#include <vector>

#include <riprap/output/file.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/temporary_file.hpp>

using riprap::test::contains;
using riprap::test::message_of;
using riprap::test::near_relative;

namespace {

using Arguments = std::vector<std::string>;

std::string refusal(const Arguments& arguments) {
  try {
    (void)options_from(arguments);
  } catch (const CLI::ParseError& error) {
    return error.what();
  }
  return {};
}

Options read_back(const std::string& toml) {
  const riprap::test::TemporaryFile file;
  riprap::write_file(file.path(), toml);
  return options_from({"--config", file.path()});
}

/// What the library says of the options, in the words of the command.
std::string error_of(const Arguments& arguments) {
  const Options o = options_from(arguments);
  const std::string message = message_of([&] {
    o.assembly.validate();
    o.test.validate();
    o.rock.validate();
    riprap::Model{}
        .broad_phase(o.broad_phase)
        .contact_law(chosen_contact(o))
        .damping(o.damping)
        .time_step(o.time_step)
        .mesher(o.mesher)
        .criterion(chosen_criterion(o))
        .trigger(chosen_element_trigger(o))
        .splitter(o.splitter)
        .check_every(o.check_every)
        .validate();
  });
  return command_line::in_options(message, o.names);
}

}  // namespace

TEST_CASE("without options the defaults are those of the library") {
  const Options o = options_from({});
  CHECK(o.assembly.count == 500);
  CHECK(o.assembly.seed == 1);
  CHECK(o.test.confining_pressure == 2e6);
  CHECK(o.test.axial_strain == 0.2);
  CHECK(o.compiled_in());
  CHECK(std::get<riprap::HoekBrown>(chosen_criterion(o).chosen).m_b == riprap::HoekBrown{}.m_b);
  CHECK(o.area.area_stiffness == riprap::OverlapAreaSpring{}.area_stiffness);
}

TEST_CASE("the file of parameters repeats the run, whatever was chosen") {
  const std::vector<Arguments> runs{
      {},
      {"--seed", "18446744073709551615", "--pressure", "0.1e7", "--strain", "0.30000000000000004",
       "--young", "1.2345678901234567e10", "--vertices", "4", "--paraview", "--frames",
       "--breakage", "off"},
      {"--contact", "area", "--mean-diameter", "0.003", "--friction", "0.3333333333333333"},
      {"--contact", "area", "--mean-diameter", "0.003", "--area-stiffness", "1e12",
       "--largest-chord", "0.01", "--boundary", "platens"},
      {"--contact", "dashpot", "--damping-ratio", "0.7", "--dashpot-may-pull", "--boundary",
       "periodic", "--integrator", "verlet", "--support", "pinned", "--plane", "strain"},
      {"--hoek-brown-angle", "tangent", "--m-b", "17", "--s", "0.9", "--a-b", "0.6"},
      {"--criterion", "mohr-coulomb", "--cohesion", "1e7", "--friction-angle", "0.7"},
      {"--criterion", "griffith", "--tensile-strength", "1e7"},
      {"--criterion", "modified-griffith", "--crack-friction", "0.9"},
      {"--criterion", "murrell"},
      {"--criterion", "hobbs", "--hobbs-factor", "4", "--strength-exponent", "0.6"},
      {"--criterion", "franklin", "--compressive-strength", "2e8", "--strength-exponent", "0.9"},
      {"--strength-scatter", "weibull", "--weibull-modulus", "3.3333333333333335",
       "--weibull-dimension", "3", "--strength-diameter", "0.02"}};
  for (const Arguments& arguments : runs) {
    const Options first = options_from(arguments);
    CAPTURE(first.toml);
    const Options again = read_back(first.toml);
    CHECK(again.toml == first.toml);
    CHECK(again.assembly.seed == first.assembly.seed);
    CHECK(again.test.axial_strain == first.test.axial_strain);
    CHECK(again.rock.young == first.rock.young);
    CHECK(again.breakage == first.breakage);
    CHECK(again.paraview == first.paraview);
    CHECK(again.frames == first.frames);
    CHECK(again.area.area_stiffness == first.area.area_stiffness);
    CHECK(again.dashpot.may_pull == first.dashpot.may_pull);
    CHECK(again.hoek_brown.angle == first.hoek_brown.angle);
    CHECK(again.hobbs.exponent == first.hobbs.exponent);
    CHECK(again.weibull.modulus == first.weibull.modulus);
    CHECK(again.strength_diameter == first.strength_diameter);
    // What changes no result is not in it.
    for (const std::string name : {"\nout =", "\nthreads =", "\ntimer =", "\nconfig ="})
      CHECK(!contains(first.toml, name));
  }
}

TEST_CASE("a preset sets options, which are refused beside it and not written") {
  for (const std::string preset : {"recommended", "paper"}) {
    CAPTURE(preset);
    const Options o = options_from({"--preset", preset, "--young", "5e10", "--breakage", "off",
                                    "--minimum-piece-area", "0.1", "--local-damping", "0.6"});
    CHECK(!o.compiled_in());
    CHECK(o.line_fit == (preset == "paper" ? "xy" : "mean-tension"));
    CHECK(o.support == (preset == "paper" ? "pinned" : "inertia-relief"));
    for (const std::string name : {"line-fit", "ratf", "mesh-triangles", "m-b", "contact"})
      CHECK(!contains(o.toml, "\n" + name + " = "));
    const Options again = read_back(o.toml);
    CHECK(again.toml == o.toml);
    CHECK(again.preset == preset);
    CHECK(again.splitter.minimum_area == 0.1);
    CHECK(again.damping.coefficient == 0.6);
    CHECK(refusal({"--line-fit", "x", "--preset", preset}) ==
          "--line-fit: is set by --preset " + preset + " and cannot be given with it");
    CHECK(refusal({"--boundary", "periodic", "--preset", preset}) != "");
    CHECK(refusal({"--timer", "--preset", preset}) != "");
  }
  CHECK(refusal({"--preset", "model", "--line-fit", "x"}) == "");
  CHECK(refusal({"--preset", "best"}) != "");
}

TEST_CASE("files of the sample are in the file of parameters, without what they replace") {
  const Options o = options_from({"--grading", "sieves.csv", "--outlines", "stones.wkt"});
  CHECK(o.grading == "sieves.csv");
  CHECK(contains(o.toml, "\noutlines = \"stones.wkt\"\n"));
  for (const std::string name : {"mean-diameter", "vertices", "angle-jitter"})
    CHECK(!contains(o.toml, "\n" + name + " = "));
  const Options again = read_back(o.toml);
  CHECK(again.toml == o.toml);
  CHECK(again.outlines == "stones.wkt");
  CHECK(!contains(options_from({}).toml, "\ngrading"));
  CHECK(refusal({"--grading", "s.csv", "--mean-diameter", "0.02"}) ==
        "--mean-diameter: is set by --grading s.csv and cannot be given with it");
  CHECK(refusal({"--outlines", "s.csv", "--vertices", "4"}) ==
        "--vertices: is set by --outlines s.csv and cannot be given with it");
}

TEST_CASE(
    "the file of parameters has a line for every parameter of the default model and the test") {
  const std::string toml = options_from({}).toml;
  for (const std::string name : {"particles",
                                 "seed",
                                 "mean-diameter",
                                 "smallest-diameter",
                                 "largest-diameter",
                                 "thickness",
                                 "vertices",
                                 "smallest-axis-ratio",
                                 "largest-axis-ratio",
                                 "angle-jitter",
                                 "solid-fraction",
                                 "dense-fraction",
                                 "boundary-spacing",
                                 "pressure",
                                 "strain",
                                 "inertial-number",
                                 "record-every",
                                 "jam-pressure",
                                 "jam-kinetic-ratio",
                                 "compaction-inertial-number",
                                 "rest-unbalanced-force",
                                 "hydrostatic-tolerance",
                                 "hydrostatic-unbalanced-force",
                                 "most-steps",
                                 "young",
                                 "poisson",
                                 "density",
                                 "preset",
                                 "contact",
                                 "friction",
                                 "normal-stiffness",
                                 "tangential-stiffness",
                                 "relative-skin",
                                 "boundary",
                                 "integrator",
                                 "local-damping",
                                 "time-step-fraction",
                                 "plane",
                                 "support",
                                 "mesh-triangles",
                                 "breakage",
                                 "criterion",
                                 "compressive-strength",
                                 "m-b",
                                 "s",
                                 "a-b",
                                 "hoek-brown-angle",
                                 "trigger",
                                 "ratf",
                                 "strength-scatter",
                                 "line-fit",
                                 "minimum-piece-area",
                                 "maximum-piece-aspect",
                                 "check-every"})
    CHECK_MESSAGE(contains(toml, "\n" + name + " = "), name);
}

TEST_CASE("a value that breaks a rule of the library is refused by the name of its option") {
  const std::vector<std::pair<Arguments, std::string>> cases{
      {{"--particles", "29"}, "--particles = 29: "},
      {{"--mean-diameter", "0"}, "--mean-diameter = 0: "},
      {{"--smallest-diameter", "2"}, "--smallest-diameter = 2: "},
      {{"--largest-diameter", "0.5"}, "--largest-diameter = 0.5: "},
      {{"--thickness", "-1"}, "--thickness = -1: "},
      {{"--vertices", "2"}, "--vertices = 2: "},
      {{"--vertices", "5-4"}, "--vertices = 4: "},
      {{"--smallest-axis-ratio", "0"}, "--smallest-axis-ratio = 0: "},
      {{"--largest-axis-ratio", "0.5"}, "--largest-axis-ratio = 0.5: must lie between --smallest-"},
      {{"--angle-jitter", "1"}, "--angle-jitter = 1: "},
      {{"--solid-fraction", "0.6"}, "--solid-fraction = 0.6: "},
      {{"--dense-fraction", "0.1"}, "--dense-fraction = 0.1: must lie above --solid-fraction"},
      {{"--boundary-spacing", "0"}, "--boundary-spacing = 0: "},
      {{"--pressure", "-2e6"}, "--pressure = -2e+06: "},
      {{"--strain", "0.9"}, "--strain = 0.9: "},
      {{"--inertial-number", "0"}, "--inertial-number = 0: "},
      {{"--record-every", "0"}, "--record-every = 0: "},
      {{"--jam-pressure", "0"}, "--jam-pressure = 0: "},
      {{"--jam-kinetic-ratio", "0"}, "--jam-kinetic-ratio = 0: "},
      {{"--compaction-inertial-number", "0"}, "--compaction-inertial-number = 0: "},
      {{"--rest-unbalanced-force", "0"}, "--rest-unbalanced-force = 0: "},
      {{"--hydrostatic-tolerance", "0"}, "--hydrostatic-tolerance = 0: "},
      {{"--hydrostatic-unbalanced-force", "0"}, "--hydrostatic-unbalanced-force = 0: "},
      {{"--young", "0"}, "--young = 0: "},
      {{"--poisson", "0.5"}, "--poisson = 0.5: "},
      {{"--density", "0"}, "--density = 0: "},
      {{"--friction", "-1"}, "--friction = -1: "},
      {{"--friction", "-1", "--contact", "area"}, "--friction = -1: "},
      {{"--friction", "-1", "--contact", "dashpot"}, "--friction = -1: "},
      {{"--normal-stiffness", "0"}, "--normal-stiffness = 0: "},
      {{"--normal-stiffness", "0", "--contact", "dashpot"}, "--normal-stiffness = 0: "},
      {{"--tangential-stiffness", "-1"}, "--tangential-stiffness = -1: "},
      {{"--area-stiffness", "0", "--contact", "area"}, "--area-stiffness = 0: "},
      {{"--largest-chord", "0", "--contact", "area"}, "--largest-chord = 0: "},
      {{"--damping-ratio", "1", "--contact", "dashpot"}, "--damping-ratio = 1: "},
      {{"--relative-skin", "-1"}, "--relative-skin = -1: "},
      {{"--local-damping", "1"}, "--local-damping = 1: "},
      {{"--time-step-fraction", "0"}, "--time-step-fraction = 0: "},
      {{"--mesh-triangles", "3"}, "--mesh-triangles = 3: "},
      {{"--compressive-strength", "0"}, "--compressive-strength = 0: "},
      {{"--m-b", "0"}, "--m-b = 0: "},
      {{"--s", "0"}, "--s = 0: "},
      {{"--a-b", "0"}, "--a-b = 0: "},
      {{"--cohesion", "0", "--criterion", "mohr-coulomb"}, "--cohesion = 0: "},
      {{"--friction-angle", "2", "--criterion", "mohr-coulomb"}, "--friction-angle = 2: "},
      {{"--tensile-strength", "0", "--criterion", "mohr-coulomb"}, "--tensile-strength = 0: "},
      {{"--tensile-strength", "0", "--criterion", "griffith"}, "--tensile-strength = 0: "},
      {{"--tensile-strength", "0", "--criterion", "modified-griffith"}, "--tensile-strength = 0: "},
      {{"--tensile-strength", "0", "--criterion", "murrell"}, "--tensile-strength = 0: "},
      {{"--tensile-strength", "0", "--criterion", "hobbs"}, "--tensile-strength = 0: "},
      {{"--tensile-strength", "0", "--criterion", "franklin"}, "--tensile-strength = 0: "},
      {{"--crack-friction", "0", "--criterion", "modified-griffith"}, "--crack-friction = 0: "},
      {{"--hobbs-factor", "0", "--criterion", "hobbs"}, "--hobbs-factor = 0: "},
      {{"--strength-exponent", "0", "--criterion", "hobbs"}, "--strength-exponent = 0: "},
      {{"--strength-exponent", "0", "--criterion", "franklin"}, "--strength-exponent = 0: "},
      {{"--ratf", "-0.1"}, "--ratf = -0.1: "},
      {{"--weibull-modulus", "0", "--strength-scatter", "weibull"},
       "--weibull-modulus = 0: must be a number above 0"},
      {{"--weibull-dimension", "-1", "--strength-scatter", "weibull"},
       "--weibull-dimension = -1: must be a finite number, 0 or above"},
      {{"--strength-diameter", "-0.01", "--strength-scatter", "weibull"},
       "--strength-diameter = -0.01: must be a finite number above 0"},
      {{"--minimum-piece-area", "-1"}, "--minimum-piece-area = -1: "},
      {{"--maximum-piece-aspect", "0.5"}, "--maximum-piece-aspect = 0.5: "},
      {{"--check-every", "0"}, "--check-every = 0: "}};
  for (const auto& [arguments, beginning] : cases)
    CHECK_MESSAGE(error_of(arguments).starts_with(beginning), error_of(arguments));
  CHECK(error_of({}) == "");
}

TEST_CASE("parameters of a law or a criterion that is not chosen are refused, not ignored") {
  for (const Arguments& arguments :
       std::vector<Arguments>{{"--cohesion", "1e7"},
                              {"--tensile-strength", "1e7"},
                              {"--m-b", "20", "--criterion", "griffith"},
                              {"--compressive-strength", "1e8", "--criterion", "murrell"},
                              {"--crack-friction", "0.5", "--criterion", "griffith"},
                              {"--hobbs-factor", "4", "--criterion", "franklin"},
                              {"--hoek-brown-angle", "tangent", "--criterion", "hobbs"},
                              {"--weibull-modulus", "4"},
                              {"--weibull-dimension", "3", "--trigger", "brazilian"},
                              {"--strength-diameter", "0.01", "--strength-scatter", "none"},
                              {"--damping-ratio", "0.1"},
                              {"--dashpot-may-pull", "--contact", "area"},
                              {"--normal-stiffness", "1e7", "--contact", "area"},
                              {"--area-stiffness", "1e12"},
                              {"--dense-fraction", "0.9", "--boundary", "periodic"},
                              {"--boundary-spacing", "1", "--boundary", "platens"}})
    CHECK_MESSAGE(contains(refusal(arguments), arguments.front() + ": goes with --"),
                  refusal(arguments));
}

TEST_CASE("counts are read strictly") {
  for (const std::string option :
       {"--seed", "--particles", "--mesh-triangles", "--check-every", "--most-steps", "--threads"})
    for (const std::string value : {"-1", "-18446744073709551615", "1.5", "", "010x"}) {
      CAPTURE(option);
      CAPTURE(value);
      CHECK(contains(refusal({option, value}), option + ": "));
    }
  for (const std::string value : {"-3", "3-", "3-5-7", "a", "", "3-65", "3--5", "0x3"})
    CHECK(contains(refusal({"--vertices", value}), "--vertices: '" + value + "' is neither"));
  CHECK(contains(refusal({"--threads", "0"}), "--threads: "));
  CHECK(options_from({"--vertices", "4"}).assembly.shape.most_vertices == 4);
}

TEST_CASE("the spring of the overlap area keeps its stiffness at a chord of the mean diameter") {
  const Options o = options_from({"--contact", "area", "--mean-diameter", "0.032"});
  CHECK(o.area.largest_chord == 0.032);
  CHECK(o.area.area_stiffness == riprap::OverlapAreaSpring{}.area_stiffness / 4);
}

TEST_CASE("each name of a line fit stands for one") {
  const auto stands_for = [](const std::string& name, auto fit) {
    const AnyLineFit chosen = chosen_line_fit(options_from({"--line-fit", name}));
    CHECK_MESSAGE(std::holds_alternative<decltype(fit)>(chosen.chosen), name);
  };
  stands_for("xy", riprap::WeightedXY{});
  stands_for("x", riprap::WeightedX{});
  stands_for("y", riprap::WeightedY{});
  stands_for("xy-mean-stress", riprap::WeightedXYByMeanStress{});
  stands_for("mean-tension", riprap::MeanTensionLine{});
  stands_for("tls", riprap::TotalLeastSquares{});
  stands_for("plane", riprap::FailurePlaneThroughCentroid{});
  stands_for("loaded-diameter", riprap::LoadedDiameter{});
  stands_for("mean-stress", riprap::MeanStressLine{});
  stands_for("mean-stress-plane", riprap::MeanStressFailurePlane{});
  CHECK(std::holds_alternative<riprap::WeightedXY>(chosen_line_fit(options_from({})).chosen));
  CHECK(contains(refusal({"--line-fit", "z"}), "--line-fit: "));
}

TEST_CASE("each name of a trigger by the loads stands for one, with a line fit of its own") {
  const auto stands_for = [](const std::string& name, auto trigger, auto fit) {
    const Options o = options_from({"--trigger", name});
    CHECK(o.breaks_by_loads());
    CHECK(!o.compiled_in());
    const AnyLoadTrigger chosen = chosen_load_trigger(o);
    CHECK_MESSAGE(std::holds_alternative<decltype(trigger)>(chosen.trigger.chosen), name);
    CHECK_MESSAGE(std::holds_alternative<decltype(fit)>(chosen_load_line_fit(o).chosen), name);
    CHECK(read_back(o.toml).toml == o.toml);
  };
  stands_for("brazilian", riprap::BrazilianStrength{}, riprap::LoadedDiameter{});
  stands_for("mean-stress", riprap::MeanStressFailure{}, riprap::MeanStressFailurePlane{});
  stands_for("hertz", riprap::HertzianStrength{}, riprap::LoadedDiameter{});
  stands_for("tsoungui", riprap::TsounguiStrength{}, riprap::MeanStressLine{});
  CHECK(!options_from({}).breaks_by_loads());
  CHECK(!options_from({"--line-fit", "loaded-diameter"}).breaks_by_loads());
}

TEST_CASE("options of a trigger go with it alone") {
  const Options o = options_from(
      {"--trigger", "tsoungui", "--particle-strength", "5e6", "--line-fit", "loaded-diameter"});
  CHECK(o.tsoungui.strength == 5e6);
  CHECK(std::holds_alternative<riprap::LoadedDiameter>(chosen_load_line_fit(o).chosen));
  CHECK(options_from({"--trigger", "hertz", "--particle-strength", "5e8"}).hertzian.pressure ==
        5e8);
  CHECK(contains(refusal({"--particle-strength", "5e6"}), "--particle-strength: "));
  CHECK(contains(refusal({"--trigger", "mean-stress", "--particle-strength", "5e6"}),
                 "--particle-strength: "));
  CHECK(contains(refusal({"--trigger", "brazilian", "--ratf", "0.3"}), "--ratf: "));
  CHECK(contains(refusal({"--trigger", "brazilian", "--line-fit", "xy"}), "--line-fit: "));
  CHECK(contains(refusal({"--trigger", "brazilian", "--preset", "paper"}), "--trigger: "));
}

TEST_CASE("strengths scatter by Weibull's law, with any trigger, by the seed of the sample") {
  const Options none = options_from({"--ratf", "0.3", "--seed", "7"});
  CHECK(none.compiled_in());
  CHECK(chosen_element_trigger(none).critical == 0.3);
  CHECK(!contains(none.toml, "weibull"));
  const std::vector<std::string> weibull{"--strength-scatter",
                                         "weibull",
                                         "--weibull-modulus",
                                         "4",
                                         "--weibull-dimension",
                                         "3",
                                         "--strength-diameter",
                                         "0.02",
                                         "--mean-diameter",
                                         "0.005",
                                         "--seed",
                                         "7",
                                         "--trigger"};
  const auto with = [&](const std::string& trigger) {
    std::vector<std::string> arguments = weibull;
    arguments.push_back(trigger);
    return options_from(arguments);
  };
  const Options o = with("failed-elements");
  CHECK(!o.compiled_in());
  const riprap::WeibullStrength elements = chosen_element_trigger(o);
  CHECK(elements.seed == 7);
  const double area = 0.25 * std::numbers::pi * 0.02 * 0.02;
  CHECK(elements.reference_area == near_relative(area, 1e-14));
  const AnyLoadTrigger loads = chosen_load_trigger(with("hertz"));
  CHECK(std::holds_alternative<riprap::HertzianStrength>(loads.trigger.chosen));
  for (const riprap::ParticleId id : {0U, 5U, 77U}) {
    CHECK(chosen_element_trigger(none).strength_factor(id, 1e-4) == 1);
    CHECK(chosen_load_trigger(none).strength_factor(id, 1e-4) == 1);
    CHECK(loads.strength_factor(id, area) == elements.strength_factor(id, area));
    // A quarter of the diameter: 4^(3 / 4) times the strength.
    CHECK(elements.strength_factor(id, area / 16) / elements.strength_factor(id, area) ==
          near_relative(std::pow(4, 0.75), 1e-13));
  }
  CHECK(contains(refusal({"--strength-scatter", "weibull", "--preset", "paper"}),
                 "--strength-scatter: is set by --preset paper"));
  CHECK(contains(refusal({"--strength-scatter", "weibull", "--timer"}), "--timer: "));
  CHECK(contains(refusal({"--strength-scatter", "normal"}), "--strength-scatter: "));
}

TEST_CASE("A run that goes on has the options of its folder, but for a few") {
  const riprap::test::TemporaryFile folder;
  std::filesystem::create_directories(folder.path());
  std::ofstream(folder.path() + "/parameters.toml") << "seed = 7\nfriction = 0.4\nstrain = 0.1\n";
  const Options o = options_from({"--resume", folder.path(), "--strain=0.3", "--threads", "1"});
  CHECK(o.assembly.seed == 7);
  CHECK(o.energy_conserving.friction == 0.4);
  CHECK(o.test.axial_strain == 0.3);
  CHECK(o.out == folder.path());
  CHECK_THROWS_AS((void)options_from({"--resume", folder.path(), "--seed", "3"}),
                  CLI::ValidationError);
  CHECK_THROWS_AS((void)options_from({"--resume", folder.path() + "/nothing"}), CLI::ParseError);
  std::filesystem::remove_all(folder.path());
}
