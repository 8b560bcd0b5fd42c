// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Broad phase on the R-tree of Boost.Geometry, for bodies of very different sizes. Optional:
/// riprap.hpp does not include it.

#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Packs all boxes into an R-tree at each rebuild and queries the neighbours of each.
struct RTree {
  double relative_skin = 0.1;  ///< over the mean diameter [-]

  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    namespace bg = boost::geometry;
    using Point = bg::model::d2::point_xy<double>;
    using Entry = std::pair<bg::model::box<Point>, BodyIndex>;
    const auto convert = [](const Box& b) {
      return bg::model::box<Point>{{b.low.x(), b.low.y()}, {b.high.x(), b.high.y()}};
    };
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      entries.emplace_back(convert(boxes[i]), static_cast<BodyIndex>(i));
    const bg::index::rtree<Entry, bg::index::rstar<16>> tree(entries);
    std::vector<Entry> found;
    for (const Entry& entry : entries) {
      found.clear();
      tree.query(bg::index::intersects(entry.first), std::back_inserter(found));
      for (const Entry& other : found)
        if (other.second > entry.second) visit(entry.second, other.second);
    }
  }

  void validate() const { require_non_negative("RTree.relative_skin", relative_skin); }
};

static_assert(BroadPhase<RTree>);

}  // namespace riprap
