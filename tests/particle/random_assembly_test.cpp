// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/placement_grid.hpp>
#include <riprap/particle/random_assembly.hpp>

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <vector>

#include <riprap/dynamics/boundary/strain_field.hpp>
#include <riprap/geometry/overlap.hpp>

#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

struct Placed {
  Vec2 centroid;
  double area;
  bool on_boundary;
};

std::vector<Placed> placed(const Assembly& assembly) {
  std::vector<Placed> all;
  for (const PlacedParticle& p : assembly.particles) {
    const AreaProperties q = area_properties(p.polygon.ring());
    all.push_back({q.centroid, q.area, p.motion == Motion::strain_field});
  }
  return all;
}

std::size_t boundary_count(const Assembly& assembly) {
  std::size_t count = 0;
  for (const Placed& p : placed(assembly)) count += p.on_boundary;
  return count;
}

double total_area(const Assembly& assembly) {
  double area = 0;
  for (const Placed& p : placed(assembly)) area += p.area;
  return area;
}

/// Pairs that have an area in common, those of two boundary particles left out. All pairs are tried
/// whose centroids are not two of the largest diameters apart.
std::size_t overlapping_pairs(const Assembly& assembly) {
  const std::vector<PlacedParticle>& all = assembly.particles;
  const std::vector<Placed> places = placed(assembly);
  double widest = 0;
  for (const PlacedParticle& p : all) widest = std::max(widest, diameter(p.polygon.ring()));
  std::size_t count = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (places[i].on_boundary && places[j].on_boundary) continue;
      if ((places[i].centroid - places[j].centroid).norm() > 2 * widest) continue;
      count += overlap(all[i].polygon.ring(), all[j].polygon.ring(), {0, 0}, 0).size > 0;
    }
  return count;
}

std::string complaint(const RandomAssembly& options) {
  return message_of([&] { (void)random_assembly(options); });
}

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("there are as many particles as asked for, the boundary's first") {
  for (const unsigned count : {30u, 77u, 500u}) {
    const Assembly assembly = random_assembly({.count = count, .thickness = 0.012});
    CHECK(assembly.particles.size() == count);
    CHECK(assembly.thickness == 0.012);
    CHECK_NOTHROW(assembly.validate());
    const std::size_t boundary = boundary_count(assembly);
    CHECK(boundary >= 3);
    CHECK(boundary < count);
    for (std::size_t i = 0; i < count; ++i) {
      const PlacedParticle& p = assembly.particles[i];
      CHECK(p.motion == (i < boundary ? Motion::strain_field : Motion::free));
      CHECK(p.velocity.norm() == 0);
      CHECK(p.angular_velocity == 0);
    }
  }
}

TEST_CASE("no two particles overlap, but for neighbours on the boundary") {
  for (const std::uint64_t seed : {1u, 2u, 3u})
    CHECK(overlapping_pairs(random_assembly({.count = 300, .seed = seed})) == 0);
  CHECK(overlapping_pairs(random_assembly({.count = 100, .solid_fraction = 0.5})) == 0);
}

TEST_CASE("triangles of one size do not overlap either: their tips reach far") {
  // Tips that face each other meet at up to 1.28 diameters between the centroids. With cells of one
  // diameter a few pairs in a hundred assemblies were not seen; these seeds had some.
  const PolygonShape triangle{
      .most_vertices = 3, .smallest_axis_ratio = 0.5, .largest_axis_ratio = 0.5, .angle_jitter = 0};
  for (const std::uint64_t seed : {16u, 18u})
    CHECK(overlapping_pairs(random_assembly({.count = 2000,
                                             .seed = seed,
                                             .shape = triangle,
                                             .smallest_diameter = 1,
                                             .largest_diameter = 1,
                                             .solid_fraction = 0.42})) == 0);
}

TEST_CASE("the placement grid finds tips that meet from either end of two cells") {
  // Slender triangles with the centroid at the origin and the tip at 2/3 of their length.
  const ConvexPolygon right{{-1.0 / 3, -0.05}, {2.0 / 3, 0}, {-1.0 / 3, 0.05}};
  const ConvexPolygon left = right.moved(Rotation::from_angle(pi), {0, 0});
  const double cell = 2 * (2.0 / 3);
  for (double x = -3; x < 3; x += 0.17) {
    const ConvexPolygon first = shifted(right, {x, 0.4});
    internal::PlacementGrid grid(cell);
    grid.insert(first, {x, 0.4});
    const Vec2 touching{x + 4.0 / 3 - 0.001, 0.4};
    CHECK_FALSE(grid.is_clear(shifted(left, touching).ring(), touching));
    const Vec2 clear{x + 4.0 / 3 + 0.001, 0.4};
    CHECK(grid.is_clear(shifted(left, clear).ring(), clear));
  }
}

TEST_CASE("the boundary is a closed ring on a circle about the origin") {
  const RandomAssembly options{.count = 400};
  const Assembly assembly = random_assembly(options);
  const std::size_t n = boundary_count(assembly);
  const std::vector<Placed> all = placed(assembly);
  const double radius = std::sqrt(total_area(assembly) / (pi * options.solid_fraction));
  double round = 0;
  for (std::size_t i = 0; i < n; ++i) {
    // Round-off of a centroid of a polygon a radius away.
    CHECK(std::abs(all[i].centroid.norm() - radius) <= 1e-13 * radius);
    const Vec2 here = all[i].centroid;
    const Vec2 next = all[(i + 1) % n].centroid;
    const double step = std::atan2(cross(here, next), here.dot(next));
    // Counter-clockwise, one after the other; no gap for a particle of mean size when the ring has
    // come in to its dense radius.
    CHECK(step > 0);
    const double dense = radius * std::sqrt(options.solid_fraction / options.dense_fraction);
    CHECK(step * dense < 2 * options.mean_diameter);
    round += step;
  }
  CHECK(std::abs(round - 2 * pi) <= 1e-12);
}

TEST_CASE("the ring's dense circumference is the spacing times the extents, within one particle") {
  for (const double spacing : {0.6, 0.8, 1.0}) {
    const RandomAssembly options{.count = 600, .boundary_spacing = spacing};
    const Assembly assembly = random_assembly(options);
    const std::size_t n = boundary_count(assembly);
    double extents = 0;
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const ConvexPolygon& polygon = assembly.particles[i].polygon;
      const Vec2 centre = area_properties(polygon.ring()).centroid;
      const double extent = internal::tangential_extent(shifted(polygon, -centre), centre);
      extents += extent;
      largest = std::max(largest, diameter(polygon.ring()));
    }
    const double circumference =
        2 * pi * std::sqrt(total_area(assembly) / (pi * options.dense_fraction));
    // The extents are taken in the direction at which a place begins, not at its middle.
    CHECK(spacing * extents >= 0.97 * circumference);
    CHECK(spacing * extents <= 1.03 * (circumference + spacing * largest));
  }
}

TEST_CASE("nothing starts outside the ring, and what is inside fills it") {
  // In the loosest one the ring has gaps that would let particles through.
  for (const double fraction : {0.45, 0.05}) {
    const RandomAssembly options{.count = 300, .seed = 5, .solid_fraction = fraction};
    const Assembly assembly = random_assembly(options);
    const double d = options.mean_diameter;
    const double reach = std::sqrt(total_area(assembly) / (pi * fraction)) - 0.5 * d;
    double innermost = reach;
    double outermost = 0;
    for (const Placed& p : placed(assembly)) {
      if (p.on_boundary) continue;
      CHECK(p.centroid.norm() <= reach * (1 + 1e-13));
      innermost = std::min(innermost, p.centroid.norm());
      outermost = std::max(outermost, p.centroid.norm());
    }
    // A circle of this radius holds ten particles on average, an annulus 2 d wide far more.
    CHECK(innermost < d * std::sqrt(2.5 / fraction));
    CHECK(outermost > reach - 2 * d);
  }
}

TEST_CASE("solid fraction is the particles' area over that of the boundary's circle") {
  for (const double fraction : {0.1, 0.3, 0.5}) {
    const Assembly assembly = random_assembly({.count = 200, .solid_fraction = fraction});
    const double radius = placed(assembly).front().centroid.norm();
    CHECK(total_area(assembly) / (pi * radius * radius) == near_relative(fraction, 1e-12));
  }
}

TEST_CASE("given diameters are those of the particles, in random order") {
  std::vector<double> diameters;
  for (int i = 0; i < 100; ++i) diameters.push_back(0.01 * (1 + 0.01 * i));
  const Assembly assembly = random_assembly({.count = 100, .diameters = diameters});
  std::vector<double> found;
  for (const Placed& p : placed(assembly)) found.push_back(equivalent_diameter(p.area));
  CHECK_FALSE(std::is_sorted(found.begin(), found.end()));
  std::sort(found.begin(), found.end());
  // Areas of polygons up to 20 diameters from the origin.
  for (std::size_t i = 0; i < found.size(); ++i)
    CHECK(found[i] == near_relative(diameters[i], 1e-12));
  CHECK(overlapping_pairs(assembly) == 0);
}

TEST_CASE("given outlines are scaled to the diameters and turned") {
  const ConvexPolygon square{{5, 5}, {7, 5}, {7, 7}, {5, 7}};
  const ConvexPolygon slab{{0, 0}, {3, 0}, {3, 1}, {0, 1}};
  const Assembly assembly = random_assembly({.count = 60,
                                             .mean_diameter = 0.02,
                                             .smallest_diameter = 1,
                                             .largest_diameter = 1,
                                             .outlines = {square, slab}});
  std::size_t squares = 0;
  for (const PlacedParticle& p : assembly.particles) {
    REQUIRE(p.polygon.size() == 4);
    const double area = area_properties(p.polygon.ring()).area;
    CHECK(area == near_relative(0.25 * pi * 0.02 * 0.02, 1e-12));
    const double first = (p.polygon[1] - p.polygon[0]).norm();
    const double second = (p.polygon[2] - p.polygon[1]).norm();
    const double aspect = first / second;
    CHECK((aspect == near_relative(1, 1e-12) || aspect == near_relative(3, 1e-12)));
    squares += aspect < 2;
  }
  // Of 60 fair draws, four standard deviations.
  CHECK(squares > 14);
  CHECK(squares < 46);
  CHECK(overlapping_pairs(assembly) == 0);
}

TEST_CASE("diameters that break a rule are refused") {
  CHECK(complaint({.count = 30, .diameters = {0.01}}) ==
        "RandomAssembly.diameters.size() = 1: must be 0 or RandomAssembly.count");
  std::vector<double> diameters(30, 0.01);
  diameters[7] = -0.01;
  CHECK(complaint({.count = 30, .diameters = diameters}) ==
        "RandomAssembly.diameters = -0.01: must be a finite number above 0");
}

TEST_CASE("diameters are uniform in the stated range") {
  const RandomAssembly options{.count = 2000,
                               .mean_diameter = 0.01,
                               .smallest_diameter = 0.5,
                               .largest_diameter = 1.5,
                               .solid_fraction = 0.3};
  double sum = 0;
  double squares = 0;
  for (const Placed& p : placed(random_assembly(options))) {
    const double ratio = std::sqrt(4 * p.area / pi) / options.mean_diameter;
    REQUIRE(ratio >= 0.5 * (1 - 1e-12));
    REQUIRE(ratio <= 1.5 * (1 + 1e-12));
    sum += ratio;
    squares += (ratio - 1) * (ratio - 1);
  }
  // Uniform of width one: variance 1/12, fourth moment 1/80; five standard errors.
  const double n = 2000;
  CHECK(std::abs(sum / n - 1) <= 5 / std::sqrt(12 * n));
  CHECK(std::abs(squares / n - 1.0 / 12) <= 5 * std::sqrt((1.0 / 80 - 1.0 / 144) / n));
}

TEST_CASE("in other units of length the assembly is the same") {
  const Assembly metres = random_assembly({.count = 60, .mean_diameter = 1});
  // A power of two leaves every digit as it is.
  const Assembly small = random_assembly({.count = 60, .mean_diameter = 1.0 / 64});
  for (std::size_t i = 0; i < 60; ++i)
    CHECK(small.particles[i].polygon[0] == metres.particles[i].polygon[0] / 64);
}

TEST_CASE("the same seed gives the same bytes, another seed another assembly") {
  const Assembly first = random_assembly({.count = 150, .seed = 9});
  const Assembly again = random_assembly({.count = 150, .seed = 9});
  const Assembly other = random_assembly({.count = 150, .seed = 10});
  bool differs = false;
  for (std::size_t i = 0; i < 150; ++i) {
    const ConvexPolygon& p = first.particles[i].polygon;
    const ConvexPolygon& q = again.particles[i].polygon;
    REQUIRE(p.size() == q.size());
    for (std::size_t k = 0; k < p.size(); ++k) REQUIRE(p[k] == q[k]);
    differs |= other.particles[i].polygon[0] != p[0];
  }
  CHECK(differs);
}

TEST_CASE("where there is no room, the error says which particle and what to do") {
  const PolygonShape needles{
      .most_vertices = 3, .smallest_axis_ratio = 0.02, .largest_axis_ratio = 0.02};
  const std::string text = complaint({.count = 60, .shape = needles, .solid_fraction = 0.5});
  CHECK(contains(text, "no room for particle "));
  CHECK(contains(text, "lower solid_fraction"));
}

TEST_CASE("options are checked by name, value and rule") {
  CHECK(complaint({.count = 29}) == "RandomAssembly.count = 29: must be 30 or more");
  for (const double bad : {0.0, -1.0, not_a_number}) {
    const std::string rest = " = " + to_text(bad) + ": must be a finite number above 0";
    CHECK(complaint({.mean_diameter = bad}) == "RandomAssembly.mean_diameter" + rest);
    CHECK(complaint({.thickness = bad}) == "RandomAssembly.thickness" + rest);
  }
  for (const double bad : {0.0, 1.1, not_a_number})
    CHECK(complaint({.smallest_diameter = bad}) ==
          "RandomAssembly.smallest_diameter = " + to_text(bad) + ": must lie in (0, 1]");
  for (const double bad : {0.9, 11.0, not_a_number})
    CHECK(complaint({.largest_diameter = bad}) ==
          "RandomAssembly.largest_diameter = " + to_text(bad) + ": must lie in [1, 10]");
  for (const double bad : {0.04, 0.51, not_a_number})
    CHECK(
        contains(complaint({.solid_fraction = bad}),
                 "RandomAssembly.solid_fraction = " + to_text(bad) + ": must lie in [0.05, 0.5]"));
  for (const double bad : {0.45, 1.01, not_a_number})
    CHECK(contains(complaint({.dense_fraction = bad}),
                   "RandomAssembly.dense_fraction = " + to_text(bad) + ": must lie above"));
  for (const double bad : {0.0, 2.1, not_a_number})
    CHECK(complaint({.boundary_spacing = bad}) ==
          "RandomAssembly.boundary_spacing = " + to_text(bad) + ": must lie in (0, 2]");
  CHECK(contains(complaint({.shape = {.fewest_vertices = 2}}), "PolygonShape.fewest_vertices = 2"));
}

TEST_CASE("a rectangular sample: the ring is closed on its sides, all others are inside") {
  for (const double aspect_ratio : {1.0, 2.5}) {
    const RandomAssembly options{.count = 400,
                                 .seed = 7,
                                 .sample_outline = SampleOutline::rectangle,
                                 .aspect_ratio = aspect_ratio};
    const Assembly assembly = random_assembly(options);
    REQUIRE(assembly.particles.size() == 400);
    CHECK(overlapping_pairs(assembly) == 0);
    const double area = total_area(assembly) / options.solid_fraction;
    const Vec2 half{0.5 * std::sqrt(area * aspect_ratio), 0.5 * std::sqrt(area / aspect_ratio)};
    double length = 0;  // along the ring
    Vec2 before{0, 0};
    Vec2 first{0, 0};
    std::size_t boundary = 0;
    for (const Placed& p : placed(assembly)) {
      const Vec2 share{std::abs(p.centroid.x()) / half.x(), std::abs(p.centroid.y()) / half.y()};
      if (p.on_boundary) {
        CHECK(std::max(share.x(), share.y()) == near_relative(1, 1e-12));
        if (boundary == 0) first = p.centroid;
        if (boundary > 0) length += (p.centroid - before).norm();
        before = p.centroid;
        ++boundary;
      } else {
        CHECK(std::min(half.x() * (1 - share.x()), half.y() * (1 - share.y())) >=
              0.5 * options.mean_diameter * (1 - 1e-12));
      }
    }
    // All round: four chords at most cut a corner, by less than a diameter and a half each.
    length += (first - before).norm();
    const double perimeter = 4 * (half.x() + half.y());
    CHECK(length <= perimeter * (1 + 1e-12));
    CHECK(length > perimeter - 4 * 1.5 * options.mean_diameter);
  }
}

TEST_CASE("the area of a rectangular sample follows the strain field") {
  Particles particles(1, 1);
  const Assembly assembly = random_assembly(
      {.count = 200, .seed = 3, .sample_outline = SampleOutline::rectangle, .aspect_ratio = 2});
  for (const PlacedParticle& p : assembly.particles) particles.add(p.polygon, p.motion);
  StrainField field;
  field.enclose(assembly, particles);
  field.set_rate(0.25, -0.5);
  const double before = field.region(particles).area();
  field.drive(particles.bodies(), 1);
  for (Body& body : particles.bodies()) body.position += 1.0 * body.velocity;
  CHECK(field.region(particles).area() == near_relative(before * 0.75 * 1.5, 1e-12));
}
