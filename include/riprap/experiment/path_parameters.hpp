// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The parameters of a loading path by name: a checkpoint of one path is not one of another.

#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include <riprap/core/compiler.hpp>

namespace riprap::internal {

/// Which control or condition it is.
template <class Variant>
[[nodiscard]] std::string kind_of(const Variant& variant) {
  return std::visit(
      [&]<class Part>(const Part&) -> std::string {
        if constexpr (requires { std::string(Part::name); }) return Part::name;
        return "number " + std::to_string(variant.index());
      },
      variant);
}

/// That, and its parameters, under names that begin with `prefix`.
/// @param values whether also those that are numbers: a target may be another one
template <class Variant, class Visit>
void name_part(const std::string& prefix, const Variant& variant, bool values, Visit& visit) {
  visit(prefix.c_str(), kind_of(variant));
  std::visit(
      [&]<class Part>(const Part& part) {
        const auto visit_one = [&]<class Value>(const char* name, const Value& value) {
          if (values || std::is_enum_v<Value>) visit((prefix + '_' + name).c_str(), value);
        };
        if constexpr (requires { Part::for_each_parameter(part, visit_one); })
          Part::for_each_parameter(part, visit_one);
        if constexpr (requires { part.parts.size(); })
          for (std::size_t k = 0; k < part.parts.size(); ++k)
            name_part(prefix + '_' + std::to_string(k), part.parts[k], values, visit);
      },
      variant);
}

/// All of the stages but how far the last one goes: the targets of its end, and its most steps.
template <class StageT, class Visit>
void name_path_parameters(const std::vector<StageT>& stages, Visit& visit) {
  for (std::size_t k = 0; k < stages.size(); ++k) {
    const StageT& stage = stages[k];
    const bool is_last = k + 1 == stages.size();
    const std::string prefix = "stage_" + std::to_string(k) + '_';
    visit((prefix + "name").c_str(), stage.name);
    visit((prefix + "part").c_str(), stage.part);
    name_part(prefix + "axis_1", stage.axis_1, true, visit);
    name_part(prefix + "axis_2", stage.axis_2, true, visit);
    name_part(prefix + "end", stage.end, !is_last, visit);
    StageT::for_each_parameter(stage, [&](const char* name, const auto& value) {
      if (!is_last || std::string_view(name) != "most_steps") visit((prefix + name).c_str(), value);
    });
  }
}

}  // namespace riprap::internal
