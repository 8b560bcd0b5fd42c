// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A contact law chosen at run time: one more model of the role, for programs with options.

#include <cstddef>
#include <variant>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/frictionless.hpp>
#include <riprap/contact/contact_law/with_friction.hpp>

namespace riprap {

/// Holds one of several contact laws, all of different types, and passes every question on to it. A
/// contact keeps the history of the chosen law and loses it when another is chosen.
template <ContactLaw... Laws>
struct ContactLawChoice {
  template <class Law>
  struct HistoryOf {
    typename Law::History history{};

    static void for_each_field(auto& self, auto&& visit) { visit("history", self.history); }
  };
  using History = std::variant<HistoryOf<Laws>...>;

  std::variant<Laws...> chosen;

  [[nodiscard]] ContactForce operator()(const ContactGeometry& geometry,
                                        const ContactMotion& motion, History& history) const {
    return std::visit(
        [&]<class Law>(const Law& law) -> ContactForce {
          if (!std::holds_alternative<HistoryOf<Law>>(history)) history = HistoryOf<Law>{};
          return law(geometry, motion, std::get<HistoryOf<Law>>(history).history);
        },
        chosen);
  }
  [[nodiscard]] double stored_energy(const ContactGeometry& geometry,
                                     const History& history) const {
    return std::visit(
        [&]<class Law>(const Law& law) -> double {
          const auto* own = std::get_if<HistoryOf<Law>>(&history);
          return law.stored_energy(geometry, own ? own->history : typename Law::History{});
        },
        chosen);
  }
  [[nodiscard]] History divided_history(const History& history, const ContactGeometry& geometry,
                                        const DividedContact& part) const {
    return std::visit(
        [&]<class Law>(const Law& law) -> History {
          const auto* own = std::get_if<HistoryOf<Law>>(&history);
          if (!own) return HistoryOf<Law>{};
          return HistoryOf<Law>{riprap::divided_history(law, own->history, geometry, part)};
        },
        chosen);
  }
  /// Of the chosen law; 0 for one that is the same for all materials.
  [[nodiscard]] std::size_t materials() const {
    return std::visit(
        [](const auto& law) -> std::size_t {
          if constexpr (requires { law.materials(); })
            return law.materials();
          else
            return 0;
        },
        chosen);
  }
  [[nodiscard]] History history_after_bond(const ContactGeometry& geometry,
                                           const FormerBond& bond) const {
    return std::visit(
        [&]<class Law>(const Law& law) -> History {
          return HistoryOf<Law>{riprap::history_after_bond(law, geometry, bond)};
        },
        chosen);
  }
  [[nodiscard]] double peak_stiffness() const {
    return std::visit([](const auto& law) -> double { return law.peak_stiffness(); }, chosen);
  }
  [[nodiscard]] ContactLawChoice frictionless() const {
    return std::visit([](const auto& law) { return ContactLawChoice{riprap::frictionless(law)}; },
                      chosen);
  }
  /// Throws InvalidInput for a law without friction, unless mu is 0.
  [[nodiscard]] ContactLawChoice with_friction(double mu) const {
    return std::visit(
        [mu]<class Law>(const Law& law) {
          if constexpr (FrictionalLaw<Law>) return ContactLawChoice{riprap::with_friction(law, mu)};
          require(mu == 0, "with_friction: friction", mu, "must be 0 for a law without friction");
          return ContactLawChoice{law};
        },
        chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }

  void validate() const {
    std::visit([](const auto& law) { riprap::validate(law); }, chosen);
  }
};

}  // namespace riprap
