// SPDX-License-Identifier: BSL-1.0
#pragma once
// Arrays of numbers one behind the other, and where they are: the data of a page.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace replay {

// A number in [-range, range], or in [0, range] without a sign, as an integer; what lies outside
// becomes the end, and what is no number 0.
template <class Integer>
Integer quantised(double value, double range) {
  const double most = std::numeric_limits<Integer>::max();
  const double least = std::is_signed_v<Integer> ? -most : 0;
  const double scaled = range > 0 ? std::round(value / range * most) : 0;
  if (!(scaled == scaled)) return 0;
  return static_cast<Integer>(scaled < least ? least : scaled > most ? most : scaled);
}

class Binary {
 public:
  // The type is named as JavaScript has it, Uint16Array for example.
  template <class T>
  void add(const std::string& name, const std::vector<T>& values) {
    bytes_.resize((bytes_.size() + 7) / 8 * 8, '\0');  // typed arrays need it
    index_[name] = {{"type", type_name<T>()}, {"offset", bytes_.size()}, {"count", values.size()}};
    const std::size_t at = bytes_.size();
    bytes_.resize(at + values.size() * sizeof(T));
    if (!values.empty()) std::memcpy(bytes_.data() + at, values.data(), values.size() * sizeof(T));
  }

  [[nodiscard]] const nlohmann::ordered_json& index() const { return index_; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  static std::string type_name() {
    const std::string bits = std::to_string(8 * sizeof(T));
    if constexpr (std::is_floating_point_v<T>) return "Float" + bits + "Array";
    return (std::is_signed_v<T> ? "Int" : "Uint") + bits + "Array";
  }

  nlohmann::ordered_json index_ = nlohmann::ordered_json::object();
  std::string bytes_;
};

// In lines of no particular length, padded with '='.
std::string base64(const std::string& bytes);

}  // namespace replay
