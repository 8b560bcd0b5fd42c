// SPDX-License-Identifier: BSL-1.0
#pragma once
// The critical load and the crack of a particle on every mesh, beside those of the reference.

#include <array>
#include <string>
#include <vector>

#include "strength.hpp"

namespace convergence {

// The first is the reference. Six-node triangles have four sampling points each.
inline constexpr std::array meshes{
    MeshChoice{.name = "reference", .triangles = 2400, .six_nodes = true},
    MeshChoice{.name = "check", .triangles = 600, .six_nodes = true},
    MeshChoice{.name = "linear", .triangles = 25},
    MeshChoice{.name = "linear", .triangles = 50},
    MeshChoice{.name = "linear", .triangles = 100},
    MeshChoice{.name = "linear", .triangles = 200},
    MeshChoice{.name = "linear", .triangles = 400},
    MeshChoice{.name = "linear", .triangles = 800},
    MeshChoice{.name = "six-node", .triangles = 13, .six_nodes = true},
    MeshChoice{.name = "six-node", .triangles = 25, .six_nodes = true},
    MeshChoice{.name = "six-node", .triangles = 50, .six_nodes = true},
    MeshChoice{.name = "six-node", .triangles = 100, .six_nodes = true},
    MeshChoice{.name = "six-node", .triangles = 200, .six_nodes = true},
    MeshChoice{.name = "linear, graded", .triangles = 100, .graded = true},
    MeshChoice{.name = "linear, graded", .triangles = 200, .graded = true},
    MeshChoice{.name = "linear, graded", .triangles = 400, .graded = true},
    MeshChoice{.name = "six-node, graded", .triangles = 25, .six_nodes = true, .graded = true},
    MeshChoice{.name = "six-node, graded", .triangles = 50, .six_nodes = true, .graded = true},
    MeshChoice{.name = "six-node, graded", .triangles = 100, .six_nodes = true, .graded = true},
};
// By which the reference is measured, for some of the particles.
inline constexpr MeshChoice fine_mesh{.name = "fine", .triangles = 9600, .six_nodes = true};

inline constexpr std::array m_b_values{10.0, 25.0, 40.0};

// The limit of FailedAreaRatio that this study is about, and the paper's.
inline constexpr double limit = 0.4;

[[nodiscard]] inline unsigned points_asked(const MeshChoice& mesh) {
  return (mesh.six_nodes ? 4 : 1) * mesh.triangles;
}
// calibrated_limit of riprap, not-a-number beyond its range.
[[nodiscard]] double limit_of(const MeshChoice& mesh);
// Of all meshes, with a blank before each: what the numbers of a file depend on.
[[nodiscard]] std::string limits_text();

struct Measurement {
  std::string mesh;
  unsigned points = 0;  // asked for
  Plane plane = Plane::stress;
  double m_b = 0;
  double load = 0;             // critical, over the forces of the test [-]
  double calibrated_load = 0;  // the same with limit_of
  double share = 0;            // failed, at the critical load of the reference [-]
  // Of each line to axis 1 [degrees], not-a-number where there is none.
  std::array<double, line_names.size()> angles{};
  std::array<bool, line_names.size()> accepted{};  // by StraightCut
  double reference_load = 0;
  std::array<double, line_names.size()> reference_angles{};
};

struct Extent {
  bool fine_mesh = false;
  bool plane_strain = false;
};

[[nodiscard]] std::vector<Measurement> measure(const LoadedParticle& particle, const Sample& sample,
                                               const Extent& extent);

[[nodiscard]] std::string to_lines(const std::vector<Measurement>& measurements);
[[nodiscard]] std::vector<Measurement> measurements_from(const std::string& lines);

}  // namespace convergence
