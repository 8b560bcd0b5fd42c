// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string_view>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/checkpoint/sealed_image.hpp>

namespace riprap {

namespace internal {

inline constexpr std::size_t head_size = 512;
inline constexpr std::string_view first_line = "riprap checkpoint\n";

/// The head of a file of `size` bytes.
[[nodiscard]] RIPRAP_INLINE std::string
checkpoint_head(unsigned long schema, unsigned long long size, unsigned long long digest) {
  char numbers[128];
  std::snprintf(numbers, sizeof numbers, "schema %lu\nbytes %llu\ndigest %016llx\n", schema, size,
                digest);
  std::string head = std::string(first_line) + numbers;
  head.resize(head_size - 1, ' ');
  return head + '\n';
}

[[nodiscard]] RIPRAP_INLINE std::uint64_t digest_of_rest(const std::vector<std::byte>& image) {
  return digest(std::span(image).subspan(head_size));
}

[[noreturn]] RIPRAP_INLINE void throw_other_schema(const std::string& path, unsigned long schema) {
  throw InvalidInput(path + " is a checkpoint of another version of riprap: schema " +
                     std::to_string(schema) + ", and this one reads " +
                     std::to_string(checkpoint_schema));
}

}  // namespace internal

RIPRAP_INLINE void seal_image(std::vector<std::byte>& image) {
  const std::string head =
      internal::checkpoint_head(checkpoint_schema, image.size(), internal::digest_of_rest(image));
  std::memcpy(image.data(), head.data(), head.size());
}

RIPRAP_INLINE void check_sealed_image(const std::vector<std::byte>& image,
                                      const std::string& path) {
  using namespace internal;
  if (image.empty()) throw DamagedCheckpoint(path + " is empty");
  std::string head(std::min(image.size(), head_size), '\0');
  std::memcpy(head.data(), image.data(), head.size());
  const std::size_t common = std::min(head.size(), first_line.size());
  if (head.compare(0, common, first_line, 0, common) != 0)
    throw DamagedCheckpoint(path + " is no checkpoint of riprap");
  // Another layout may follow this line, with neither size nor digest where they are looked for.
  unsigned long schema = 0;
  char after = 0;
  if (std::sscanf(head.c_str() + common, "schema %lu%c", &schema, &after) == 2 && after == '\n' &&
      schema > checkpoint_schema)
    throw_other_schema(path, schema);
  if (head.size() < head_size)
    throw DamagedCheckpoint(path + " is truncated: " + std::to_string(head.size()) + " bytes");
  unsigned long long size = 0;
  unsigned long long written = 0;
  if (std::sscanf(head.c_str() + first_line.size(), "schema %lu\nbytes %llu\ndigest %llx", &schema,
                  &size, &written) != 3)
    throw DamagedCheckpoint(path + " is damaged: its head cannot be read");
  if (image.size() != size)
    throw DamagedCheckpoint(path + (image.size() < size ? " is truncated: " : " is damaged: ") +
                            std::to_string(image.size()) + " of " + std::to_string(size) +
                            " bytes");
  if (written != digest_of_rest(image) || head != checkpoint_head(schema, size, written))
    throw DamagedCheckpoint(path + " is damaged: its digest is another one");
  if (schema != checkpoint_schema) throw_other_schema(path, schema);
}

}  // namespace riprap
