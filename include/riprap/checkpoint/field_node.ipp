// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstring>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/core/splitmix64.hpp>

namespace riprap {

RIPRAP_INLINE std::string_view FieldNode::name() const {
  const std::string_view whole = path;
  return whole.substr(whole.rfind('/') + 1);  // npos + 1 is 0
}

RIPRAP_INLINE std::string FieldNode::text() const {
  std::string characters(bytes.size(), '\0');
  if (!bytes.empty()) std::memcpy(characters.data(), bytes.data(), bytes.size());
  return characters;
}

RIPRAP_INLINE FieldNode& FieldNode::child(std::string_view of) {
  for (FieldNode& node : children)
    if (node.name() == of) return node;
  throw InvalidInput(path + " has no field '" + std::string(of) + "'");
}

RIPRAP_INLINE FieldNode& FieldNode::child_at(std::size_t k, std::string_view of) {
  if (k == children.size()) {
    children.emplace_back();
    children.back().path = path + '/' + std::string(of);
    children.back().is_sequence = is_sequence;
  }
  return children[k];
}

RIPRAP_INLINE void FieldNode::append(NumberType type_of_row, std::size_t columns_of_row,
                                     const void* row) {
  kind = Kind::numbers;
  number = type_of_row;
  columns = columns_of_row;
  const auto* const first = static_cast<const std::byte*>(row);
  bytes.insert(bytes.end(), first, first + row_size());
  ++rows;
}

RIPRAP_INLINE const std::byte* FieldNode::next_row(NumberType type_of_row,
                                                   std::size_t columns_of_row) {
  if (kind != Kind::numbers || number != type_of_row || columns != columns_of_row)
    throw InvalidInput(path + ": numbers of another type or shape");
  if (rows_read == rows || bytes.size() != rows * row_size())
    throw InvalidInput(path + ": too few numbers");
  return bytes.data() + row_size() * rows_read++;
}

// As deep as types are nested. NOLINTNEXTLINE(misc-no-recursion)
RIPRAP_INLINE std::optional<std::string> first_unread(const FieldNode& node) {
  if (node.rows_read != node.rows) return node.path;
  for (const FieldNode& child : node.children)
    if (auto path = first_unread(child)) return path;
  return std::nullopt;
}

RIPRAP_INLINE std::uint64_t digest(std::span<const std::byte> bytes) {
  std::uint64_t hash = bytes.size();
  while (!bytes.empty()) {
    std::uint64_t word = 0;
    const std::size_t size = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), size);
    hash = splitmix64(hash ^ word);
    bytes = bytes.subspan(size);
  }
  return hash;
}

// As deep as types are nested. NOLINTNEXTLINE(misc-no-recursion)
RIPRAP_INLINE std::uint64_t digest(const FieldNode& node) {
  const auto text = [](std::string_view s) { return digest(std::as_bytes(std::span(s))); };
  std::uint64_t hash = splitmix64(text(node.name()) ^ text(node.type));
  hash = splitmix64(hash ^ static_cast<std::uint64_t>(node.kind) ^ node.rows << 8);
  if (node.kind == FieldNode::Kind::numbers)
    hash = splitmix64(hash ^ static_cast<std::uint64_t>(node.number) ^ node.columns << 8);
  hash = splitmix64(hash ^ digest(node.bytes));
  for (const FieldNode& child : node.children) hash = splitmix64(hash ^ digest(child));
  return hash;
}

namespace internal {

/// One number as text.
template <class Number>
[[nodiscard]] std::string number_text(const std::byte* at) {
  Number value{};
  std::memcpy(&value, at, sizeof value);
  return to_text(static_cast<double>(value));
}

/// The first row of an array, or a text.
[[nodiscard]] RIPRAP_INLINE std::string value_text(const FieldNode& node) {
  if (node.kind == FieldNode::Kind::text) return "'" + node.text() + "'";
  if (node.kind == FieldNode::Kind::group) return "a group";
  if (node.is_sequence || node.bytes.empty()) return std::to_string(node.rows) + " rows";
  using Text = std::string (*)(const std::byte*);
  constexpr Text texts[] = {number_text<std::int8_t>,   number_text<std::int16_t>,
                            number_text<std::int32_t>,  number_text<std::int64_t>,
                            number_text<std::uint8_t>,  number_text<std::uint16_t>,
                            number_text<std::uint32_t>, number_text<std::uint64_t>,
                            number_text<float>,         number_text<double>};
  std::string text;
  for (std::size_t k = 0; k < node.columns; ++k)
    text += (k ? ", " : "") + texts[static_cast<std::size_t>(node.number)](
                                  node.bytes.data() + k * size_of(node.number));
  return text;
}

}  // namespace internal

// As deep as types are nested. NOLINTNEXTLINE(misc-no-recursion)
RIPRAP_INLINE std::optional<std::string> difference(const FieldNode& in_file,
                                                    const FieldNode& in_program) {
  const auto sentence = [&](const std::string& file, const std::string& program) {
    return in_program.path + " is " + file + " in the file and " + program + " in the program";
  };
  if (in_file.type != in_program.type) return sentence(in_file.type, in_program.type);
  if (in_file.kind != in_program.kind || in_file.rows != in_program.rows ||
      in_file.bytes != in_program.bytes)
    return sentence(internal::value_text(in_file), internal::value_text(in_program));
  const std::size_t common = std::min(in_file.children.size(), in_program.children.size());
  for (std::size_t k = 0; k < common; ++k) {
    if (in_file.children[k].name() != in_program.children[k].name())
      return sentence("a group with " + std::string(in_file.children[k].name()),
                      "one with " + std::string(in_program.children[k].name()));
    if (auto inner = difference(in_file.children[k], in_program.children[k])) return inner;
  }
  if (in_file.children.size() != in_program.children.size())
    return sentence("of " + std::to_string(in_file.children.size()) + " fields",
                    "of " + std::to_string(in_program.children.size()));
  return std::nullopt;
}

}  // namespace riprap
