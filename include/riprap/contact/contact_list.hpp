#pragma once
/// @file
/// All pairs near each other, their contacts and the forces in them, kept from step to step.

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/broad_phase/concepts.hpp>
#include <riprap/contact/law/concepts.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A pair of neighbours and, while they touch, their contact.
template <class History, class Memory>
struct Contact {
  BodyIndex a = 0;  ///< a < b
  BodyIndex b = 0;
  bool touching = false;
  Memory memory{};
  // What follows has a meaning only while touching.
  ContactGeometry geometry{};
  History history{};
  ContactForce force{};
  Vec2 arm_a{0, 0};  ///< contact point minus centroid of a, when the force was evaluated [m]
  Vec2 arm_b{0, 0};

  /// Force on b [N]; a gets the opposite.
  [[nodiscard]] Vec2 force_on_b() const {
    return force.normal * geometry.normal + force.tangential * geometry.tangent();
  }
  /// From the centroid of a to that of b [m].
  [[nodiscard]] Vec2 branch() const { return arm_a - arm_b; }
};

/// Keeps the pairs that the broad phase finds, sorted by (a, b): forces are summed in that order,
/// whatever the broad phase. Histories live as long as their contact.
template <BroadPhase Broad, NarrowPhase Narrow, ContactLaw Law>
class ContactList {
 public:
  using ContactType = Contact<typename Law::History, typename Narrow::Memory>;

  ContactList(Broad broad, Narrow narrow, Law law)
      : broad_(std::move(broad)), narrow_(std::move(narrow)), law_(std::move(law)) {
    riprap::validate(law_);
  }

  [[nodiscard]] const Law& law() const { return law_; }
  [[nodiscard]] Law& law() { return law_; }

  /// Every pair near each other, touching or not, sorted by (a, b).
  [[nodiscard]] std::span<const ContactType> pairs() const { return pairs_; }

  /// Calls `visit(contact)` for every pair that touches, in order.
  template <class Visit>
  void for_each_touching(Visit&& visit) const {
    for (const ContactType& contact : pairs_)
      if (contact.touching) visit(contact);
  }

  /// Energy lost in sliding and in dashpots since the start [J].
  [[nodiscard]] double slipped() const { return slipped_; }
  [[nodiscard]] double damped() const { return damped_; }

  /// Finds contacts and forces at the present poses and sums them into the bodies' wrenches.
  /// @param time_step [s] of the motion that led here; zero to re-evaluate without motion
  void update(Particles& particles, double time_step) {
    if (stale(particles)) rebuild(particles);
    for (Body& body : particles.bodies()) body.contact = Wrench{};
    for (ContactType& contact : pairs_) evaluate(contact, particles, time_step);
  }

  /// Has the pairs found anew at the next update, whatever has moved.
  void invalidate() { built_for_.clear(); }

  /// After the particle at `parent` has broken: the piece there now keeps the contacts, but those
  /// with `of_second(point)` go to the piece at `second`, histories and all. Call update
  /// afterwards.
  template <class OfSecond>
  void divide(BodyIndex parent, BodyIndex second, OfSecond&& of_second) {
    for (ContactType& contact : pairs_) {
      if (!contact.touching || (contact.a != parent && contact.b != parent)) continue;
      if (!of_second(contact.geometry.point)) continue;
      if (contact.a == parent) {
        // The new piece has the highest index: it becomes b. Tangential forces keep their sign, for
        // normal, tangent and roles all turn round.
        contact.a = contact.b;
        contact.geometry.normal = -contact.geometry.normal;
      }
      contact.b = second;
    }
    invalidate();
  }

 private:
  struct Pose {
    Vec2 position;
    Rotation rotation;
  };

  [[nodiscard]] bool stale(const Particles& particles) const {
    if (built_for_.size() != particles.size()) return true;
    for (std::size_t i = 0; i < built_for_.size(); ++i) {
      const auto index = static_cast<BodyIndex>(i);
      const Body& body = particles.body(index);
      const Vec2 shift = body.position - built_for_[i].position;
      const double dc = body.rotation.cosine - built_for_[i].rotation.cosine;
      const double ds = body.rotation.sine - built_for_[i].rotation.sine;
      const double reach = particles.shape(index).circumradius;
      // (p + q)^2 <= 2 (p^2 + q^2): no root needed to bound the way of the farthest vertex.
      if (2 * (shift.dot(shift) + reach * reach * (dc * dc + ds * ds)) > allowance_squared_)
        return true;
    }
    return false;
  }

  void rebuild(const Particles& particles) {
    double mean_radius = 0;
    for (std::size_t i = 0; i < particles.size(); ++i)
      mean_radius += particles.shape(static_cast<BodyIndex>(i)).circumradius;
    const double skin =
        2 * broad_.relative_skin * mean_radius / static_cast<double>(particles.size());
    allowance_squared_ = 0.25 * skin * skin;

    boxes_.clear();
    built_for_.clear();
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const auto index = static_cast<BodyIndex>(i);
      Box box{Vec2::Constant(std::numeric_limits<double>::infinity()),
              Vec2::Constant(-std::numeric_limits<double>::infinity())};
      for (const Vec2& v : particles.ring(index)) {
        box.low = box.low.cwiseMin(v);
        box.high = box.high.cwiseMax(v);
      }
      box.low.array() -= 0.5 * skin;
      box.high.array() += 0.5 * skin;
      boxes_.push_back(box);
      built_for_.push_back({particles.body(index).position, particles.body(index).rotation});
    }

    std::swap(pairs_, old_pairs_);
    pairs_.clear();
    broad_.visit_pairs(std::span<const Box>(boxes_), [&](BodyIndex i, BodyIndex j) {
      if (!particles.body(i).is_free() && !particles.body(j).is_free()) return;
      ContactType pair;
      pair.a = std::min(i, j);
      pair.b = std::max(i, j);
      pairs_.push_back(pair);
    });
    const auto by_bodies = [](const ContactType& p, const ContactType& q) {
      return std::pair(p.a, p.b) < std::pair(q.a, q.b);
    };
    std::sort(pairs_.begin(), pairs_.end(), by_bodies);
    std::sort(old_pairs_.begin(), old_pairs_.end(), by_bodies);
    auto old = old_pairs_.begin();
    for (ContactType& pair : pairs_) {
      while (old != old_pairs_.end() && by_bodies(*old, pair)) ++old;
      if (old != old_pairs_.end() && !by_bodies(pair, *old)) pair = *old;
    }
  }

  void evaluate(ContactType& contact, Particles& particles, double time_step) {
    Body& a = particles.body(contact.a);
    Body& b = particles.body(contact.b);
    const std::optional<ContactGeometry> geometry =
        narrow_(particles.ring(contact.a), particles.ring(contact.b), contact.memory);
    if (!geometry) {
      contact.touching = false;
      return;
    }
    if (!contact.touching) contact.history = typename Law::History{};
    contact.touching = true;
    contact.geometry = *geometry;
    contact.arm_a = geometry->point - a.position;
    contact.arm_b = geometry->point - b.position;
    const Vec2 relative = b.velocity_at(contact.arm_b) - a.velocity_at(contact.arm_a);
    const ContactMotion motion{.normal_velocity = relative.dot(geometry->normal),
                               .tangential_velocity = relative.dot(geometry->tangent()),
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

  Broad broad_;
  Narrow narrow_;
  Law law_;
  std::vector<ContactType> pairs_;
  std::vector<ContactType> old_pairs_;
  std::vector<Box> boxes_;
  std::vector<Pose> built_for_;
  double allowance_squared_ = 0;
  double slipped_ = 0;
  double damped_ = 0;
};

}  // namespace riprap
