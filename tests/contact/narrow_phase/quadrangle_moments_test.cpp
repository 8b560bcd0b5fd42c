// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/quadrangle_moments.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>

using namespace riprap;
using internal::PlaneVector;
using internal::QuadrangleMoments;
using test::near;
using test::near_relative;

namespace {

using Vector = PlaneVector<double>;

QuadrangleMoments<double> moments(const Vector& p, const Vector& q, const Vector& r,
                                  const Vector& s) {
  const auto from = [](const Vector& a, const Vector& b) { return Vector{b.x - a.x, b.y - a.y}; };
  const auto twice = [&](const Vector& a, const Vector& b, const Vector& c) {
    return from(a, b).cross(from(a, c));
  };
  return {from(p, r), from(q, s), twice(p, q, r) + twice(p, r, s), twice(s, p, q), twice(p, q, r)};
}

// Of the second moments about the centroid: docs/theory/contact.md.
void check(const QuadrangleMoments<double>& m, double area, double determinant, double trace) {
  CHECK(0.5 * m.twice_area == near_relative(area, 1e-14));
  CHECK(std::pow(area, 4) / (432 * determinant) == near_relative(m.per_shape, 1e-13));
  CHECK(area / (72 * trace) == near_relative(m.per_spread, 1e-13));
  CHECK(m.slope * m.twice_area ==
        near_relative(std::sqrt(24 * determinant / (area * trace)), 1e-13));
}

}  // namespace

TEST_CASE("a rectangle has b h (b^2 + h^2) / 12 and (b h)^4 / 144") {
  const double b = 3;
  const double h = 0.2;
  const auto m = moments({0, 0}, {b, 0}, {b, h}, {0, h});
  check(m, b * h, std::pow(b * h, 4) / 144, b * h * (b * b + h * h) / 12);
  CHECK(m.a == near(0, 1e-15));
  CHECK(m.b == near(0, 1e-15));
}

TEST_CASE("a triangle, of two equal vertices or of three in a row") {
  // Right-angled with legs 3 and 2: about the centroid A 9 / 18, A 4 / 18 and -A 6 / 36.
  const double area = 3;
  const double determinant = area * area * (9.0 * 4 / (18 * 18) - 1.0 / 36);
  const double trace = area * (9.0 + 4) / 18;
  check(moments({0, 0}, {3, 0}, {0, 2}, {0, 2}), area, determinant, trace);
  const auto m = moments({1, 0}, {3, 0}, {0, 2}, {0, 0});  // vertex 1 in the middle of a side
  check(m, area, determinant, trace);
  CHECK(m.a == near_relative(1, 1e-15));
}
