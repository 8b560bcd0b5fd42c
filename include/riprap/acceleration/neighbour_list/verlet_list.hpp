// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Candidate pairs of the Verlet list (neighbour list), and when it has to be rebuilt.

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/acceleration/neighbour_list/displacement_bound.hpp>
#include <riprap/contact/domain.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Verlet list with a skin (Verlet 1967): the broad phase gets bounding boxes enlarged by half of
/// the skin, so that its pairs stay complete until a vertex has moved by half of the skin relative
/// to its neighbours. In a periodic domain it adds images along the cell's border.
template <BroadPhase Broad, class Domain>
class NeighbourSearch {
 public:
  using Image = typename Domain::Image;

  explicit NeighbourSearch(Broad broad) : broad_(std::move(broad)) {}

  /// See `DisplacementBound::record_motion`.
  void record_motion(const Particles& particles, std::size_t task, std::size_t first,
                     std::size_t last) {
    displacement_.record_motion(particles, task, first, last);
  }

  /// Updates the displacement bound to the present poses. True once pairs may be missing.
  template <Execution E = Serial>
  [[nodiscard]] bool stale(const Particles& particles, const Domain& domain,
                           const E& execution = {}) {
    if (displacement_.bodies() != particles.size()) {
      displacement_.restart(particles, domain);
      valid_until_ = -infinity;
    } else {
      displacement_.update(particles, domain, skin_ / 16, near_, farthest_image_, execution);
    }
    return displacement_.value() >= valid_until_;
  }

  /// The displacement bound, as of the last call of `stale`.
  [[nodiscard]] const DisplacementBound<Domain>& displacement() const { return displacement_; }

  /// Makes the next call of `stale` return true.
  void invalidate() { valid_until_ = -infinity; }

  /// Calls `visit(a, b, image)` once for each two bodies a < b, the second one by an image of it,
  /// that are near each other; two driven bodies are not a pair.
  template <class Visit>
  void visit_pairs(const Particles& particles, const Domain& domain, Visit&& visit) {
    enclose(particles, domain);
    if constexpr (Domain::periodic) add_images(particles, domain);
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
  }

 private:
  struct BodyImage {
    BodyIndex body = 0;
    Image image{};
  };
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  void enclose(const Particles& particles, const Domain& domain) {
    if (displacement_.bodies() != particles.size()) displacement_.restart(particles, domain);
    double mean_radius = 0;
    double largest_radius = 0;
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      mean_radius += particles.shape(i).circumradius;
      largest_radius = std::max(largest_radius, particles.shape(i).circumradius);
    }
    skin_ = 2 * broad_.relative_skin * mean_radius / static_cast<double>(particles.size());
    // Of a pair whose boxes overlap; one more skin for the motion until the next rebuild, one
    // spare.
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
    valid_until_ = displacement_.contact_threshold(skin_);
  }

  // Moves every box into the cell and adds the images that boxes there may overlap. Of two images
  // that are neighbours across the border, the one to the right of or above the other is added.
  void add_images(const Particles& particles, const Domain& domain) {
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
    for (std::size_t i = 0; i < particles.size(); ++i)
      for (const Image& step : {Image{1, -1}, Image{1, 0}, Image{1, 1}, Image{0, 1}}) {
        const Box box = boxes_[i].moved(domain.offset(step));
        if (!box.overlaps(all)) continue;
        boxes_.push_back(box);
        images_.push_back({static_cast<BodyIndex>(i), images_[i].image + step});
      }
    farthest_image_ = 1 + std::max(last.axis_1 - first.axis_1, last.axis_2 - first.axis_2);
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
  double skin_ = 0;
  double near_ = 0;  // centres of a pair, along an axis
  DisplacementBound<Domain> displacement_;
  double valid_until_ = -infinity;  // in terms of displacement_.value()
  // In a periodic domain only.
  std::vector<BodyImage> images_;
  int farthest_image_ = 1;
};

}  // namespace riprap
