// SPDX-License-Identifier: BSL-1.0
// The entry of libFuzzer, for the target RIPRAP_FUZZ_TARGET.

#include <cstddef>
#include <cstdint>
#include <exception>

#include "check.hpp"
#include "targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    riprap::fuzz::RIPRAP_FUZZ_TARGET({data, size});
  } catch (const std::exception& error) {
    riprap::fuzz::check(false, error.what());
  }
  return 0;
}
