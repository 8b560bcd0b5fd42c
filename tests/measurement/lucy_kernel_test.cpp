// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/lucy_kernel.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// By the midpoint rule, of second order where the kernel begins and ends.
double mean_by_points(const LucyKernel& kernel, const Vec2& p, const Vec2& q, const Vec2& centre) {
  constexpr int count = 20000;
  double sum = 0;
  for (int k = 0; k < count; ++k) sum += kernel((p + (k + 0.5) / count * (q - p) - centre).norm());
  return sum / count;
}

}  // namespace

TEST_CASE("the integral over the plane is one, whatever the radius") {
  for (const double c : {1e-3, 0.02, 4.0}) {
    const LucyKernel kernel{c};
    double sum = 0;
    constexpr int count = 1000;
    for (int k = 0; k < count; ++k) {
      const double r = c * (k + 0.5) / count;
      sum += 2 * std::numbers::pi * r * kernel(r) * c / count;
    }
    // Midpoint rule: of second order in 1 / 1000.
    CHECK(sum == near(1, 1e-5));
    CHECK(kernel(c) == 0);
    CHECK(kernel(2 * c) == 0);
    CHECK(kernel(0) == near_relative(5 / (std::numbers::pi * c * c), 1e-15));
  }
}

TEST_CASE("the mean over a segment is that of its points") {
  const LucyKernel kernel{0.3};
  const double peak = kernel(0);
  const Vec2 centre{2, -1};
  const auto at = [&](double x, double y) -> Vec2 { return centre + Vec2{x, y}; };
  const struct {
    Vec2 p;
    Vec2 q;
  } segments[] = {
      {at(-0.1, 0.05), at(0.2, -0.02)},   // inside
      {at(-0.7, 0.1), at(0.9, 0.2)},      // through
      {at(-0.7, 0.1), at(0.05, 0.2)},     // into
      {at(0.05, 0.02), at(0.01, 0.9)},    // out of
      {at(-0.4, 0), at(0.5, 0)},          // through the middle
      {at(0, 0), at(0.1, 0)},             // from the middle
      {at(-0.4, 0.299), at(0.4, 0.299)},  // along the rim
  };
  for (const auto& s : segments) {
    CHECK(kernel.mean_over(s.p, s.q, centre) ==
          near(mean_by_points(kernel, s.p, s.q, centre), 1e-7 * peak));
    CHECK(kernel.mean_over(s.q, s.p, centre) ==
          near(kernel.mean_over(s.p, s.q, centre), 1e-14 * peak));
  }
}

TEST_CASE("outside of the radius there is nothing, and a segment without length is a point") {
  const LucyKernel kernel{0.3};
  CHECK(kernel.mean_over({-1, 0.3}, {1, 0.3}, {0, 0}) == 0);
  CHECK(kernel.mean_over({0.31, 0}, {1, 0}, {0, 0}) == 0);
  CHECK(kernel.mean_over({0.1, 0}, {0.1, 0}, {0, 0}) == kernel(0.1));
  CHECK(contains(message_of([] { LucyKernel{}.validate(); }), "LucyKernel.radius = 0"));
}
