// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Neighbour search: all pairs of bodies, or of a body and an image of another, that are near.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/particle/domain.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// How far apart the bodies of the pairs of a search may be.
struct PairExtent {
  double skin = 0;         ///< by which gaps between bounding boxes are bridged [m]
  double centres = 0;      ///< distance of the centres of a pair along an axis, at most [m]
  int farthest_image = 1;  ///< periods between the two bodies of a pair, at most
};

/// Calls the broad phase with the bounding boxes of all bodies, enlarged by half of a skin; in a
/// periodic domain with those of their images along the cell's border, too.
template <BroadPhase Broad, class Domain>
class PairSearch {
 public:
  using Image = typename Domain::Image;

  explicit PairSearch(Broad broad) : broad_(std::move(broad)) {}

  /// Calls `visit(a, b, image)` once for each two bodies a < b, the second one by an image of it,
  /// that are near each other; two driven bodies are not a pair.
  /// @param with_skin finds pairs with a gap up to the skin of the broad phase, not only those
  /// whose boxes overlap now
  template <class Visit>
  PairExtent visit_pairs(const Particles& particles, const Domain& domain, bool with_skin,
                         Visit&& visit) {
    const double relative_skin = broad_.relative_skin;
    PairExtent extent = enclose(particles, with_skin ? relative_skin : 0);
    if constexpr (Domain::periodic) extent.farthest_image = add_images(particles, domain);
    const auto visit_boxes = [&](BodyIndex i, BodyIndex j) {
      Image image{};
      if constexpr (Domain::periodic)
        if (!resolve_images(i, j, image, particles)) return;
      if (i > j) std::swap(i, j);
      if (particles.body(i).is_free() || particles.body(j).is_free()) visit(i, j, image);
    };
    const std::span<const Box> boxes(boxes_);
    if constexpr (requires { typename Broad::Workspace; })
      broad_.visit_pairs(boxes, workspace_, visit_boxes);
    else
      broad_.visit_pairs(boxes, visit_boxes);
    return extent;
  }

 private:
  struct BodyImage {
    BodyIndex body = 0;
    Image image{};
  };
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  PairExtent enclose(const Particles& particles, double relative_skin) {
    double mean_radius = 0;
    double largest_radius = 0;
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      mean_radius += particles.shape(i).circumradius;
      largest_radius = std::max(largest_radius, particles.shape(i).circumradius);
    }
    const double skin = 2 * relative_skin * mean_radius / static_cast<double>(particles.size());
    const Vec2 margin{0.5 * skin, 0.5 * skin};
    boxes_.clear();
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const auto index = static_cast<BodyIndex>(i);
      Box box{Vec2::Constant(infinity), Vec2::Constant(-infinity)};
      for (const Vec2& v : particles.ring(index)) {
        box.low = componentwise_min(box.low, v);
        box.high = componentwise_max(box.high, v);
      }
      box.low -= margin;
      box.high += margin;
      boxes_.push_back(box);
    }
    // Of a pair whose boxes overlap; one more skin for the motion until the next rebuild, one
    // spare.
    return {.skin = skin, .centres = 2 * largest_radius + 3 * skin};
  }

  // Moves every box into the cell and adds the images that boxes there may overlap. Of two images
  // that are neighbours across the border, the one to the right of or above the other is added.
  // Returns how many periods the bodies of a pair may be apart.
  int add_images(const Particles& particles, const Domain& domain) {
    images_.clear();
    Box all{Vec2::Constant(infinity), Vec2::Constant(-infinity)};
    Image first{};
    Image last{};
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Image home = domain.cell_of(particles.body(static_cast<BodyIndex>(i)).position);
      first = {std::min(first.axis_1, home.axis_1), std::min(first.axis_2, home.axis_2)};
      last = {std::max(last.axis_1, home.axis_1), std::max(last.axis_2, home.axis_2)};
      images_.push_back({static_cast<BodyIndex>(i), -home});
      boxes_[i] = boxes_[i].moved(domain.offset(-home));
      all = {componentwise_min(all.low, boxes_[i].low),
             componentwise_max(all.high, boxes_[i].high)};
    }
    // In the row of images above, those next to the cell: a pair is less than a period apart along
    // axis 1, and its boxes in the cell less than another.
    const int above = static_cast<int>(std::lround(-domain.shear_offset / domain.period.x()));
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const auto add = [&](const Image& step) {
        const Box box = boxes_[i].moved(domain.offset(step));
        if (!box.overlaps(all)) return;
        boxes_.push_back(box);
        images_.push_back({static_cast<BodyIndex>(i), images_[i].image + step});
      };
      add({1, 0});
      for (int k = above - 2; k <= above + 2; ++k) add({k, 1});
    }
    const int farthest = domain.shear_offset == 0 ? 1 : std::abs(above) + 2;
    return farthest + std::max(last.axis_1 - first.axis_1, last.axis_2 - first.axis_2);
  }

  // From two boxes to two bodies and the image of the one with the higher index; false for two
  // added images, whose pair is found as another one.
  [[nodiscard]] bool resolve_images(BodyIndex& i, BodyIndex& j, Image& image,
                                    const Particles& particles) const {
    if (i >= particles.size() && j >= particles.size()) return false;
    const BodyImage& p = images_[i];
    const BodyImage& q = images_[j];
    if (p.body == q.body)
      throw SimulationError(particle_text(particles.ancestry(p.body).id) +
                            " meets its own image: the periodic cell is too small");
    image = p.body < q.body ? q.image + -p.image : p.image + -q.image;
    i = p.body;
    j = q.body;
    return true;
  }

  Broad broad_;
  [[no_unique_address]] typename requirements::WorkspaceOf<Broad>::type workspace_;
  std::vector<Box> boxes_;
  std::vector<BodyImage> images_;  // in a periodic domain only
};

}  // namespace riprap
