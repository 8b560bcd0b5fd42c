// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Broad phase on a uniform grid: the default.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Puts every box into the cells it touches and compares the boxes of each cell. A cell is about as
/// large as a mean box, so a few very large bodies among many small ones do no harm.
struct UniformGrid {
  double relative_skin = 0.1;  ///< over the mean diameter [-]

  /// Lists of a search; kept, so that the next one does not allocate.
  struct Workspace {
    std::vector<std::uint32_t> starts;
    std::vector<std::uint32_t> filled;
    std::vector<BodyIndex> members;
  };

  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    Workspace workspace;
    visit_pairs(boxes, workspace, visit);
  }

  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Workspace& workspace, Visit&& visit) const {
    if (boxes.size() < 2) return;
    const Layout grid = layout(boxes);
    // Not a structured binding: clang 16 with -fopenmp cannot capture one in a lambda.
    std::vector<std::uint32_t>& starts = workspace.starts;
    std::vector<std::uint32_t>& filled = workspace.filled;
    std::vector<BodyIndex>& members = workspace.members;
    starts.assign(grid.columns * grid.rows + 1, 0);
    for (const Box& box : boxes)
      grid.visit_cells(box, [&](std::size_t cell) { ++starts[cell + 1]; });
    for (std::size_t c = 1; c < starts.size(); ++c) starts[c] += starts[c - 1];
    members.resize(starts.back());
    filled.assign(starts.begin(), starts.end() - 1);
    for (std::size_t i = 0; i < boxes.size(); ++i)
      grid.visit_cells(
          boxes[i], [&](std::size_t cell) { members[filled[cell]++] = static_cast<BodyIndex>(i); });
    for (std::size_t cell = 0; cell + 1 < starts.size(); ++cell)
      for (std::uint32_t k = starts[cell]; k < starts[cell + 1]; ++k)
        for (std::uint32_t l = k + 1; l < starts[cell + 1]; ++l) {
          const Box& p = boxes[members[k]];
          const Box& q = boxes[members[l]];
          // Two boxes may share several cells; the one with the corner of their common part counts.
          if (p.overlaps(q) && grid.cell_of(componentwise_max(p.low, q.low)) == cell)
            visit(members[k], members[l]);
        }
  }

  void validate() const { require_non_negative("UniformGrid.relative_skin", relative_skin); }

 private:
  struct Layout {
    Vec2 origin{0, 0};
    double cell = 1;
    std::size_t columns = 1;
    std::size_t rows = 1;

    [[nodiscard]] static std::size_t clamp_index(double x, std::size_t n) {
      return x > 0 ? std::min(static_cast<std::size_t>(x), n - 1) : 0;
    }
    [[nodiscard]] std::size_t column(double x) const {
      return clamp_index((x - origin.x()) / cell, columns);
    }
    [[nodiscard]] std::size_t row(double y) const {
      return clamp_index((y - origin.y()) / cell, rows);
    }
    [[nodiscard]] std::size_t cell_of(const Vec2& v) const {
      return row(v.y()) * columns + column(v.x());
    }
    template <class Visit>
    void visit_cells(const Box& box, Visit&& visit) const {
      for (std::size_t r = row(box.low.y()); r <= row(box.high.y()); ++r)
        for (std::size_t c = column(box.low.x()); c <= column(box.high.x()); ++c)
          visit(r * columns + c);
    }
  };

  [[nodiscard]] static Layout layout(std::span<const Box> boxes) {
    Vec2 low = boxes[0].low;
    Vec2 high = boxes[0].high;
    double extent = 0;
    for (const Box& box : boxes) {
      low = componentwise_min(low, box.low);
      high = componentwise_max(high, box.high);
      extent += std::max(box.high.x() - box.low.x(), box.high.y() - box.low.y());
    }
    const auto count = static_cast<double>(boxes.size());
    const Vec2 span = high - low;
    // Bodies scattered far apart must not ask for more than a few cells each.
    const double cell = std::max({extent / count, std::sqrt(span.x() * span.y() / (4 * count)),
                                  std::max(span.x(), span.y()) / (4 * count)});
    const auto cells = [cell](double length) {
      return length > 0 ? static_cast<std::size_t>(length / cell) + 1 : 1;
    };
    return {low, cell, cells(span.x()), cells(span.y())};
  }
};

static_assert(BroadPhase<UniformGrid>);

}  // namespace riprap
