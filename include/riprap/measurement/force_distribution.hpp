// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Distribution of contact forces about their mean.

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>

namespace riprap {

/// Normal forces of the loaded contacts, f_n > 0 [N].
template <class Contacts>
[[nodiscard]] std::vector<double> normal_forces(const Contacts& contacts) {
  std::vector<double> out;
  contacts.for_each_touching([&](const auto& c) {
    if (c.force.normal > 0) out.push_back(c.force.normal);
  });
  return out;
}

/// Sizes of the tangential forces of the same contacts [N].
template <class Contacts>
[[nodiscard]] std::vector<double> tangential_forces(const Contacts& contacts) {
  std::vector<double> out;
  contacts.for_each_touching([&](const auto& c) {
    if (c.force.normal > 0) out.push_back(std::abs(c.force.tangential));
  });
  return out;
}

/// Bounds of the bins of x = f / <f>, of equal width or of equal ratio.
struct ForceBins {
  double first = 0;  ///< lower bound of the first bin [-]; above 0 for logarithmic bins
  double last = 6;   ///< upper bound of the last bin [-]
  std::size_t count = 24;
  bool logarithmic = false;

  void validate() const;
  /// count + 1 bounds, rising.
  [[nodiscard]] std::vector<double> bounds() const;
};

/// Probability density of x = f / <f>. The integral over the bins is the share of the forces in
/// them: one less those outside.
struct ForceDistribution {
  double mean = 0;                    ///< <f> [N]
  std::size_t forces = 0;             ///< in and outside the bins
  std::vector<double> bounds{};       ///< of the bins [-]; a bound belongs to the bin above it
  std::vector<std::size_t> counts{};  ///< of forces in each bin
  std::vector<double> density{};      ///< counts / (forces * width of the bin) [-]
};

/// Throws InvalidInput for a force that is negative or not finite, and unless the mean is above 0.
/// @param forces [N], of one kind: normal_forces or tangential_forces
[[nodiscard]] ForceDistribution force_distribution(std::span<const double> forces,
                                                   const ForceBins& bins = {});

/// The exponential tail p(x) ~ exp(-beta x) of x = f / <f>.
struct ExponentialTail {
  double rate = 0;            ///< beta [-]
  double standard_error = 0;  ///< beta / sqrt(n) of n forces [-], for large n
  std::size_t forces = 0;     ///< n, above `from`
};

/// Of the forces above `from` times their mean, by maximum likelihood: beta = n / sum (x - from).
/// The estimate is too large by a share 1 / n on average. Throws as force_distribution. Zero where
/// no force lies above.
[[nodiscard]] ExponentialTail exponential_tail(std::span<const double> forces, double from = 1);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/force_distribution.ipp>
#endif
