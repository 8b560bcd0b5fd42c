// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The strong and the weak network of contact forces: Radjai, Wolf, Jean and Moreau (1998), Bimodal
/// character of stress transmission in granular packings, Phys. Rev. Lett. 80, 61-64.

#include <array>
#include <cstddef>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/contact_sum.hpp>
#include <riprap/measurement/fabric.hpp>

namespace riprap {

/// The contacts of one network.
struct ForceNetwork {
  std::size_t contacts = 0;
  double contact_share = 0;  ///< of the loaded contacts [-]
  double force_share = 0;    ///< of the sum of all normal forces [-]
  Stress2 stress;            ///< its part of the average stress [Pa], compression positive
  double mean_share = 0;     ///< of the mean stress [-]
  /// Of the deviatoric stress [-]: s_k : s / (s : s) with the deviator s of the average stress and
  /// the part s_k of the network. The shares of the networks add up to one; one that is loaded
  /// across the principal directions of the whole has a share below zero.
  double deviator_share = 0;
  Fabric fabric;  ///< of its contacts, without those at walls and platens
};

/// Contacts above the threshold, and the other ones that are loaded.
struct ForceNetworks {
  double mean_normal_force = 0;  ///< of the loaded contacts, f_n > 0 [N]
  ForceNetwork strong;
  ForceNetwork weak;
};

namespace internal {

/// s_k : s over s : s; zero where there is no deviator.
[[nodiscard]] inline double deviator_share(const Stress2& part, const Stress2& whole) {
  const double half = 0.5 * (whole.s11 - whole.s22);
  const double square = half * half + whole.s12 * whole.s12;
  return square == 0 ? 0 : (0.5 * (part.s11 - part.s22) * half + part.s12 * whole.s12) / square;
}

template <class Contacts, class IsIn>
[[nodiscard]] ForceNetwork force_network(const Contacts& contacts, double scale, IsIn&& is_in) {
  ForceNetwork out;
  std::vector<ContactSample> samples;
  const auto sums = sum_over_contacts<5>(contacts, [&](const auto& c) -> std::array<double, 5> {
    if (!is_in(c.force.normal)) return {};
    if (!c.at_wall())
      samples.push_back({c.geometry.normal, c.force.normal, c.force.tangential, c.branch()});
    const Stress2 s = symmetric_product(c.force_on_b(), c.branch());
    return {s.s11, s.s22, s.s12, c.force.normal, 1};
  });
  out.stress = scale * Stress2{sums[0], sums[1], sums[2]};
  require_finite_sum(out.stress);
  out.force_share = sums[3];  // not yet divided by the sum
  out.contacts = static_cast<std::size_t>(sums[4]);
  out.fabric = fabric(samples);
  return out;
}

}  // namespace internal

/// Splits the contacts that transmit a normal force at `threshold` times its mean: strong above,
/// weak up to it. The two parts of the stress add up to average_stress to round-off; contacts with
/// a tangential force alone are in neither.
/// @param area of the assembly [m^2]; @param thickness [m]; @param threshold [-]
/// Throws InvalidInput unless all three are above 0 and the sums are finite.
template <class Contacts>
[[nodiscard]] ForceNetworks force_networks(const Contacts& contacts, double area, double thickness,
                                           double threshold = 1) {
  require_positive("force_networks: area", area);
  require_positive("force_networks: thickness", thickness);
  require_positive("force_networks: threshold", threshold);
  const auto [force,
              count] = sum_over_contacts<2>(contacts, [](const auto& c) -> std::array<double, 2> {
    return c.force.normal > 0 ? std::array<double, 2>{c.force.normal, 1} : std::array<double, 2>{};
  });
  ForceNetworks out;
  if (count == 0) return out;
  out.mean_normal_force = force / count;
  const double limit = threshold * out.mean_normal_force;
  const double scale = 1 / (area * thickness);
  out.strong = internal::force_network(contacts, scale, [&](double f) { return f > limit; });
  out.weak =
      internal::force_network(contacts, scale, [&](double f) { return f > 0 && f <= limit; });
  Stress2 whole = out.strong.stress;
  whole += out.weak.stress;
  for (ForceNetwork* network : {&out.strong, &out.weak}) {
    network->contact_share = static_cast<double>(network->contacts) / count;
    network->force_share /= force;
    network->mean_share = whole.mean() == 0 ? 0 : network->stress.mean() / whole.mean();
    network->deviator_share = internal::deviator_share(network->stress, whole);
  }
  return out;
}

}  // namespace riprap
