#pragma once
/// @file
/// All pairs near each other, their contacts and the forces in them, kept from step to step.

#include <algorithm>
#include <optional>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include <riprap/contact/law/concepts.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/neighbour_search.hpp>
#include <riprap/contact/plane.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A pair of neighbours and, while they touch, their contact.
template <class History, class Memory, class Image = OpenPlane::Image>
struct Contact {
  BodyIndex a = 0;  ///< a < b
  BodyIndex b = 0;
  [[no_unique_address]] Image image{};  ///< the copy of b that a meets, in a periodic plane
  bool touching = false;
  bool at_platen = false;  ///< one of the two is a platen
  Memory memory{};
  // What follows has a meaning only while touching.
  ContactGeometry geometry{};
  History history{};
  ContactForce force{};
  /// Contact point minus centroid of a, when the force was evaluated [m]; zero for a platen, which
  /// begins where it is touched.
  Vec2 arm_a{0, 0};
  Vec2 arm_b{0, 0};

  /// Force on b [N]; a gets the opposite.
  [[nodiscard]] Vec2 force_on_b() const {
    return force.normal * geometry.normal + force.tangential * geometry.tangent();
  }
  /// From the centroid of a to that of b [m].
  [[nodiscard]] Vec2 branch() const { return arm_a - arm_b; }
};

/// Keeps the pairs that the broad phase finds, sorted by (a, b): forces are summed in that order,
/// whatever the broad phase. Histories live as long as their contact. In a periodic plane a pair is
/// a body and one image of another, so that two bodies may be several pairs.
template <BroadPhase Broad, NarrowPhase Narrow, ContactLaw Law, class Plane = OpenPlane>
class ContactList {
 public:
  using Image = typename Plane::Image;
  using ContactType = Contact<typename Law::History, typename Narrow::Memory, Image>;

  ContactList(Broad broad, Narrow narrow, Law law)
      : neighbours_(std::move(broad)), narrow_(std::move(narrow)), law_(std::move(law)) {
    riprap::validate(law_);
  }

  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] Law& law() { return law_; }

  /// The plane as of the coming update.
  void set_plane(const Plane& plane) { plane_ = plane; }
  [[nodiscard]] const Plane& plane() const { return plane_; }

  /// Every pair near each other, touching or not, sorted by (a, b, image).
  [[nodiscard]] std::span<const ContactType> pairs() const { return pairs_; }

  /// Calls `visit(contact)` for every pair that touches, in order.
  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    for (const ContactType& contact : pairs_)
      if (contact.touching) visit(contact);
  }

  /// Velocity of b's image relative to a at their contact [m/s].
  [[nodiscard]] Vec2 relative_velocity(const ContactType& contact,
                                       const Particles& particles) const {
    Vec2 relative = particles.body(contact.b).velocity_at(contact.arm_b) -
                    particles.body(contact.a).velocity_at(contact.arm_a);
    if constexpr (Plane::periodic) relative += plane_.velocity(contact.image);
    return relative;
  }

  /// Power that the shrinking of a periodic plane puts into the bodies [W]: it carries images
  /// along.
  [[nodiscard]] double image_power() const {
    double sum = 0;
    if constexpr (Plane::periodic)
      for_each_touching(
          [&](const auto& c) { sum -= c.force_on_b().dot(plane_.velocity(c.image)); });
    return sum;
  }

  /// Energy lost in sliding and in dashpots since the start [J].
  [[nodiscard]] double slipped() const { return slipped_; }
  [[nodiscard]] double damped() const { return damped_; }

  /// Finds contacts and forces at the present poses and sums them into the bodies' wrenches.
  /// @param time_step [s] of the motion that led here; zero to re-evaluate without motion
  void update(Particles& particles, double time_step) {
    if (neighbours_.stale(particles, plane_)) rebuild(particles);
    for (Body& body : particles.bodies()) body.contact = Wrench{};
    for (ContactType& contact : pairs_) evaluate(contact, particles, time_step);
  }

  /// Has the pairs found anew at the next update, whatever has moved.
  void invalidate() { neighbours_.invalidate(); }

  /// After the particle at `parent` has broken: the piece there now keeps the contacts, but those
  /// with `of_second(point)` go to the piece at `second`, histories and all. Call update
  /// afterwards.
  template <class OfSecond>
  void divide(BodyIndex parent, BodyIndex second, OfSecond&& of_second) {
    for (ContactType& contact : pairs_) {
      if (!contact.touching || (contact.a != parent && contact.b != parent)) continue;
      if (!of_second(contact.a == parent ? contact.geometry.point : point_at_b(contact))) continue;
      if (contact.a == parent) {
        // The new piece has the highest index: it becomes b. Tangential forces keep their sign, for
        // normal, tangent and roles all turn round.
        contact.geometry.point = point_at_b(contact);
        contact.a = contact.b;
        contact.geometry.normal = -contact.geometry.normal;
        if constexpr (Plane::periodic) contact.image = -contact.image;
      }
      contact.b = second;
    }
    invalidate();
  }

 private:
  [[nodiscard]] Vec2 image_offset(const ContactType& contact) const {
    if constexpr (Plane::periodic)
      return plane_.offset(contact.image);
    else
      return {0, 0};
  }
  // The contact point where b itself is, not its image.
  [[nodiscard]] Vec2 point_at_b(const ContactType& contact) const {
    return contact.geometry.point - image_offset(contact);
  }

  void rebuild(const Particles& particles) {
    std::swap(pairs_, old_pairs_);
    pairs_.clear();
    neighbours_.visit_pairs(particles, plane_,
                            [this](BodyIndex a, BodyIndex b, const Image& image) {
                              pairs_.emplace_back();
                              pairs_.back().a = a;
                              pairs_.back().b = b;
                              pairs_.back().image = image;
                            });
    const auto by_bodies = [](const ContactType& p, const ContactType& q) {
      return std::tie(p.a, p.b, p.image) < std::tie(q.a, q.b, q.image);
    };
    std::sort(pairs_.begin(), pairs_.end(), by_bodies);
    std::sort(old_pairs_.begin(), old_pairs_.end(), by_bodies);
    auto old = old_pairs_.begin();
    for (ContactType& pair : pairs_) {
      while (old != old_pairs_.end() && by_bodies(*old, pair)) ++old;
      if (old != old_pairs_.end() && !by_bodies(pair, *old)) pair = *old;
    }
  }

  // The ring that a meets: b's, or its image's.
  [[nodiscard]] Ring ring_of_b(const ContactType& contact, const Particles& particles) {
    const Ring ring = particles.ring(contact.b);
    if constexpr (Plane::periodic) {
      if (contact.image == Image{}) return ring;
      const Vec2 offset = plane_.offset(contact.image);
      image_ring_.clear();
      for (const Vec2& v : ring) image_ring_.push_back(v + offset);
      return image_ring_;
    }
    return ring;
  }

  void evaluate(ContactType& contact, Particles& particles, double time_step) {
    Body& a = particles.body(contact.a);
    Body& b = particles.body(contact.b);
    const std::optional<ContactGeometry> geometry =
        narrow_(particles.ring(contact.a), ring_of_b(contact, particles), contact.memory);
    if (!geometry) {
      contact.touching = false;
      return;
    }
    if (!contact.touching) contact.history = typename Law::History{};
    contact.touching = true;
    contact.geometry = *geometry;
    contact.at_platen = a.motion == Motion::platen || b.motion == Motion::platen;
    contact.arm_a = geometry->point - a.position;
    contact.arm_b = point_at_b(contact) - b.position;
    if (contact.at_platen) (a.motion == Motion::platen ? contact.arm_a : contact.arm_b) = {0, 0};
    const Vec2 relative = relative_velocity(contact, particles);
    const ContactMotion motion{.normal_velocity = relative.dot(geometry->normal),
                               .tangential_velocity =
                                   contact.at_platen ? 0 : relative.dot(geometry->tangent()),
                               .time_step = time_step,
                               .effective_mass = effective_mass(a, b)};
    contact.force = law_(contact.geometry, motion, contact.history);
    slipped_ += contact.force.slipped;
    damped_ += contact.force.damped;
    const Vec2 on_b = contact.force_on_b();
    b.contact.force += on_b;
    b.contact.moment += cross(contact.arm_b, on_b);
    a.contact.force -= on_b;
    a.contact.moment -= cross(contact.arm_a, on_b);
  }

  [[nodiscard]] static double effective_mass(const Body& a, const Body& b) {
    if (!a.is_free()) return b.mass_scaling * b.mass;
    if (!b.is_free()) return a.mass_scaling * a.mass;
    const double p = a.mass_scaling * a.mass;
    const double q = b.mass_scaling * b.mass;
    return p * q / (p + q);
  }

  NeighbourSearch<Broad, Plane> neighbours_;
  Narrow narrow_;
  Law law_;
  [[no_unique_address]] Plane plane_{};
  std::vector<ContactType> pairs_;
  std::vector<ContactType> old_pairs_;
  std::vector<Vec2> image_ring_;
  double slipped_ = 0;
  double damped_ = 0;
};

}  // namespace riprap
