// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Checkpoints: the whole state of a simulation, its experiment and its observers in one HDF5 file,
/// from which a run goes on to the same bytes. Needs the library HDF5 (target riprap::hdf5).

#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <riprap/checkpoint/durable_file.hpp>
#include <riprap/checkpoint/fields_of.hpp>
#include <riprap/checkpoint/hdf5_image.hpp>
#include <riprap/checkpoint/sealed_image.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/material/rock.hpp>

namespace riprap {

namespace internal {

/// What must be the same in the file and in the program.
template <class Sim>
struct GivenModel {
  const Sim& sim;
  static constexpr bool names_all_members = false;

  static void for_each_field(auto& self, auto&& visit) {
    visit("policies", self.sim.model());
    const std::vector<Rock>& rocks = self.sim.rocks().list();
    visit("rock", rocks.front());
    for (std::size_t k = 1; k < rocks.size(); ++k)
      visit(("rock_" + std::to_string(k)).c_str(), rocks[k]);
  }
};

/// The parameters that an experiment names by `for_each_parameter`.
template <class Part>
struct GivenPart {
  const Part& part;
  static constexpr bool names_all_members = false;

  static void for_each_field(auto& self, auto&& visit) {
    Part::for_each_parameter(self.part, visit);
  }
};

template <class Part>
inline constexpr bool has_parameters =
    requires(const Part& part, const AnyField visit) { Part::for_each_parameter(part, visit); };

/// The name of a part's class, of a class template without its arguments: the simulation among
/// them may have another acceleration, and compilers leave default arguments out or not. What the
/// arguments decide is in the fields and parameters.
template <class Part>
[[nodiscard]] std::string part_type() {
  return std::string(type_name<Part>().substr(0, type_name<Part>().find('<')));
}

/// Objects by their number, with the names of their classes.
template <class... Parts>
struct NumberedParts {
  std::tuple<Parts&...> parts;
  static constexpr bool names_all_members = false;

  static void for_each_field(auto& self, auto&& visit) {
    std::size_t k = 0;
    std::apply([&](auto&... part) { (visit(std::to_string(k++).c_str(), part), ...); }, self.parts);
  }
};

/// The policies and the rocks, with the names of the policies' classes.
template <class Sim>
[[nodiscard]] FieldNode model_fields(const Sim& sim) {
  FieldNode model;
  model.path = "checkpoint/model";
  FieldWriter{.with_types = true}.append(model, GivenModel<Sim>{sim});
  // Classes that name all their policies, acceleration included.
  model.type.clear();
  model.children[0].type.clear();
  for (FieldNode& part : model.children[0].children) part.type.clear();
  return model;
}

/// The parameters of those parts that name them.
template <class... Parts>
[[nodiscard]] FieldNode parameter_fields(const Parts&... parts) {
  FieldNode top;
  top.path = "checkpoint/parameters";
  top.rows = 1;
  std::size_t k = 0;
  [[maybe_unused]] const auto append = [&]<class Part>(const Part& part) {
    const std::string name = std::to_string(k++);
    if constexpr (has_parameters<Part>)
      FieldWriter{}.append(top.child_at(top.children.size(), name), GivenPart<Part>{part});
  };
  (append(parts), ...);
  return top;
}

/// All fields of a checkpoint.
/// @tparam Parts the experiment, if there is one, and its observers
template <class Sim, class... Parts>
[[nodiscard]] FieldNode checkpoint_fields(const Sim& sim, const Parts&... parts) {
  FieldNode top;
  top.path = "checkpoint";
  top.rows = 1;
  const FieldWriter writer;
  top.child_at(0, "model") = model_fields(sim);
  writer.append(top.child_at(1, "simulation"), sim);
  writer.append(top.child_at(2, "parts"), NumberedParts<const Parts...>{{parts...}});
  top.child_at(3, "parameters") = parameter_fields(parts...);
  std::size_t k = 0;
  ((top.children[2].children[k++].type = part_type<Parts>()), ...);
  return top;
}

template <class Sim, class... Parts>
void require_same_model(FieldNode& top, const std::string& path, const Sim& sim,
                        const Parts&... given) {
  if (const auto what = difference(top.child("model"), model_fields(sim)))
    throw InvalidInput(path + " is of another model: " + *what);
  const std::vector<FieldNode>& parts = top.child("parts").children;
  const std::vector<std::string> types{part_type<Parts>()...};
  if (parts.size() != types.size())
    throw InvalidInput(path + " holds " + std::to_string(parts.size()) +
                       " experiments and observers, the program has " +
                       std::to_string(types.size()));
  for (std::size_t k = 0; k < types.size(); ++k)
    if (parts[k].type != types[k])
      throw InvalidInput(path + ": number " + std::to_string(k) +
                         " of the experiment and its observers is " + parts[k].type +
                         " in the file and " + types[k] + " in the program");
  if (const auto what = difference(top.child("parameters"), parameter_fields(given...)))
    throw InvalidInput(path + " is of another experiment: " + *what);
}

/// Writes all fields but those that parts compute. Throws InvalidInput if they are others.
template <class Sim, class... Parts>
void read_checkpoint_fields(FieldNode& top, Sim& sim, NumberedParts<Parts...>& parts) {
  read_fields(top.child("simulation"), sim);
  restored(sim);
  read_fields(top.child("parts"), parts);
  for (const char* const part : {"simulation", "parts"})
    if (const auto unread = first_unread(top.child(part)))
      throw InvalidInput(*unread + ": no such field in the program");
}

// A part that appends to a file names it by `appended_file()`, empty for none: what the part counts
// as written has to outlast a loss of power as the checkpoint does.
template <class Part>
void sync_appended_file(const Part& part) {
  if constexpr (requires { part.appended_file(); })
    if (const std::string path = part.appended_file(); !path.empty()) sync_file(path);
}

}  // namespace internal

/// Writes the state of a simulation, between two steps, and of its experiment and observers, in
/// this order, if there are any. The file is on the disk as a whole when the function returns;
/// until then one that stood at `path` is as it was. Before it, the file that a part names by
/// `std::string appended_file() const` is brought to the disk.
/// Throws SimulationError if it cannot be written. A part with state that it does not name
/// (core/fields.hpp) is refused at compile time.
template <class Sim, class... Parts>
void write_checkpoint(const std::string& path, const Sim& sim, const Parts&... parts) {
  std::vector<std::byte> image = to_hdf5_image(internal::checkpoint_fields(sim, parts...));
  seal_image(image);
  (internal::sync_appended_file(parts), ...);
  write_durable_file(path, image);
}

/// Reads the state into a simulation of the same model and rock, of any assembly, and into its
/// experiment and observers. Acceleration and number of threads may be others.
/// Throws DamagedCheckpoint for a file that is truncated, damaged or no checkpoint, InvalidInput
/// for one of another schema, model, experiment, other parts or other fields; nothing has been
/// changed then.
template <class Sim, class... Parts>
void read_checkpoint(const std::string& path, Sim& sim, Parts&... parts) {
  const std::vector<std::byte> image = read_whole_file(path);
  check_sealed_image(image, path);
  FieldNode top = from_hdf5_image(image, "checkpoint");
  internal::require_same_model(top, path, sim, parts...);
  internal::NumberedParts<Parts...> numbered{{parts...}};
  FieldNode before = internal::checkpoint_fields(sim, parts...);
  try {
    internal::read_checkpoint_fields(top, sim, numbered);
  } catch (const InvalidInput& error) {
    internal::read_checkpoint_fields(before, sim, numbered);
    throw InvalidInput(path + ": " + error.what());
  }
  restored(numbered);
}

}  // namespace riprap
