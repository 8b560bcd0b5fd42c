// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/contact_sum.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include <riprap/core/random.hpp>
#include <support/fake_contacts.hpp>

using namespace riprap;

namespace {

// A list whose pairs know their tasks: 40 of 10 contacts each, two contacts a body.
struct ContactsInTasks : test::FakeContacts {
  [[nodiscard]] std::size_t tasks() const { return list.size() / 10; }
  template <class Visit>
  void for_each_touching_in(std::size_t task, Visit&& visit) const {
    for (std::size_t k = 10 * task; k < 10 * task + 10; ++k) visit(list[k]);
  }
};

struct LastTaskFirst {
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    for (std::size_t k = tasks; k-- > 0;) work(k);
  }
};

}  // namespace

TEST_CASE("a sum over contacts is plain in a body and exact over bodies, in whatever tasks") {
  Random random(1);
  ContactsInTasks contacts;
  for (BodyIndex k = 0; k < 400; ++k) {
    const double force = std::ldexp(random.uniform(-1, 1), static_cast<int>(k % 60));
    contacts.list.push_back(test::fake_contact(k / 2, 1000, {0, 0}, {1, 0}, {1, 0}, force, 1));
  }
  ExactSum expected;
  for (std::size_t k = 0; k < 400; k += 2)
    expected.add(contacts.list[k].force.normal + contacts.list[k + 1].force.normal);
  const auto values = [](const auto& c) { return std::array{c.force.normal, c.force.tangential}; };
  const auto sums = sum_over_contacts<2>(contacts, values);
  CHECK(sums[0] == expected.value());
  CHECK(sums[1] == 400);
  CHECK(sum_over_contacts<2>(contacts, values, LastTaskFirst{}) == sums);
  contacts.list.clear();
  CHECK(sum_over_contacts<1>(contacts, [](const auto&) { return std::array{1.0}; })[0] == 0);
}
