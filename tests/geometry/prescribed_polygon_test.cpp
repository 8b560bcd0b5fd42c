// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/prescribed_polygon.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/geometry/shape_measures.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Mean and standard deviation are those of the distribution to four standard errors; that of a
/// deviation is at most that of a normal distribution, whose tails are longer.
void check_follows(const std::vector<double>& values, const Distribution& wanted) {
  const double n = static_cast<double>(values.size());
  double sum = 0;
  for (const double x : values) sum += x;
  const double mean = sum / n;
  double squares = 0;
  for (const double x : values) squares += (x - mean) * (x - mean);
  const double deviation = wanted.standard_deviation();
  CHECK(mean == near(wanted.mean(), 4 * deviation / std::sqrt(n) + 1e-6));
  CHECK(std::sqrt(squares / n) == near(deviation, 4 * deviation / std::sqrt(2 * n) + 1e-6));
}

}  // namespace

TEST_CASE("elongation and number of corners of a sample are those that were asked for") {
  for (const Distribution& wanted :
       {Distribution::fixed(1), Distribution::fixed(2.5), Distribution::uniform(1.2, 2),
        Distribution::normal(1.5, 0.25, 1, 2.5)}) {
    const PrescribedShape shape{.fewest_corners = 4, .most_corners = 8, .elongation = wanted};
    shape.validate();
    Random random(11);
    std::vector<double> elongations;
    std::vector<int> corners(9, 0);
    for (int k = 0; k < 4000; ++k) {
      const ConvexPolygon polygon = random_polygon(shape, 0.02, random);
      elongations.push_back(moment_elongation(polygon.ring()));
      ++corners[polygon.size()];
      const AreaProperties p = area_properties(polygon.ring());
      CHECK(equivalent_diameter(p.area) == near_relative(0.02, 1e-12));
      CHECK(p.centroid.norm() < 1e-15);
    }
    check_follows(elongations, wanted);
    // A binomial number: four standard deviations.
    for (std::size_t n = 4; n <= 8; ++n)
      CHECK(corners[n] == near(800, 4 * std::sqrt(4000 * 0.2 * 0.8)));
  }
}

TEST_CASE("a single polygon has the elongation that was drawn") {
  const PrescribedShape shape{.elongation = Distribution::fixed(1.8)};
  Random random(2);
  for (int k = 0; k < 200; ++k)
    CHECK(moment_elongation(random_polygon(shape, 1, random).ring()) == near(1.8, 1e-12));
}

TEST_CASE("angularity of a sample is the one that was asked for, with the elongation") {
  const Distribution elongations = Distribution::normal(1.3, 0.1, 1, 1.5);
  for (const Distribution& wanted : {Distribution::fixed(10.5), Distribution::uniform(9.6, 11),
                                     Distribution::normal(10.2, 0.3, 9.5, 11)}) {
    const PrescribedShape shape{
        .fewest_corners = 5, .most_corners = 6, .elongation = elongations, .angularity = wanted};
    shape.validate();
    Random random(3);
    std::vector<double> sharp;
    std::vector<double> slender;
    for (int k = 0; k < 400; ++k) {
      const ConvexPolygon polygon = random_polygon(shape, 1, random);
      sharp.push_back(angularity(polygon));
      slender.push_back(moment_elongation(polygon.ring()));
    }
    check_follows(sharp, wanted);
    check_follows(slender, elongations);
  }
}

TEST_CASE("orientations are even") {
  // Of the longer axis: the mean of exp(2 i angle) has a variance of 1 / n.
  const PrescribedShape shape{.elongation = Distribution::fixed(2)};
  Random random(5);
  Vec2 sum{0, 0};
  for (int k = 0; k < 2000; ++k) {
    const ConvexPolygon polygon = random_polygon(shape, 1, random);
    const SecondMoments m = second_moments(polygon.ring(), {0, 0});
    const Vec2 doubled{m.xx - m.yy, 2 * m.xy};
    sum += doubled / doubled.norm();
  }
  CHECK(sum.norm() / 2000 < 4 / std::sqrt(2000));
}

TEST_CASE("an assembly has the shapes, before and after it is placed") {
  const PrescribedShape shape{.elongation = Distribution::uniform(1.2, 1.8)};
  const Assembly assembly =
      random_periodic_assembly({.count = 600, .seed = 4, .prescribed_shape = shape});
  std::vector<double> elongations;
  for (const PlacedParticle& p : assembly.particles)
    elongations.push_back(moment_elongation(p.polygon.ring()));
  check_follows(elongations, shape.elongation);
}

TEST_CASE("same seed, same bytes; rules") {
  Random a(1);
  Random b(1);
  const ConvexPolygon p = random_polygon(PrescribedShape{}, 1, a);
  const ConvexPolygon q = random_polygon(PrescribedShape{}, 1, b);
  CHECK(std::equal(p.begin(), p.end(), q.begin(), q.end()));
  const auto error = [](const PrescribedShape& s) { return message_of([&] { s.validate(); }); };
  CHECK(error({}).empty());
  CHECK(contains(error({.fewest_corners = 2}), "fewest_corners = 2"));
  CHECK(contains(error({.fewest_corners = 8}), "most_corners = 7"));
  CHECK(contains(error({.elongation = Distribution::fixed(0.5)}), "elongation = 0.5"));
  CHECK(contains(error({.angularity = Distribution::fixed(3)}), "must be 2 pi or more"));
  CHECK(contains(error({.unevenness = 1}), "unevenness = 1"));
  CHECK(contains(message_of([] {
                   (void)random_periodic_assembly(
                       {.prescribed_shape = PrescribedShape{.most_corners = 65}});
                 }),
                 "most_corners = 65"));
  // Twelve corners near a circle are never that sharp.
  const PrescribedShape blunt{.fewest_corners = 12,
                              .most_corners = 12,
                              .elongation = Distribution::fixed(1),
                              .angularity = Distribution::fixed(15)};
  CHECK(contains(message_of([&] { (void)random_polygon(blunt, 1, a); }),
                 "no polygon of 1,000 with 12 corners and an elongation of 1 has it"));
}
