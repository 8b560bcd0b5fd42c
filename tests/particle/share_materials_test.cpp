// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/share_materials.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/particle/random_assembly.hpp>
#include <support/message_of.hpp>

using namespace riprap;

namespace {

struct Shared {
  std::vector<double> shares;  // of the free area
  double largest = 0;          // particle, as a share
};

Shared shared(const Assembly& assembly, std::size_t materials) {
  Shared out{std::vector<double>(materials, 0)};
  double total = 0;
  for (const PlacedParticle& p : assembly.particles) {
    if (p.motion != Motion::free) {
      CHECK(p.material == 0);
      continue;
    }
    const double area = polygon_area(p.polygon.ring());
    total += area;
    out.largest = std::max(out.largest, area);
    out.shares[p.material] += area;
  }
  for (double& share : out.shares) share /= total;
  out.largest /= total;
  return out;
}

}  // namespace

TEST_CASE("each material has its share of the area to half a particle; the boundary has none") {
  Assembly assembly = random_assembly({.count = 200, .seed = 3});
  for (const std::vector<double>& wanted :
       {std::vector<double>{1}, {0.75, 0.25}, {0, 1}, {0.2, 0.5, 0.3}, {0.5, 0, 0.5}}) {
    share_materials(assembly, wanted, 7);
    const Shared got = shared(assembly, wanted.size());
    for (std::size_t m = 0; m < wanted.size(); ++m) {
      if (wanted[m] == 0)
        CHECK(got.shares[m] == 0);
      else  // half a particle at both ends
        CHECK(std::abs(got.shares[m] - wanted[m]) <= got.largest);
    }
  }
}

TEST_CASE("the more of one rock, the same particles and some more; another seed, other particles") {
  Assembly few = random_assembly({.count = 200, .seed = 3});
  Assembly more = few;
  Assembly other = few;
  share_materials(few, {0.75, 0.25}, 7);
  share_materials(more, {0.5, 0.5}, 7);
  share_materials(other, {0.75, 0.25}, 8);
  std::size_t differ = 0;
  for (std::size_t i = 0; i < few.particles.size(); ++i) {
    CHECK(few.particles[i].material <= more.particles[i].material);
    differ += few.particles[i].material != other.particles[i].material;
  }
  CHECK(differ > 20);
}

TEST_CASE("shares below 0 or of another sum are refused") {
  Assembly assembly = random_assembly({.count = 60, .seed = 3});
  CHECK(test::message_of([&] {
          share_materials(assembly, {0.5, 0.4});
        }) == "share_materials: sum of the shares = 0.9: must be 1");
  CHECK(test::message_of([&] {
          share_materials(assembly, {1.5, -0.5});
        }) == "share_materials: share = -0.5: must be a finite number, 0 or above");
  CHECK_FALSE(test::message_of([&] { share_materials(assembly, {}); }).empty());
}
