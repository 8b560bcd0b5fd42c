// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Overlaps by class: closed forms for the two most common ones, clipping for the rest.

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <riprap/contact/narrow_phase/common_part.hpp>
#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/geometry/corner_corner_overlap.hpp>
#include <riprap/geometry/corner_edge_overlap.hpp>
#include <riprap/geometry/separation.hpp>

namespace riprap {

/// Base of narrow phases that get their contact from the shape of the overlap. The class of the
/// overlap is kept from step to step and checked by a clear margin; where it does not hold any
/// more the rings are clipped, in an order that does not depend on that of the arguments.
///
/// `Model` derives from it and has as static members:
/// `Edge<N>`, made from an internal::EdgeCap<N>: overlaps of one or two corners with an edge, for
/// one or several pairs (SIMD), whose member `overlap(l, one_vertex)` gives that of lane l;
/// `of_edge(overlap, sign)` its contact, `sign` -1 if the edge is b's;
/// `Corners<N>`, made from an internal::CornerLens<N>, and `of_corners(overlap)`: those of two
/// corners;
/// `of_common_part(a, b, common)` that of any other overlap.
template <class Model>
struct ClassifiedOverlap {
  /// Class of the overlap at the last evaluation.
  struct Cache {
    enum class State : std::uint8_t {
      apart,          ///< separated by an edge
      corner_edge,    ///< one or two corners of one ring beyond a single edge of the other
      corner_corner,  ///< one corner of each ring inside the other
      general         ///< anything else
    };
    State state = State::apart;
    SeparatingEdge separating;  ///< apart
    bool of_b = false;          ///< corner_edge: whose edge
    CornerEdgeFeature entry;    ///< corner_edge
    std::uint8_t corner_a = 0;  ///< corner_corner
    std::uint8_t corner_b = 0;  ///< corner_corner
  };

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    if (cache.state == Cache::State::corner_edge) {
      if (auto contact = corner_edge_contact(a, b, cache)) return contact;
    } else if (cache.state == Cache::State::corner_corner) {
      if (auto contact = corner_corner_contact(a, b, cache)) return contact;
    } else if (cache.state == Cache::State::apart && separated(a, b, cache.separating)) {
      return std::nullopt;
    }
    return by_clipping(a, b, cache);
  }

  /// Pairs of one of the two classes with closed forms, evaluated together (SIMD).
  class Batch {
   public:
    using Of = Model;
    static constexpr std::size_t capacity = 4;
    static constexpr std::size_t kinds = 2;

    /// The class of a pair; `kinds` if it is evaluated singly.
    [[nodiscard]] static std::size_t kind(const Cache& cache) {
      if (cache.state == Cache::State::corner_edge) return 0;
      return cache.state == Cache::State::corner_corner ? 1 : kinds;
    }

    [[nodiscard]] std::size_t size() const { return size_; }
    void clear() { size_ = 0; }
    [[nodiscard]] bool add(Ring a, Ring b, const Cache& cache, ContactGeometry& contact) {
      if (size_ > 0 && kind(cache) != kind_) return false;
      kind_ = kind(cache);
      if (kind_ == 0 ? !add_edge(a, b, cache) : !add_corners(a, b, cache)) return false;
      contacts_[size_] = &contact;
      ++size_;
      return true;
    }

   private:
    friend ClassifiedOverlap;
    [[nodiscard]] bool add_edge(Ring a, Ring b, const Cache& cache) {
      const Ring ring = cache.of_b ? b : a;
      const Ring other = cache.of_b ? a : b;
      if (!cache.entry.fits(ring, other)) return false;
      edges_[size_] = {ring.data(), other.data(), &cache.entry};
      signs_[size_] = cache.of_b ? -1 : 1;
      return true;
    }
    [[nodiscard]] bool add_corners(Ring a, Ring b, const Cache& cache) {
      if (kind_ == kinds || !fits(a, b, cache)) return false;
      corners_[size_] = query(a, b, cache);
      return true;
    }

    std::size_t size_ = 0;
    std::size_t kind_ = 0;
    std::array<CornerEdgeQuery, capacity> edges_;
    std::array<double, capacity> signs_;
    std::array<CornerCornerQuery, capacity> corners_;
    std::array<ContactGeometry*, capacity> contacts_;
  };
  /// Evaluates a full batch.
  [[nodiscard]] unsigned find(const Batch& batch) const {
    unsigned found = 0;
    if (batch.kind_ == 0) {
      find_corner_edge_overlaps<native_lanes, Model::template Edge>(
          batch.edges_, [&](std::size_t l, const auto& overlap) __attribute__((always_inline)) {
            *batch.contacts_[l] = Model::of_edge(overlap, batch.signs_[l]);
            found |= 1U << l;
          });
    } else {
      find_corner_corner_overlaps<native_lanes, Model::template Corners>(
          batch.corners_, [&](std::size_t l, const auto& overlap) __attribute__((always_inline)) {
            *batch.contacts_[l] = Model::of_corners(overlap);
            found |= 1U << l;
          });
    }
    return found;
  }

  /// Lower bound on the distance of the rings at the last evaluation without a contact [m].
  [[nodiscard]] double clearance(const Cache& cache) const { return cache.separating.gap; }

 private:
  // Far above round-off: clipping would find the same crossings, so that closed forms and clipping
  // agree on the class of the overlap.
  [[nodiscard]] static double margin(Ring a, Ring b) {
    const auto across = [](Ring ring) {
      const Vec2& p = ring[0];
      const Vec2& q = ring[ring.size() / 2];
      return std::abs(p.x() - q.x()) + std::abs(p.y() - q.y());
    };
    return 1e-8 * (across(a) + across(b));
  }

  [[nodiscard]] static std::optional<ContactGeometry> corner_edge_contact(Ring a, Ring b,
                                                                          const Cache& cache) {
    const auto overlap = corner_edge_overlap<Model::template Edge>(cache.of_b ? b : a,
                                                                   cache.of_b ? a : b, cache.entry);
    if (!overlap) return std::nullopt;
    return Model::of_edge(*overlap, cache.of_b ? -1 : 1);
  }

  [[nodiscard]] static bool fits(Ring a, Ring b, const Cache& cache) {
    return cache.corner_a < a.size() && cache.corner_b < b.size();
  }
  [[nodiscard]] static CornerCornerQuery query(Ring a, Ring b, const Cache& cache) {
    return {a, b, cache.corner_a, cache.corner_b, margin(a, b)};
  }
  [[nodiscard]] static std::optional<ContactGeometry> corner_corner_contact(Ring a, Ring b,
                                                                            const Cache& cache) {
    if (!fits(a, b, cache)) return std::nullopt;
    const auto overlap = corner_corner_overlap<Model::template Corners>(query(a, b, cache));
    if (!overlap) return std::nullopt;
    return Model::of_corners(*overlap);
  }

  // Classifies the overlap for the next call. Rings are clipped in an order that does not depend on
  // that of the arguments; closed forms take them as they come, as the next call will.
  [[nodiscard]] static std::optional<ContactGeometry> by_clipping(Ring a, Ring b, Cache& cache) {
    const bool swapped = internal::comes_first(b, a);
    const Ring first = swapped ? b : a;
    const Ring second = swapped ? a : b;
    const CommonPart common = common_part(first, second);
    // Where rings barely meet, round-off must not decide between clipping and a separating edge.
    if (common.empty() || common.area <= 1e-9 * common.size * common.size) {
      cache.state = Cache::State::apart;
      cache.separating.gap = 0;
      const bool apart = find_separating_edge(first, second, cache.separating);
      cache.separating.of_b = cache.separating.of_b != swapped;
      if (apart || common.empty()) return std::nullopt;
    }
    if (const auto entry = common.entry(first.size(), second.size())) {
      cache.state = Cache::State::corner_edge;
      cache.of_b = entry->of_b != swapped;
      cache.entry = entry->place;
      if (auto contact = corner_edge_contact(a, b, cache)) return contact;
    }
    if (const auto corners = common.corners()) {
      cache.state = Cache::State::corner_corner;
      cache.corner_a = swapped ? corners->second : corners->first;
      cache.corner_b = swapped ? corners->first : corners->second;
      if (auto contact = corner_corner_contact(a, b, cache)) return contact;
    }
    cache.state = Cache::State::general;
    ContactGeometry contact = Model::of_common_part(first, second, common);
    if (swapped) contact.normal = -contact.normal;
    return contact;
  }
};

}  // namespace riprap
