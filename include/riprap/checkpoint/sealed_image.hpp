// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The first 512 bytes of a checkpoint: what it is, its schema, size and digest.

#include <cstddef>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>

namespace riprap {

/// Version of the layout of checkpoints. Higher ones are refused by name.
inline constexpr unsigned checkpoint_schema = 4;

/// Thrown for a file that is no whole checkpoint: truncated, damaged or something else.
struct DamagedCheckpoint : InvalidInput {
  using InvalidInput::InvalidInput;
};

/// Writes the head, lines of text, into the first 512 bytes of an image.
void seal_image(std::vector<std::byte>& image);

/// Throws InvalidInput for a higher schema, whatever comes after the line that says so;
/// DamagedCheckpoint unless `image` is as it was sealed; InvalidInput for a lower schema.
/// @param path where it was read, for messages
void check_sealed_image(const std::vector<std::byte>& image, const std::string& path);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/checkpoint/sealed_image.ipp>
#endif
