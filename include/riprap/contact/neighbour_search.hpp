// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Which bodies are near each other, asked anew only when they have moved.

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/contact/plane.hpp>
#include <riprap/contact/travel.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Feeds a broad phase with boxes that are a little too large, so that its pairs stay good until
/// some vertex has moved by half the excess. In a periodic plane it adds images at the cell's
/// border.
template <BroadPhase Broad, class Plane>
class NeighbourSearch {
 public:
  using Image = typename Plane::Image;

  explicit NeighbourSearch(Broad broad) : broad_(std::move(broad)) {}

  /// See `Travel::follow`.
  void follow(const Particles& particles, std::size_t task, std::size_t first, std::size_t last) {
    travel_.follow(particles, task, first, last);
  }

  /// Follows the bodies to their present poses. True once pairs may be missing.
  template <Execution E = Serial>
  [[nodiscard]] bool stale(const Particles& particles, const Plane& plane,
                           const E& execution = {}) {
    if (travel_.bodies() != particles.size()) {
      travel_.restart(particles, plane);
      good_until_ = -infinity;
    } else {
      travel_.update(particles, plane, skin_ / 16, near_, farthest_image_, execution);
    }
    return travel_.so_far() >= good_until_;
  }

  /// How far bodies have moved, as of the last call of `stale`.
  [[nodiscard]] const Travel<Plane>& travel() const { return travel_; }

  /// Has the search made anew when it is asked next, whatever has moved.
  void invalidate() { good_until_ = -infinity; }

  /// Calls `visit(a, b, image)` once for each two bodies a < b, the second one by an image of it,
  /// that are near each other; two driven bodies are not a pair.
  template <class Visit>
  void visit_pairs(const Particles& particles, const Plane& plane, Visit&& visit) {
    enclose(particles, plane);
    if constexpr (Plane::periodic) add_images(particles, plane);
    const auto visit_boxes = [&](BodyIndex i, BodyIndex j) {
      Image image{};
      if constexpr (Plane::periodic)
        if (!resolve_images(i, j, image, particles)) return;
      if (i > j) std::swap(i, j);
      if (particles.body(i).is_free() || particles.body(j).is_free()) visit(i, j, image);
    };
    const std::span<const Box> boxes(boxes_);
    if constexpr (requires { typename Broad::Workspace; })
      broad_.visit_pairs(boxes, workspace_, visit_boxes);
    else
      broad_.visit_pairs(boxes, visit_boxes);
  }

 private:
  struct BodyImage {
    BodyIndex body = 0;
    Image image{};
  };
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void enclose(const Particles& particles, const Plane& plane) {
    if (travel_.bodies() != particles.size()) travel_.restart(particles, plane);
    double mean_radius = 0;
    double largest_radius = 0;
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      mean_radius += particles.shape(i).circumradius;
      largest_radius = std::max(largest_radius, particles.shape(i).circumradius);
    }
    skin_ = 2 * broad_.relative_skin * mean_radius / static_cast<double>(particles.size());
    // Of a pair whose boxes meet; another skin for the way until the list is new, and one more.
    near_ = 2 * largest_radius + 3 * skin_;
    const Vec2 margin{0.5 * skin_, 0.5 * skin_};
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
    good_until_ = travel_.until_closed(skin_);
  }

  // Moves every box into the cell and adds the images that may be met from there. Of two images
  // that are neighbours across the border, the one to the right of or above the other is added.
  void add_images(const Particles& particles, const Plane& plane) {
    images_.clear();
    Box all{Vec2::Constant(infinity), Vec2::Constant(-infinity)};
    Image first{};
    Image last{};
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const Image home = plane.cell_of(particles.body(static_cast<BodyIndex>(i)).position);
      first = {std::min(first.axis_1, home.axis_1), std::min(first.axis_2, home.axis_2)};
      last = {std::max(last.axis_1, home.axis_1), std::max(last.axis_2, home.axis_2)};
      images_.push_back({static_cast<BodyIndex>(i), -home});
      boxes_[i] = boxes_[i].moved(plane.offset(-home));
      all = {componentwise_min(all.low, boxes_[i].low),
             componentwise_max(all.high, boxes_[i].high)};
    }
    for (std::size_t i = 0; i < particles.size(); ++i)
      for (const Image& step : {Image{1, -1}, Image{1, 0}, Image{1, 1}, Image{0, 1}}) {
        const Box box = boxes_[i].moved(plane.offset(step));
        if (!box.meets(all)) continue;
        boxes_.push_back(box);
        images_.push_back({static_cast<BodyIndex>(i), images_[i].image + step});
      }
    farthest_image_ = 1 + std::max(last.axis_1 - first.axis_1, last.axis_2 - first.axis_2);
  }

  // From two boxes to two bodies and the image of the higher one that the lower one may meet; false
  // for two added images, which stand for a pair found elsewhere.
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
  [[no_unique_address]] typename clauses::WorkspaceOf<Broad>::type workspace_;
  std::vector<Box> boxes_;
  double skin_ = 0;
  double near_ = 0;  // centres of a pair, along an axis
  Travel<Plane> travel_;
  double good_until_ = -infinity;  // in terms of travel_.so_far()
  // In a periodic plane only.
  std::vector<BodyImage> images_;
  int farthest_image_ = 1;
};

}  // namespace riprap
