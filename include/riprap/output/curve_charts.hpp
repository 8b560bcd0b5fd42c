// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The curves of a biaxial test as charts against axial strain.

#include <functional>
#include <string>
#include <vector>

#include <riprap/experiment/curve.hpp>
#include <riprap/output/chart.hpp>

namespace riprap {

/// Mobilised friction, volumetric strain, coordination, anisotropies, breakages and confinement.
[[nodiscard]] inline std::vector<Chart> curve_charts(const Curve& curve) {
  const auto series = [&curve](std::string name, std::string colour, auto value,
                               bool dashed = false) {
    Series s{std::move(name), {}, std::move(colour), dashed};
    for (const CurvePoint& p : curve.points())
      s.points.push_back({100 * p.axial_strain, static_cast<double>(std::invoke(value, p))});
    return s;
  };
  const std::string strain = "axial strain [%]";
  constexpr auto blue = "#1f6fb4";
  constexpr auto orange = "#d9661f";
  constexpr auto green = "#2e8b57";
  constexpr auto grey = "#777777";
  return {
      {"Mobilised friction",
       strain,
       "sin phi [-]",
       {series("measured", blue, &CurvePoint::sin_phi),
        series("eq. 14", orange, &CurvePoint::sin_phi_fabric, true),
        series("eq. 15", grey, &CurvePoint::sin_phi_fabric_simplified, true)}},
      {"Volumetric strain",
       strain,
       "volumetric strain [%], contraction +",
       {series("", blue, [](const CurvePoint& p) { return 100 * p.volumetric_strain; })}},
      {"Coordination",
       strain,
       "contacts of a particle [-]",
       {series("coordination 2M/N", blue,
               [](const CurvePoint& p) { return p.coordination.coordination_number; }),
        series("contacts M/N", grey,
               [](const CurvePoint& p) { return p.coordination.contacts_per_particle; })}},
      {"Anisotropy",
       strain,
       "coefficient [-]",
       {series("a_n normal force", blue,
               [](const CurvePoint& p) { return p.fabric.normal_forces.coefficient; }),
        series("a contact normal", orange,
               [](const CurvePoint& p) { return p.fabric.normals.coefficient; }),
        series("a_t tangential f.", green,
               [](const CurvePoint& p) { return p.fabric.tangential_forces.coefficient; })}},
      {"Breakages since the start of shear",
       strain,
       "count [-]",
       {series("", blue, &CurvePoint::breakages)}},
      {"Stresses",
       strain,
       "stress [MPa], compression +",
       {series("sigma 22", blue, [](const CurvePoint& p) { return 1e-6 * p.stress.s22; }),
        series("sigma 11", orange, [](const CurvePoint& p) { return 1e-6 * p.stress.s11; })}},
  };
}

}  // namespace riprap
