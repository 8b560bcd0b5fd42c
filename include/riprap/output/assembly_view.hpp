// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The window through which pictures of an assembly look at it: scale, axes, scale bar.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <riprap/geometry/overlap.hpp>
#include <riprap/output/svg.hpp>
#include <riprap/output/unit_prefix.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

namespace internal {

inline constexpr auto boundary_colour = "#8d949c";

}  // namespace internal

/// Maps the plane to a picture of 900 pixels with room for a title above and a legend on the right.
/// Points that are not finite or farther than 1e100 m from the origin do not widen it; without any
/// other it is a metre wide.
class AssemblyView {
 public:
  /// @param also points that are to be in the picture beside the particles
  explicit AssemblyView(const Particles& particles, Ring also = {}) {
    Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
    Vec2 high = -low;
    const auto include = [&](const Vec2& v) {
      if (!has_place(v)) return;
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    };
    bool has_platens = false;
    for (BodyIndex i = 0; i < particles.size(); ++i)
      if (particles.body(i).is_wall())
        has_platens = true;
      else
        for (const Vec2& v : particles.ring(i)) include(v);
    for (const Vec2& v : also) include(v);
    if (!(low.x() <= high.x())) low = high = Vec2{0, 0};
    if (has_platens) {
      const double rim = platen_rim * (high - low).maxCoeff();
      low.array() -= rim;
      high.array() += rim;
    }
    const double size = (high - low).maxCoeff();
    scale_ = extent / (size > 1 / farthest ? size : 1);
    centre_ = 0.5 * (low + high);
    half_ = 0.5 * scale_ * (high - low);
  }

  [[nodiscard]] Svg canvas() const {
    return {2 * half_.x() + 2 * margin + legend,
            std::max(2 * half_.y() + 2 * margin + header, least_height), decimals};
  }
  [[nodiscard]] double scale() const { return scale_; }  ///< pixels per metre
  [[nodiscard]] double legend_left() const { return 2 * half_.x() + 2 * margin; }

  [[nodiscard]] Vec2 operator()(const Vec2& x) const {
    const Vec2 d = scale_ * (x - centre_);
    return {margin + half_.x() + d.x(), header + margin + half_.y() - d.y()};
  }
  /// The part of a convex ring that is in the window: platens reach out of it. One with a vertex
  /// that has no place in any window is mapped as it is, for the picture to leave out.
  [[nodiscard]] std::vector<Vec2> operator()(Ring ring) const {
    const Vec2 reach = half_ / scale_;
    const Vec2 across{reach.x(), -reach.y()};
    const std::array<Vec2, 4> window{centre_ - reach, centre_ + across, centre_ + reach,
                                     centre_ - across};
    const auto outside = [&](const Vec2& v) {
      return ((v - centre_).cwiseAbs() - reach).maxCoeff() > 1e-9 * reach.maxCoeff();
    };
    std::vector<Vec2> out;
    if (std::none_of(ring.begin(), ring.end(), outside) ||
        !std::all_of(ring.begin(), ring.end(), has_place)) {
      for (const Vec2& v : ring) out.push_back((*this)(v));
    } else {
      const OverlapPolygon seen = overlap(window, ring, centre_, 0);
      for (const Vec2& v : seen.ring()) out.push_back((*this)(centre_ + v));
    }
    return out;
  }

  /// All particles as pale shapes to draw upon, driven ones in another tone than free ones.
  void outlines(Svg& svg, const Particles& particles) const {
    for (BodyIndex i = 0; i < particles.size(); ++i)
      svg.polygon((*this)(particles.ring(i)),
                  particles.body(i).is_free()
                      ? R"(fill="#faf7f0" stroke="#c9c4b8" stroke-width="0.5")"
                      : R"(fill="#e3e5e8" stroke="#c9c4b8" stroke-width="0.5")");
  }

  /// Title, the two axes and a scale bar of a round length.
  void annotate(Svg& svg, const std::string& title) const {
    svg.text({margin, 28}, title, "start", 17);
    constexpr auto ink = "stroke=\"#222\" stroke-width=\"1.5\"";
    const Vec2 origin{legend_left() + 14, svg.height() - 60};
    svg.line(origin, origin + Vec2{40, 0}, ink);
    svg.line(origin, origin - Vec2{0, 40}, ink);
    svg.text(origin + Vec2{46, 5}, "axis 1");
    svg.text(origin - Vec2{6, 46}, "axis 2");
    // The longest of 1, 2 or 5 times a power of ten that leaves room for its label.
    const double room = 0.5 * legend / scale_;
    const double decade = std::pow(10, std::floor(std::log10(room)));
    const double metres = decade * (room >= 5 * decade ? 5 : room >= 2 * decade ? 2 : 1);
    const double length = metres * scale_;
    const Vec2 bar{legend_left() + 14, svg.height() - 22};
    svg.line(bar, bar + Vec2{length, 0}, "stroke=\"#222\" stroke-width=\"3\"");
    const UnitPrefix prefix = unit_prefix(metres);
    svg.text(bar + Vec2{length + 8, 5},
             rounded_text(metres / prefix.factor) + " " + prefix.symbol + "m");
  }

 private:
  [[nodiscard]] static bool has_place(const Vec2& v) {
    return std::abs(v.x()) <= farthest && std::abs(v.y()) <= farthest;
  }

  static constexpr double farthest = 1e100;   // [m]
  static constexpr double extent = 900;       // pixels of the larger side
  static constexpr int decimals = 1;          // of a pixel
  static constexpr double platen_rim = 0.04;  // of the sample, in which platens are seen
  static constexpr double margin = 20;
  static constexpr double header = 30;
  static constexpr double legend = 190;
  static constexpr double least_height = 380;  // holds the legend of a flat assembly

  double scale_ = 1;
  Vec2 centre_{0, 0};
  Vec2 half_{0, 0};
};

}  // namespace riprap
