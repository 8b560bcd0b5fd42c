// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Rectangles in rows and columns, each cell cut by both diagonals: a mesh with the symmetries of
/// the rectangle, whose rows of nodes are straight, and which refines into itself.

#include <cstdint>

#include <riprap/stress/mesher/concepts.hpp>

namespace riprap::test {

/// For rectangles about the origin along the axes, from the lower left vertex.
struct CrossedMesher {
  std::uint32_t columns = 8;
  std::uint32_t rows = 16;

  [[nodiscard]] Mesh operator()(Ring ring) const {
    Mesh mesh;
    const Vec2 size = ring[2] - ring[0];
    const auto place = [&](double i, double j) -> Vec2 {
      return {(i / columns - 0.5) * size.x(), (j / rows - 0.5) * size.y()};
    };
    for (std::uint32_t i = 0; i < columns; ++i) mesh.nodes.push_back(place(i, 0));
    for (std::uint32_t j = 0; j < rows; ++j) mesh.nodes.push_back(place(columns, j));
    for (std::uint32_t i = columns; i > 0; --i) mesh.nodes.push_back(place(i, rows));
    for (std::uint32_t j = rows; j > 0; --j) mesh.nodes.push_back(place(0, j));
    mesh.corners = {0, columns, columns + rows, 2 * columns + rows};
    mesh.boundary_nodes = 2 * (columns + rows);
    for (std::uint32_t j = 1; j < rows; ++j)
      for (std::uint32_t i = 1; i < columns; ++i) mesh.nodes.push_back(place(i, j));
    for (std::uint32_t j = 0; j < rows; ++j)
      for (std::uint32_t i = 0; i < columns; ++i) {
        const auto middle = static_cast<std::uint32_t>(mesh.nodes.size());
        mesh.nodes.push_back(place(i + 0.5, j + 0.5));
        mesh.triangles.push_back({node(i, j), node(i + 1, j), middle});
        mesh.triangles.push_back({node(i + 1, j), node(i + 1, j + 1), middle});
        mesh.triangles.push_back({node(i + 1, j + 1), node(i, j + 1), middle});
        mesh.triangles.push_back({node(i, j + 1), node(i, j), middle});
      }
    return mesh;
  }

  /// Index of the node in column i and row j, both from 0.
  [[nodiscard]] std::uint32_t node(std::uint32_t i, std::uint32_t j) const {
    if (j == 0) return i;
    if (i == columns) return columns + j;
    if (j == rows) return columns + rows + (columns - i);
    if (i == 0) return 2 * columns + rows + (rows - j);
    return 2 * (columns + rows) + (j - 1) * (columns - 1) + (i - 1);
  }
};

static_assert(Mesher<CrossedMesher>);

}  // namespace riprap::test
