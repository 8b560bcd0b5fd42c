// SPDX-License-Identifier: BSL-1.0
#include "graded_mesh.hpp"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include <riprap/stress/mesher/uniform_mesher.hpp>

namespace convergence {

using riprap::Mesh;
using riprap::Vec2;

namespace {

// Radius about a point within which the mesh is not graded, over the particle's diameter.
constexpr double core = 0.03;

class Refinement {
 public:
  explicit Refinement(Mesh mesh) : mesh_(std::move(mesh)) {
    for (std::uint32_t i = 0; i < mesh_.boundary_nodes; ++i) boundary_.push_back(i);
  }

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  // Bisects triangle e and, before it, neighbours that have to be.
  void bisect(std::size_t e) {
    for (;;) {
      const std::size_t k = longest_edge(e);
      const std::size_t other = neighbour(e, k);
      if (other == none) return divide(e, k, none, 0);
      const std::size_t l = longest_edge(other);
      if (mesh_.triangles[other][l] == end_of(e, k) && end_of(other, l) == mesh_.triangles[e][k])
        return divide(e, k, other, l);
      bisect(other);  // its edges are longer: this ends
    }
  }

  // The boundary nodes first again.
  [[nodiscard]] Mesh finished() const {
    std::vector<std::uint32_t> number(mesh_.nodes.size(), 0);
    std::vector<bool> numbered(mesh_.nodes.size(), false);
    Mesh result;
    const auto add = [&](std::uint32_t node) {
      number[node] = static_cast<std::uint32_t>(result.nodes.size());
      numbered[node] = true;
      result.nodes.push_back(mesh_.nodes[node]);
    };
    for (const std::uint32_t node : boundary_) add(node);
    result.boundary_nodes = static_cast<std::uint32_t>(boundary_.size());
    for (std::uint32_t node = 0; node < mesh_.nodes.size(); ++node)
      if (!numbered[node]) add(node);
    for (const auto& [p, q, r] : mesh_.triangles)
      result.triangles.push_back({number[p], number[q], number[r]});
    for (const std::uint32_t corner : mesh_.corners) result.corners.push_back(number[corner]);
    return result;
  }

 private:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  [[nodiscard]] std::uint32_t end_of(std::size_t e, std::size_t k) const {
    return mesh_.triangles[e][(k + 1) % 3];
  }
  // Edge k of triangle e goes from its node k to the next. Equal lengths: of the lower nodes, so
  // that both triangles of an edge agree.
  [[nodiscard]] std::size_t longest_edge(std::size_t e) const {
    const auto order = [&](std::size_t k) {
      const auto [low, high] = std::minmax({mesh_.triangles[e][k], end_of(e, k)});
      return std::tuple((mesh_.nodes[high] - mesh_.nodes[low]).squaredNorm(), low, high);
    };
    std::size_t longest = 0;
    for (const std::size_t k : {1U, 2U})
      if (order(k) > order(longest)) longest = k;
    return longest;
  }
  [[nodiscard]] std::size_t neighbour(std::size_t e, std::size_t k) const {
    for (std::size_t other = 0; other < mesh_.size(); ++other)
      for (std::size_t l = 0; l < 3; ++l)
        if (mesh_.triangles[other][l] == end_of(e, k) && end_of(other, l) == mesh_.triangles[e][k])
          return other;
    return none;
  }
  void divide(std::size_t e, std::size_t k, std::size_t other, std::size_t l) {
    const std::uint32_t from = mesh_.triangles[e][k];
    const std::uint32_t to = end_of(e, k);
    const auto middle = static_cast<std::uint32_t>(mesh_.nodes.size());
    mesh_.nodes.push_back(0.5 * (mesh_.nodes[from] + mesh_.nodes[to]));
    halve(e, k, middle);
    if (other != none) return halve(other, l, middle);
    boundary_.insert(std::next(std::ranges::find(boundary_, from)), middle);
  }
  void halve(std::size_t e, std::size_t k, std::uint32_t middle) {
    auto half = mesh_.triangles[e];
    mesh_.triangles[e][(k + 1) % 3] = middle;
    half[k] = middle;
    mesh_.triangles.push_back(half);
  }

  Mesh mesh_;
  std::vector<std::uint32_t> boundary_;  // counter-clockwise
};

}  // namespace

Mesh graded_mesh(const std::vector<Vec2>& ring, std::span<const Vec2> points, unsigned triangles) {
  Refinement refinement(riprap::UniformMesher{std::max(4U, triangles / 2)}(ring));
  const Mesh& mesh = refinement.mesh();
  double area = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) area += mesh.area(e);
  const auto wanted = [&](std::size_t e) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec2& x : points) nearest = std::min(nearest, (mesh.centroid(e) - x).squaredNorm());
    return mesh.area(e) / std::max(nearest, core * core * area);
  };
  while (mesh.size() < triangles) {
    std::size_t largest = 0;
    for (std::size_t e = 1; e < mesh.size(); ++e)
      if (wanted(e) > wanted(largest)) largest = e;
    refinement.bisect(largest);
  }
  return refinement.finished();
}

}  // namespace convergence
