// SPDX-License-Identifier: BSL-1.0
// A user's program: a loose sample is squeezed until particles touch, and a criterion of the user's
// own looks at them. The argument is the version of riprap that is expected.
#include <riprap/riprap.hpp>

#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

using namespace riprap;

struct Dust {  // stands no tension and no difference of stresses to speak of
  double major_stress_at_failure(double minor) const { return minor + 1e-3; }
  double tensile_strength() const { return 1e-3; }
};

static int failures = 0;

static void check(bool fulfilled, const char* what) {
  if (fulfilled) return;
  std::fprintf(stderr, "not so: %s\n", what);
  ++failures;
}

int main(int argc, char** argv) {
  check(argc == 2 && argv[1] == version, "the headers have the version of the package");

  auto model =
      Model{}.criterion(Dust{}).damping(NoDamping{}).mesher(UniformMesher{.triangles = 30});
  Simulation sim{model, random_assembly({.count = 40, .seed = 3}), Rock{}};
  check(sim.particles().size() == 40, "there are 40 particles");
  sim.set_breakage(false);
  sim.boundary().set_rate(300, 300);

  std::vector<bool> touched(40, false);
  const auto touches = [&] {
    touched.assign(touched.size(), false);
    int count = 0;
    sim.contacts().for_each_touching([&](const auto& contact) {
      touched[contact.a] = touched[contact.b] = true;
      ++count;
    });
    return count;
  };
  check(touches() == 0, "the sample starts loose");
  for (int i = 0; i < 1000 && touches() < 4; ++i) sim.step();
  check(touches() >= 4, "squeezed, particles touch");

  double mass = 0;
  double area = 0;
  Vec2 force{0, 0};
  double largest = 0;
  const std::vector<double> failed = sim.failed_ratios();
  for (BodyIndex i = 0; i < 40; ++i) {
    const Body& body = sim.particles().body(i);
    mass += body.mass;
    area += sim.particles().shape(i).area;
    force += body.contact.force;
    largest = std::fmax(largest, body.contact.force.norm());
    check((failed[i] > 0) == (touched[i] && body.is_free()), "loaded dust fails, and only that");
  }
  check(largest > 0, "contacts carry forces");
  // Sums of 40 terms: some 1e-14 of round-off.
  check(force.norm() < 1e-12 * largest, "action is reaction");
  const double expected = sim.rock().density * sim.particles().thickness() * area;
  check(std::fabs(mass - expected) < 1e-12 * expected, "mass is density times volume");

  std::printf("riprap %.*s: %d contacts after %d steps\n", int(version.size()), version.data(),
              touches(), int(sim.steps()));
  return failures;
}
