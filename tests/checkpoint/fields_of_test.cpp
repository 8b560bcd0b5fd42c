// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <riprap/breakage/refused_cuts.hpp>
#include <riprap/checkpoint/fields_of.hpp>
#include <riprap/core/exact_sum.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/dynamics/boundary/strain_field.hpp>
#include <riprap/experiment/check_table.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/experiment/displacement_paths.hpp>
#include <riprap/experiment/incremental_displacement.hpp>
#include <riprap/experiment/loading_stage.hpp>
#include <riprap/experiment/wall_servo.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/simulation/external_loads.hpp>
#include <support/message_of.hpp>

using namespace riprap;

namespace {

enum class Colour : unsigned char { red, green };

struct Inner {
  double number = 0;
  std::vector<int> list{};
  std::string name{};
  std::optional<Vec2> place{};

  static void for_each_field(auto& self, auto&& visit) {
    visit("number", self.number);
    visit("list", self.list);
    visit("name", self.name);
    visit("place", self.place);
  }
};

struct Outer {
  std::vector<Inner> inners{};
  std::variant<int, Inner> choice{};
  std::vector<std::variant<int, Inner>> choices{};
  std::array<Inner, 2> pair_of_inners{};
  std::array<float, 3> numbers{};
  std::vector<std::vector<std::vector<double>>> deep{};
  std::pair<Colour, bool> pair{};
  std::vector<Vec2> points{};
  std::string text{};

  static void for_each_field(auto& self, auto&& visit) {
    visit("inners", self.inners);
    visit("choice", self.choice);
    visit("choices", self.choices);
    visit("pair_of_inners", self.pair_of_inners);
    visit("numbers", self.numbers);
    visit("deep", self.deep);
    visit("pair", self.pair);
    visit("points", self.points);
    visit("text", self.text);
  }
};

[[nodiscard]] Outer example() {
  Outer outer;
  outer.inners = {{1, {1, 2}, "x", Vec2{1, 2}}, {-0.0, {}, "yy", {}}, {3, {4}, "", Vec2{3, 4}}};
  outer.choice = Inner{5, {6}, "q", {}};
  outer.choices = {1, Inner{std::numeric_limits<double>::quiet_NaN(), {1}, "e", {}}, 3};
  outer.pair_of_inners[1] = {2, {}, "second", Vec2{5, 6}};
  outer.numbers = {1, 2, 3};
  outer.deep = {{{1, 2}, {3}}, {}, {{}, {4}}};
  outer.pair = {Colour::green, true};
  outer.points = {{1, 2}, {3, 4}};
  outer.text = "some text";
  return outer;
}

}  // namespace

TEST_CASE("An object is the same after its fields have been written to another one") {
  const Outer from = example();
  FieldNode fields = fields_of(from, "outer");
  const std::uint64_t before = digest(fields);
  Outer to;
  to.inners.resize(7);  // what was there is replaced
  to.choices = {Inner{}};
  read_fields(fields, to);
  CHECK(digest(fields_of(to, "outer")) == before);
  CHECK_FALSE(difference(fields_of(to, "outer"), fields_of(from, "outer")));
  CHECK(to.inners.size() == 3);
  CHECK(to.inners[1].name == "yy");
  CHECK(std::signbit(to.inners[1].number));
  CHECK(to.inners[2].place == Vec2{3, 4});
  CHECK(std::get<Inner>(to.choices[1]).list == std::vector{1});
  CHECK(to.deep == from.deep);
  CHECK(to.pair.first == Colour::green);
  CHECK(to.text == "some text");
}

TEST_CASE("An object without elements has no rows") {
  FieldNode fields = fields_of(Outer{}, "outer");
  Outer to = example();
  read_fields(fields, to);
  CHECK(to.inners.empty());
  CHECK(to.deep.empty());
  CHECK(to.points.empty());
  CHECK(to.text.empty());
}

TEST_CASE("A sequence of objects is an array of each of their fields") {
  FieldNode fields = fields_of(example(), "outer");
  FieldNode& inners = fields.child("inners");
  CHECK(inners.rows == 3);
  CHECK(inners.child("number").rows == 3);
  CHECK(inners.child("number").path == "outer/inners/number");
  CHECK(inners.child("list").child("start").rows == 3);
  CHECK(inners.child("list").child("values").rows == 3);  // 1, 2 and 4
  CHECK(fields.child("points").rows == 2);
  CHECK(fields.child("points").columns == 2);
  CHECK_FALSE(fields.child("choice").is_sequence);
}

TEST_CASE("The digest and the difference see every kind of change") {
  const FieldNode before = fields_of(example(), "outer");
  const auto is_seen = [&](auto&& change) {
    Outer other = example();
    change(other);
    const FieldNode after = fields_of(other, "outer");
    return digest(after) != digest(before) && difference(before, after).has_value();
  };
  CHECK(is_seen([](Outer& o) { o.inners[1].number = 0; }));  // was -0
  CHECK(is_seen([](Outer& o) { o.inners[1].name = "yz"; }));
  CHECK(is_seen([](Outer& o) { std::swap(o.inners[0].list, o.inners[1].list); }));
  CHECK(is_seen([](Outer& o) { o.inners[0].place.reset(); }));
  CHECK(is_seen([](Outer& o) { o.choice = 3; }));
  CHECK(is_seen([](Outer& o) { o.deep[2] = {{4}, {}}; }));
  CHECK(is_seen([](Outer& o) { o.pair.second = false; }));
  CHECK(is_seen([](Outer& o) { o.text += ' '; }));
  CHECK_FALSE(is_seen([](Outer&) {}));
}

TEST_CASE("A difference names the field and both values") {
  Outer other = example();
  other.pair.first = Colour::red;
  CHECK(difference(fields_of(example(), "outer"), fields_of(other, "outer")) ==
        "outer/pair/first is 1 in the file and 0 in the program");
  const FieldNode one = fields_of(Inner{}, "model", true);
  const FieldNode two = fields_of(Outer{}, "model", true);
  CHECK(test::contains(difference(one, two).value(), "Inner in the file and "));
}

TEST_CASE("Fields of another type are refused by name") {
  const auto message = [](auto&& spoil) {
    FieldNode fields = fields_of(example(), "outer");
    spoil(fields);
    Outer to;
    return test::message_of([&] { read_fields(fields, to); });
  };
  CHECK(message([](FieldNode&) {}).empty());
  CHECK(message([](FieldNode& f) { f.child("pair").path = "outer/other"; }) ==
        "outer has no field 'pair'");
  CHECK(message([](FieldNode& f) { f.child("points").columns = 1; }) ==
        "outer/points: numbers of another type or shape");
  CHECK(message([](FieldNode& f) { f.child("inners").child("number").number = NumberType::i64; }) ==
        "outer/inners/number: numbers of another type or shape");
  CHECK(message([](FieldNode& f) { f.child("inners").child("number").rows = 2; }) ==
        "outer/inners/number: too few numbers");
  CHECK(message([](FieldNode& f) {
          f.child("choice").child("alternative").bytes[0] = std::byte{7};
        }) == "outer/choice: no alternative 7");
  CHECK(message([](FieldNode& f) {
          f.child("inners").child("list").child("start").bytes[8] = std::byte{9};
        }) == "outer/inners/list/start: must be the numbers of values before");
  CHECK(message([](FieldNode& f) { f.child("text").kind = FieldNode::Kind::group; }) ==
        "outer/text: must be a text");
}

namespace {

struct Doubled {
  double number = 1;
  double twice = 2;  // derived
  static constexpr bool names_all_members = false;

  static void for_each_field(auto& self, auto&& visit) { visit("number", self.number); }
  void restored() { twice = 2 * number; }
};
struct Sum {
  std::vector<Doubled> parts{};
  double sum = 0;
  static constexpr bool names_all_members = false;

  static void for_each_field(auto& self, auto&& visit) { visit("parts", self.parts); }
  void restored() {
    sum = 0;
    for (const Doubled& part : parts) sum += part.twice;
  }
};

}  // namespace

TEST_CASE("What is derived is computed anew, of the parts before the whole") {
  Sum from;
  from.parts = {{3, 0}, {4, 0}};
  FieldNode fields = fields_of(from, "sum");
  Sum to;
  read_fields(fields, to);
  CHECK(to.sum == 0);
  restored(to);
  CHECK(to.sum == 14);
}

namespace {

struct Forgetful {
  double named = 1;
  Vec2 point{0, 0};
  std::vector<double> forgotten{};

  static void for_each_field(auto& self, auto&& visit) {
    visit("named", self.named);
    visit("point", self.point);
  }
};

// No aggregate, but one that says that it names everything.
class Careless {
 public:
  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) { visit("named", self.named_); }
  [[nodiscard]] double sum() const { return named_ + forgotten_; }

 private:
  double named_ = 1;
  double forgotten_ = 2;
};

}  // namespace

TEST_CASE("A member that is not named is found") {
  CHECK(test::contains(test::message_of([] { (void)fields_of(Forgetful{}, "f"); }),
                       "Forgetful names 24 of 48 bytes"));
  CHECK(Careless{}.sum() == 3);
  CHECK(test::contains(test::message_of([] { (void)fields_of(Careless{}, "c"); }),
                       "Careless names 8 of 16 bytes"));
}

namespace {

struct WithParameters {
  double parameter = 1;
  double state = 2;
  double more = 3;

  static void for_each_parameter(auto& self, auto&& visit) { visit("parameter", self.parameter); }
  static void for_each_field(auto& self, auto&& visit) { visit("state", self.state); }
};

template <class Part>
void check_named() {
  CHECK(test::message_of([] { (void)fields_of(Part{}, "part"); }).empty());
}
template <class... Parts>
void check_all_named(const std::variant<Parts...>*) {
  (check_named<Parts>(), ...);
}

}  // namespace

TEST_CASE("Parameters that are named apart from the state count as named") {
  CHECK(test::contains(test::message_of([] { (void)fields_of(WithParameters{}, "w"); }),
                       "WithParameters names 16 of 24 bytes"));
  check_all_named(static_cast<AxisControl*>(nullptr));
  check_all_named(static_cast<EndCondition*>(nullptr));
}

TEST_CASE("Classes of riprap that keep nothing derived name all of their members") {
  const auto must_name = []<class... Parts>(std::type_identity<Parts>...) {
    static_assert((internal::must_name_all<Parts>() && ...));
    (check_named<Parts>(), ...);
  };
  must_name(std::type_identity<EnergyLedger>{}, std::type_identity<ExactSum>{},
            std::type_identity<Curve>{}, std::type_identity<CheckTable>{},
            std::type_identity<DisplacementPaths>{}, std::type_identity<IncrementalDisplacement>{},
            std::type_identity<StrainField>{}, std::type_identity<RigidPlatens>{},
            std::type_identity<PeriodicCell>{}, std::type_identity<ExternalLoads>{},
            std::type_identity<RefusedCuts>{});
  CHECK(test::message_of([] { (void)fields_of(PressureServo(1, 1, 1), "servo"); }).empty());
  CHECK(test::message_of([] {
          (void)fields_of(WallServo(0, {0, 1}, 1, 1, 1, 1), "servo");
        }).empty());
}
