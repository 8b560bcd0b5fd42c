// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Sets of contacts whose distributions are known Fourier series.

#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/measurement/fabric.hpp>
#include <support/fake_contacts.hpp>

namespace riprap::test {

/// A fabric of which only the coefficients that matter are named.
struct Series {
  Anisotropy normals{};
  Anisotropy normal_forces{};
  Anisotropy tangential_forces{};
  Anisotropy normal_branches{};
  Anisotropy tangential_branches{};
  double mean_normal_force = 1;
  double mean_branch = 1;

  [[nodiscard]] Fabric fabric() const {
    return {normals,         normal_forces,       tangential_forces,
            normal_branches, tangential_branches, mean_normal_force,
            mean_branch};
  }
};

/// The direction below which a share `u` of the contacts lies, for
/// E = 1/(2 pi) (1 + a cos 2(theta - theta_0)).
[[nodiscard]] inline double direction_of_share(double u, const Anisotropy& e) {
  const double target = 2 * std::numbers::pi * u;
  const auto cumulated = [&](double theta) {
    return theta +
           0.5 * e.coefficient * (std::sin(2 * (theta - e.direction)) + std::sin(2 * e.direction));
  };
  double low = 0;
  double high = 2 * std::numbers::pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (cumulated(middle) < target ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Contacts at equal steps of the cumulated distribution of normals. A sum over them is the
/// midpoint rule for a smooth periodic function, whose error falls exponentially: with 1024
/// contacts and coefficients up to a half, moments are exact to round-off.
[[nodiscard]] inline FakeContacts synthetic_contacts(const Fabric& f, int count = 1024) {
  FakeContacts contacts;
  for (int k = 0; k < count; ++k) {
    const double theta = direction_of_share((k + 0.5) / count, f.normals);
    const Vec2 n{std::cos(theta), std::sin(theta)};
    const auto along = [theta](double mean, const Anisotropy& c) {
      return mean * (1 + c.coefficient * std::cos(2 * (theta - c.direction)));
    };
    const auto across = [theta](double mean, const Anisotropy& c) {
      return -mean * c.coefficient * std::sin(2 * (theta - c.direction));
    };
    const Vec2 branch = along(f.mean_branch, f.normal_branches) * n +
                        across(f.mean_branch, f.tangential_branches) * perpendicular(n);
    contacts.list.push_back(fake_contact(0, 1, Vec2{0, 0}, branch, n,
                                         along(f.mean_normal_force, f.normal_forces),
                                         across(f.mean_normal_force, f.tangential_forces)));
  }
  return contacts;
}

}  // namespace riprap::test
