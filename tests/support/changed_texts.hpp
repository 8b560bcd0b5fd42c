// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Texts with changes at random, for readers.

#include <cstdint>
#include <string>
#include <string_view>

#include <riprap/core/errors.hpp>
#include <riprap/core/random.hpp>

namespace riprap::test {

/// `text` after up to three changes: a character becomes one of `letters`, or the text ends there.
[[nodiscard]] inline std::string changed(std::string text, std::string_view letters,
                                         Random& random) {
  const auto below = [&](std::size_t count) {
    return random.uniform_integer(0, static_cast<unsigned>(count - 1));
  };
  for (unsigned changes = random.uniform_integer(0, 3); changes > 0 && !text.empty(); --changes) {
    const unsigned at = below(text.size());
    if (random.uniform(0, 1) < 0.5)
      text[at] = letters[below(letters.size())];
    else
      text.erase(at);
  }
  return text;
}

/// How many of 20,000 changed texts are read; all others must be refused with InvalidInput.
template <class Read>
[[nodiscard]] int read_of_changed(const std::string& text, std::string_view letters,
                                  std::uint64_t seed, Read&& read) {
  Random random(seed);
  int count = 0;
  for (int i = 0; i < 20000; ++i) try {
      read(changed(text, letters, random));
      ++count;
    } catch (const InvalidInput&) {
      continue;
    }
  return count;
}

}  // namespace riprap::test
