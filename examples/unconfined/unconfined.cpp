// SPDX-License-Identifier: BSL-1.0
// unconfined: rock specimens between platens: Rat at failure and what moves it, to calibrate RatF

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "files.hpp"

namespace {

using unconfined::Options;

Options read_options(int argc, char** argv) {
  Options o;
  std::string friction = "rough";
  CLI::App app{
      "Unconfined compression of a rectangular specimen in finite elements, up to the uniaxial\n"
      "strength: the share of failed elements (Rat) at failure, which is RatF for that rock, and\n"
      "Rat against each parameter. Numbers and pictures are written to a folder."};
  app.get_formatter()->column_width(42);
  app.option_defaults()->always_capture_default();
  app.add_option("--poisson", o.poisson, "Poisson's ratio [-]");
  app.add_option("--m-b", o.m_b, "Hoek-Brown constant of the intact rock [-]");
  app.add_option("--strength", o.strength, "uniaxial compressive strength [Pa]");
  app.add_option("--young", o.young, "Young's modulus [Pa]");
  app.add_option("--width", o.width, "of the specimen [m]");
  app.add_option("--aspect", o.aspect, "height over width [-]");
  app.add_option("--friction", friction, "of the platens [-], a number above 0 or rough");
  app.add_option("--load", o.load, "mean platen stress at failure over the strength [-]");
  app.add_option("--mesh-triangles", o.triangles, "wanted in the mesh [-]");
  app.add_option("--criterion", o.criterion, "failure of an element")
      ->check(CLI::IsMember({"hoek-brown", "mohr-coulomb"}));
  app.add_option("--plane", o.plane, "plane stress or plane strain")
      ->check(CLI::IsMember({"stress", "strain"}));
  app.add_option("--out", o.out, "folder for unconfined.json and the pictures (SVG)");
  try {
    app.parse(argc, argv);
    if (friction != "rough" && !CLI::detail::lexical_cast(friction, o.friction))
      throw CLI::ValidationError("--friction", "'" + friction + "' is neither a number nor rough");
  } catch (const CLI::ParseError& error) {
    std::exit(app.exit(error));
  }
  return o;
}

void print(const unconfined::Study& s) {
  const riprap::UnconfinedResult& r = s.specimen.result;
  std::printf(
      "Rat %.3f at %g times the strength: %zu of %zu elements, %zu in shear, %zu in tension\n",
      r.ratio(), s.options.load, r.tally.failed, r.tally.elements, r.shear, r.tensile);
  std::printf("which is RatF for this rock in this specimen; the paper has 0.32 to 0.39, 0.34 on "
              "average, and takes 0.4\n");
  std::printf("Rat reaches 0.4 at %.3f times the strength\n", s.load_at_0_4);
  const auto line = [](const unconfined::Sweep& sweep, const std::string& with = "") {
    const auto& first = sweep.points.front();
    const auto& last = sweep.points.back();
    std::printf("  %-32s%-9s Rat %.3f at %-8g %.3f at %-8g lowest %.3f, highest %.3f\n",
                sweep.parameter.c_str(), with.c_str(), first.y(), first.x(), last.y(), last.x(),
                sweep.lowest(), sweep.highest());
  };
  std::printf("what moves it:\n");
  for (const auto& p : s.poisson) line(p.sweep, "m_b " + riprap::to_text(p.m_b));
  for (const auto* sweep : {&s.young, &s.strength}) line(*sweep);
  for (const auto& sweep : s.others) line(sweep);
  for (const unconfined::Claim& claim : unconfined::claims(s))
    std::printf("%s: %s\n", claim.name.c_str(), claim.verdict.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  try {
    const unconfined::Study study = unconfined::unconfined_study(options);
    print(study);
    unconfined::write_files(study, options.out);
    std::printf("numbers and pictures in %s\n", options.out.c_str());
  } catch (const riprap::InvalidInput& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 2;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 1;
  }
}
