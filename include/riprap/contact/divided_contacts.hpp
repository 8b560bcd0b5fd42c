// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contacts of particles that have broken: hands their histories to the contacts of the pieces.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <riprap/contact/contact_forces.hpp>
#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/pair/contact.hpp>

namespace riprap {

/// Recorded break by break; handed over when the contacts of all pieces have been found.
template <class ContactType>
class DividedContacts {
 public:
  using History = decltype(ContactType::history);

  [[nodiscard]] bool empty() const { return parts_.empty(); }

  /// A contact of a particle that breaks.
  void add(const ContactType& contact) {
    if (is_recorded(contact)) return;
    parts_.push_back({contact, static_cast<std::uint32_t>(wholes_.size())});
    wholes_.push_back({contact.history, contact.geometry.area});
  }

  /// The particle at `parent`, all of whose contacts have been added, has lost a part.
  /// @param of_lost whether a point [m] lies on the side of that part
  template <class Domain, class OfLost>
  void cut_off(BodyIndex parent, const Domain& domain, OfLost&& of_lost) {
    for (Part& part : parts_)
      if (part.contact.a == parent || part.contact.b == parent)
        part.has_point &= !of_lost(point_on(part.contact, parent, domain));
  }

  /// The particle at `parent`, all of whose contacts have been added, has broken into a piece at
  /// the same index and one at `second`, above all others.
  /// @param of_second whether a point [m] lies on the side of the second piece
  template <class Domain, class OfSecond>
  void divide(BodyIndex parent, BodyIndex second, const Domain& domain, OfSecond&& of_second) {
    const std::size_t before = parts_.size();
    for (std::size_t i = 0; i < before; ++i) {
      if (parts_[i].contact.a != parent && parts_[i].contact.b != parent) continue;
      Part part = parts_[i];
      ContactType& contact = part.contact;
      ContactGeometry& geometry = contact.geometry;
      const bool by_point = of_second(point_on(contact, parent, domain));
      if (contact.a == parent) {
        // The new piece has the highest index: it becomes b. Tangential forces keep their sign.
        geometry.point = point_on(contact, contact.b, domain);
        geometry.normal = -geometry.normal;
        contact.a = contact.b;
        if constexpr (Domain::periodic) contact.image = -contact.image;
      }
      contact.b = second;
      part.has_point &= by_point;
      parts_[i].has_point &= !by_point;
      parts_.push_back(part);
    }
  }

  /// Gives each contact of a piece its part of the history of the contact that was divided.
  /// @param find returns the pair with the bodies and image of another one
  template <class Law, class Find>
  void hand_over(const Law& law, Find&& find) {
    for (const Part& part : parts_) {
      ContactType* const pair = find(part.contact);
      if (!pair) continue;
      const Whole& whole = wholes_[part.whole];
      const double share =
          whole.overlap > 0 ? std::min(1.0, pair->geometry.area / whole.overlap) : 0;
      pair->history = divided_history(law, whole.history, part.contact.geometry,
                                      {pair->geometry, share, part.has_point});
    }
    parts_.clear();
    wholes_.clear();
  }

 private:
  // The contact that a particle had before it broke.
  struct Whole {
    History history;
    double overlap = 0;  // [m^2]
  };
  // Its bodies, image and point for one of the pieces, which may not touch.
  struct Part {
    ContactType contact;
    std::uint32_t whole = 0;
    bool has_point = true;
  };

  // The contact's point where `body` is, and not its image.
  template <class Domain>
  [[nodiscard]] static Vec2 point_on(const ContactType& contact, BodyIndex body,
                                     const Domain& domain) {
    const Vec2 point = contact.geometry.point;
    return contact.a == body ? point : Vec2(point - image_offset(contact, domain));
  }

  [[nodiscard]] bool is_recorded(const ContactType& pair) const {
    return std::ranges::any_of(parts_, [&](const Part& part) {
      return part.contact.a == pair.a && part.contact.b == pair.b &&
             part.contact.image == pair.image;
    });
  }

  std::vector<Part> parts_;
  std::vector<Whole> wholes_;
};

}  // namespace riprap
