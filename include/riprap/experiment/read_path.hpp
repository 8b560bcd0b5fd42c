// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads a loading path from a file.

#include <array>
#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/read_toml.hpp>
#include <riprap/experiment/loading_path.hpp>
#include <riprap/experiment/preparation.hpp>

namespace riprap {

namespace internal {

/// Whether a control or a condition can be read: it has a name and names its parameters, if any.
template <class T>
concept ReadFromFile =
    requires { std::string(T::name); } && (std::is_empty_v<T> || requires(T part) {
      T::for_each_parameter(part, [](const char*, auto&) {});
    });

/// Fills the parameters that a table has, under names that begin with `prefix`. Returns the names
/// of all.
template <class T>
std::string read_parameters(T& part, TomlTable& table, const std::string& prefix) {
  std::string all;
  if constexpr (!std::is_empty_v<T>)
    T::for_each_parameter(part, [&](const char* name, auto& value) {
      all += (all.empty() ? "" : ", ") + prefix + name;
      if (const TomlEntry* entry = table.find(prefix + name)) table.take(*entry, value);
    });
  return all;
}

/// The alternatives of a variant that can be read.
template <class Variant>
struct Readable;
template <class... T>
struct Readable<std::variant<T...>> {
  [[nodiscard]] static std::vector<std::string> names() {
    std::vector<std::string> names;
    ((ReadFromFile<T> ? names.push_back(name_of<T>()) : void()), ...);
    return names;
  }
  /// Makes `part` the alternative of a name and fills its parameters; returns their names.
  static std::string read(std::variant<T...>& part, const std::string& name, TomlTable& table,
                          const std::string& prefix) {
    std::string all;
    (read_if<T>(part, name, table, prefix, all), ...);
    return all;
  }

 private:
  template <class One>
  [[nodiscard]] static std::string name_of() {
    if constexpr (ReadFromFile<One>)
      return One::name;
    else
      return {};
  }
  template <class One>
  static void read_if(std::variant<T...>& part, const std::string& name, TomlTable& table,
                      const std::string& prefix, std::string& all) {
    if constexpr (ReadFromFile<One>)
      if (name == One::name) {
        One one{};
        all = read_parameters(one, table, prefix);
        part = std::move(one);
      }
  }
};

/// Reads PREFIX.KIND = "NAME" and the parameters of what has this name. Returns the names of all
/// keys.
template <class Variant>
std::string read_part(Variant& part, TomlTable& table, const std::string& prefix,
                      const std::string& kind) {
  const std::string key = prefix + "." + kind;
  const TomlEntry* entry = table.find(key);
  if (entry == nullptr) table.fail(table.line, "[[" + table.name + "]] has no " + key);
  const auto names = Readable<Variant>::names();
  const std::size_t place = table.place_in(*entry, names);
  const std::string keys = Readable<Variant>::read(part, names[place], table, prefix + ".");
  return key + (keys.empty() ? "" : ", " + keys);
}

/// Throws InvalidInput for the first entry that nothing has asked for.
inline void refuse_unused(const TomlTable& table, const std::string& keys) {
  for (const TomlEntry& entry : table.entries)
    if (!entry.used) table.fail(entry, "the name is none of " + keys);
}

/// The rules of an object, with the line of its table.
template <class T>
void validate_at(const T& object, const TomlTable& table) {
  try {
    object.validate();
  } catch (const InvalidInput& error) {
    table.fail(table.line, error.what());
  }
}

template <class StageT>
[[nodiscard]] StageT read_stage(TomlTable& table) {
  StageT stage;
  const TomlEntry* name = table.find("name");
  if (name == nullptr) table.fail(table.line, "[[stage]] has no name");
  table.take(*name, stage.name);
  std::string keys = "name";
  keys += ", " + read_part(stage.axis_1, table, "axis_1", "control");
  keys += ", " + read_part(stage.axis_2, table, "axis_2", "control");
  keys += ", " + read_part(stage.end, table, "end", "condition");
  keys += ", " + read_parameters(stage, table, "");
  refuse_unused(table, keys);
  validate_at(stage, table);
  return stage;
}

}  // namespace internal

/// A path from text in TOML (docs/paths.md): `confining_pressure`, a table [preparation], which
/// puts the stages of a Preparation first, and a table [[stage]] for each stage of loading. Throws
/// InvalidInput with the name of the file, the line, the key and the rule for anything else.
template <class StageT = LoadingStage<>>
[[nodiscard]] LoadingPath<StageT> read_path(std::istream& in, const std::string& name) {
  std::vector<internal::TomlTable> tables = internal::TomlReader(in, name).tables();
  LoadingPath<StageT> path;
  const internal::TomlEntry* pressure = tables[0].find("confining_pressure");
  if (pressure != nullptr) tables[0].take(*pressure, path.confining_pressure);
  internal::refuse_unused(tables[0], "confining_pressure");
  for (std::size_t k = 1; k < tables.size(); ++k) {
    internal::TomlTable& table = tables[k];
    if (table.name == "stage") {
      path.stages.push_back(internal::read_stage<StageT>(table));
    } else if (table.name == "preparation" && path.stages.empty()) {
      Preparation preparation;
      internal::refuse_unused(table, internal::read_parameters(preparation, table, ""));
      internal::validate_at(preparation, table);
      path.append(preparation.stages(path.confining_pressure));
    } else {
      table.fail(table.line,
                 "'" + table.name + "': must be [preparation], once and first, or " + "[[stage]]");
    }
  }
  if (path.stages.empty()) throw InvalidInput(name + ": no stages: must have one or more");
  path.validate();
  return path;
}

/// The same from a file. Throws InvalidInput also where it cannot be read, with the reason.
template <class StageT = LoadingStage<>>
[[nodiscard]] LoadingPath<StageT> read_path(const std::filesystem::path& path) {
  auto file = internal::open_text(path);
  return read_path<StageT>(file, path.string());
}

}  // namespace riprap
