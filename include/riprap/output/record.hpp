// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Binary records of named arrays: a file that grows record by record and describes itself.

#include <bit>
#include <cstdint>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <riprap/core/linkage.hpp>

namespace riprap {

namespace internal {

static_assert(std::endian::native == std::endian::little,
              "riprap: records are written as the processor has its numbers, little end first");

/// The character that names a type in a record; as Python's `struct` has it.
template <class T>
[[nodiscard]] consteval char record_type() {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double> ||
                    std::is_same_v<T, std::uint32_t> || std::is_same_v<T, std::uint64_t>,
                "riprap: a record has arrays of float, double, uint32_t or uint64_t");
  if constexpr (std::is_same_v<T, float>)
    return 'f';
  else if constexpr (std::is_same_v<T, double>)
    return 'd';
  else
    return sizeof(T) == 4 ? 'I' : 'Q';
}

}  // namespace internal

/// A record to write: four characters that say what it is, the length of the rest in bytes, then
/// arrays. An array is its name (11 characters, padded with zeros), its type (f, d, I or Q), the
/// number of its values, and these. Lengths and numbers of values are uint32.
class Record {
 public:
  /// @param kind four characters
  explicit Record(std::string_view kind);

  /// @param name at most 11 characters
  template <class T>
  void add(std::string_view name, const std::vector<T>& values) {
    begin_array(name, internal::record_type<T>(), values.size());
    append(values.data(), values.size() * sizeof(T));
  }
  template <class T>
  void add(std::string_view name, T value) {
    begin_array(name, internal::record_type<T>(), 1);
    append(&value, sizeof(T));
  }

  /// As it is in the file.
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void begin_array(std::string_view name, char type, std::size_t count);
  void append(const void* data, std::size_t size);

  std::string bytes_;
};

/// A record that was read: its arrays by name, as double, which holds all but counts above 2^53.
struct ReadRecord {
  std::string kind;
  std::map<std::string, std::vector<double>, std::less<>> arrays{};

  [[nodiscard]] bool has(std::string_view name) const { return arrays.find(name) != arrays.end(); }
  /// Throws InvalidInput if there is no such array.
  [[nodiscard]] const std::vector<double>& operator[](std::string_view name) const;
  /// The first value; throws InvalidInput if there is none.
  [[nodiscard]] double number(std::string_view name) const;
};

/// Calls `visit(record)` for the whole records of a file, in order; the last one is left out if it
/// was cut short. Throws InvalidInput if the file cannot be read, does not start with `signature`,
/// or an array does not end with its record.
void read_records(const std::string& path, std::string_view signature,
                  const std::function<void(const ReadRecord&)>& visit);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/output/record.ipp>
#endif
