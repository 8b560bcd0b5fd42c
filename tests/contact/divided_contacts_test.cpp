// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/divided_contacts.hpp>

#include <doctest/doctest.h>

#include <map>
#include <utility>
#include <vector>

#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/particle/domain.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

struct NoCache {};

template <class Law>
using ContactOf = Contact<typename Law::History, NoCache>;

// A touching pair with its point at x.
template <class Law>
ContactOf<Law> touching(BodyIndex a, BodyIndex b, double x, double tangential, double area = 1e-6) {
  ContactOf<Law> contact;
  contact.a = a;
  contact.b = b;
  contact.touching = true;
  contact.geometry.point = {x, 0};
  contact.geometry.depth = 1e-4;
  contact.geometry.area = area;
  contact.history.tangential_force = tangential;
  return contact;
}

// Pairs by their bodies.
template <class Law>
struct Pieces {
  std::map<std::pair<BodyIndex, BodyIndex>, ContactOf<Law>> pairs;

  void add(BodyIndex a, BodyIndex b, double area) {
    ContactOf<Law>& pair = pairs[{a, b}];
    pair = touching<Law>(a, b, 0, 0);
    pair.geometry.area = area;
  }
  [[nodiscard]] auto find() {
    return [this](const ContactOf<Law>& of) -> ContactOf<Law>* {
      const auto found = pairs.find({of.a, of.b});
      return found == pairs.end() ? nullptr : &found->second;
    };
  }
};

template <class ContactType, class Domain, class OfSecond>
void record_break(DividedContacts<ContactType>& divided, BodyIndex parent, BodyIndex second,
                  const std::vector<ContactType>& contacts, const Domain& domain,
                  OfSecond&& of_second) {
  for (const ContactType& contact : contacts)
    if (contact.a == parent || contact.b == parent) divided.add(contact);
  divided.divide(parent, second, domain, of_second);
}

const auto right_half = [](const Vec2& point) { return point.x() > 0; };

}  // namespace

TEST_CASE("without a rule of the law the piece at the point gets the history") {
  using Law = LinearSpringCoulomb;
  DividedContacts<ContactOf<Law>> divided;
  CHECK(divided.empty());
  record_break(divided, 1, 3,
               std::vector{touching<Law>(0, 1, -0.5, 7), touching<Law>(1, 2, 0.5, 8),
                           touching<Law>(0, 2, 0.5, 9)},
               UnboundedDomain{}, right_half);
  CHECK(!divided.empty());
  Pieces<Law> pieces;
  for (const auto& [a, b] : {std::pair{0U, 1U}, {0U, 3U}, {1U, 2U}, {2U, 3U}, {0U, 2U}})
    pieces.add(a, b, 1e-6);
  divided.hand_over(Law{}, pieces.find());
  CHECK(divided.empty());
  const auto history = [&](BodyIndex a, BodyIndex b) {
    return pieces.pairs.at({a, b}).history.tangential_force;
  };
  CHECK(history(0, 1) == 7);
  CHECK(history(0, 3) == 0);
  CHECK(history(1, 2) == 0);
  CHECK(history(2, 3) == 8);
  CHECK(history(0, 2) == 0);  // not of the particle that broke
}

TEST_CASE("pieces share a contact by the areas of their overlaps") {
  using Law = EnergyConservingSpring;
  DividedContacts<ContactOf<Law>> divided;
  record_break(divided, 1, 3, std::vector{touching<Law>(0, 1, -0.5, 100, 4e-6)}, UnboundedDomain{},
               right_half);
  Pieces<Law> pieces;
  pieces.add(0, 1, 3e-6);
  pieces.add(0, 3, 1e-6);
  divided.hand_over(Law{}, pieces.find());
  const auto& first = pieces.pairs.at({0, 1}).history;
  const auto& second = pieces.pairs.at({0, 3}).history;
  CHECK(first.tangential_force == near_relative(75, 1e-14));
  CHECK(second.tangential_force == near_relative(25, 1e-14));
  // Equal depths and gradients: the forces are shares, too.
  CHECK(1e-4 - first.offset == near_relative(0.75e-4, 1e-12));
  CHECK(1e-4 - second.offset == near_relative(0.25e-4, 1e-12));
}

TEST_CASE("of a part that is cut off, histories by the point are lost") {
  using Law = LinearSpringCoulomb;
  DividedContacts<ContactOf<Law>> divided;
  const std::vector pairs{touching<Law>(0, 1, -0.5, 7), touching<Law>(1, 2, 0.5, 8)};
  for (const auto& contact : pairs) divided.add(contact);
  divided.cut_off(1, UnboundedDomain{}, right_half);
  Pieces<Law> pieces;
  pieces.add(0, 1, 1e-6);
  pieces.add(1, 2, 1e-6);
  divided.hand_over(Law{}, pieces.find());
  CHECK(pieces.pairs.at({0, 1}).history.tangential_force == 7);
  CHECK(pieces.pairs.at({1, 2}).history.tangential_force == 0);
}

TEST_CASE("of a contact, one body is cut off and the other breaks, in either order") {
  using Law = EnergyConservingSpring;
  for (const bool cut_off_first : {true, false}) {
    CAPTURE(cut_off_first);
    DividedContacts<ContactOf<Law>> divided;
    const auto contact = touching<Law>(0, 1, 0.5, 100, 4e-6);
    const auto cut = [&] {
      divided.add(contact);
      divided.cut_off(0, UnboundedDomain{}, right_half);
    };
    if (cut_off_first) cut();
    record_break(divided, 1, 2, std::vector{contact}, UnboundedDomain{}, right_half);
    if (!cut_off_first) cut();
    Pieces<Law> pieces;
    pieces.add(0, 1, 1e-6);
    pieces.add(0, 2, 2e-6);
    divided.hand_over(Law{}, pieces.find());
    // A quarter of the overlap was with the part that is lost.
    CHECK(pieces.pairs.at({0, 1}).history.tangential_force == near_relative(25, 1e-14));
    CHECK(pieces.pairs.at({0, 2}).history.tangential_force == near_relative(50, 1e-14));
  }
}

TEST_CASE("of a contact whose bodies both break, four pieces share") {
  using Law = EnergyConservingSpring;
  const std::vector pairs{touching<Law>(0, 1, 0.5, 100, 1e-5)};
  DividedContacts<ContactOf<Law>> divided;
  record_break(divided, 0, 2, pairs, UnboundedDomain{}, right_half);
  record_break(divided, 1, 3, pairs, UnboundedDomain{}, right_half);
  Pieces<Law> pieces;
  pieces.add(0, 1, 1e-6);
  pieces.add(1, 2, 2e-6);
  pieces.add(0, 3, 3e-6);
  pieces.add(2, 3, 4e-6);
  divided.hand_over(Law{}, pieces.find());
  double total = 0;
  for (const auto& [bodies, pair] : pieces.pairs) {
    CHECK(pair.history.tangential_force == near_relative(1e7 * pair.geometry.area, 1e-12));
    total += pair.history.tangential_force;
  }
  CHECK(total == near_relative(100, 1e-12));
}

TEST_CASE("a particle that breaks twice hands its contacts on") {
  using Law = LinearSpringCoulomb;
  const std::vector pairs{touching<Law>(0, 1, 0.5, 5)};
  DividedContacts<ContactOf<Law>> divided;
  record_break(divided, 1, 2, pairs, UnboundedDomain{}, right_half);
  record_break(divided, 2, 3, pairs, UnboundedDomain{},
               [](const Vec2& point) { return point.x() > 0.4; });
  Pieces<Law> pieces;
  for (const BodyIndex b : {1U, 2U, 3U}) pieces.add(0, b, 1e-6);
  divided.hand_over(Law{}, pieces.find());
  CHECK(pieces.pairs.at({0, 1}).history.tangential_force == 0);
  CHECK(pieces.pairs.at({0, 2}).history.tangential_force == 0);
  CHECK(pieces.pairs.at({0, 3}).history.tangential_force == 5);
}

TEST_CASE("a contact across a periodic cell follows the image of the piece") {
  using Law = LinearSpringCoulomb;
  using Domain = PeriodicDomain;
  using Periodic = Contact<Law::History, NoCache, Domain::Image>;
  Periodic contact;
  contact.a = 0;
  contact.b = 1;
  contact.image = {1, 0};
  contact.touching = contact.crosses_boundary = true;
  contact.geometry.area = 1e-6;
  contact.geometry.point = {10.2, 0};
  contact.history.tangential_force = 6;
  const Domain domain{.period = {10, 10}};
  // In the frame of b the point is at 0.2; in that of a, which breaks second, at 10.2.
  DividedContacts<Periodic> divided;
  std::vector<Vec2> asked;
  const auto note = [&](const Vec2& point) {
    asked.push_back(point);
    return true;
  };
  record_break(divided, 1, 2, std::vector{contact}, domain, note);
  record_break(divided, 0, 3, std::vector{contact}, domain, note);
  for (const auto& [body, x] : {std::pair{0U, 10.2}, {1U, 0.2}}) {
    DividedContacts<Periodic> reduced;
    reduced.add(contact);
    reduced.cut_off(body, domain, [x = x](const Vec2& point) {
      CHECK((point - Vec2{x, 0}).norm() <= 1e-14);
      return true;
    });
  }
  std::vector<Periodic> expected;
  divided.hand_over(Law{}, [&](const Periodic& of) -> Periodic* {
    expected.push_back(of);
    return nullptr;
  });
  REQUIRE(asked.size() == 3);  // the two parts of the first break are divided again
  CHECK((asked[0] - Vec2{0.2, 0}).norm() <= 1e-14);
  CHECK((asked[1] - Vec2{10.2, 0}).norm() <= 1e-14);
  REQUIRE(expected.size() == 4);
  for (const Periodic& of : expected) {
    CHECK(of.a < of.b);
    const bool turned = of.b == 3;
    CHECK(of.image == (turned ? Domain::Image{-1, 0} : Domain::Image{1, 0}));
    CHECK((of.geometry.point - Vec2{turned ? 0.2 : 10.2, 0}).norm() <= 1e-14);
  }
}
