// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The fields of an object in memory, by name: what a checkpoint would hold.

#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <riprap/core/fields.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap::test {

/// Takes the bytes of all fields and puts them into another object of the same type.
class FieldCopy {
 public:
  template <class T>
  void take(const T& object) {
    bytes_.clear();
    take_fields(object, "");
  }
  template <class T>
  void put(T& object) const {
    put_fields(object, "");
  }
  [[nodiscard]] const std::map<std::string, std::string>& fields() const { return bytes_; }

 private:
  template <class T>
  void take_fields(const T& object, const std::string& owner) {
    for_each_field(object, [&]<class F>(const char* name, const F& field) {
      const std::string path = owner + "/" + name;
      if constexpr (NamesFields<F> || std::is_empty_v<F>) {
        take_fields(field, path);
      } else {
        static_assert(std::is_trivially_copyable_v<F> || std::is_base_of_v<Vec2, F>);
        std::string bytes(sizeof(F), '\0');
        std::memcpy(bytes.data(), static_cast<const void*>(&field), sizeof(F));
        if (!bytes_.emplace(path, bytes).second) throw std::logic_error(path + " comes twice");
      }
    });
  }
  template <class T>
  void put_fields(T& object, const std::string& owner) const {
    for_each_field(object, [&]<class F>(const char* name, F& field) {
      const std::string path = owner + "/" + name;
      if constexpr (NamesFields<F> || std::is_empty_v<F>) {
        put_fields(field, path);
      } else {
        const std::string& bytes = bytes_.at(path);
        if (bytes.size() != sizeof(F)) throw std::logic_error(path + " has another size");
        std::memcpy(static_cast<void*>(&field), bytes.data(), sizeof(F));
      }
    });
  }

  std::map<std::string, std::string> bytes_;
};

}  // namespace riprap::test
