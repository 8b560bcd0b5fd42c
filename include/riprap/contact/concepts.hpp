// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What measurements, loads and screening use of a contact list.

#include <concepts>
#include <cstddef>
#include <cstdint>

#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/contact/pair/pair_map.hpp>

namespace riprap {

namespace requirements {

/// Stands for what is called with contacts.
struct ContactVisitor {
  template <class ContactType>
  void operator()(const ContactType&, std::size_t = 0) const {}
};

}  // namespace requirements

/// `contacts.for_each_touching(visit)` calls `visit(contact)` for every pair that touches, in
/// order.
template <class C>
concept TouchingContacts =
    requires(const C& contacts) { contacts.for_each_touching(requirements::ContactVisitor{}); };

/// Contacts that belong to a list of pairs: `pairs()`, all of them; `map()`, from the revision of
/// the list before to the present one; `index()`, the pairs of each body;
/// `for_each_touching_of(task, visit)` calls `visit(contact, index)` for every touching pair with a
/// body of a task of `for_each_task`, in order.
template <class C>
concept ListedContacts = requires(const C& contacts, std::size_t k) {
  { contacts.pairs()[k].touching } -> std::convertible_to<bool>;
  { contacts.map() } -> std::convertible_to<const PairMap&>;
  { contacts.index() } -> std::same_as<const PairIndex&>;
  contacts.for_each_touching_of(k, requirements::ContactVisitor{});
};

}  // namespace riprap
