// SPDX-License-Identifier: BSL-1.0
// riprap_fuzz_replay TARGET FOLDER: calls a fuzz target with every file of a folder.

#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "targets.hpp"

namespace {

using namespace riprap;

struct Target {
  const char* name;
  void (*function)(fuzz::Bytes);
};
constexpr Target targets[] = {
#define RIPRAP_FUZZ_ENTRY(name) {#name, fuzz::name},
    RIPRAP_FUZZ_TARGETS
#undef RIPRAP_FUZZ_ENTRY
};

int replay(void (*target)(fuzz::Bytes), const std::filesystem::path& folder) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    // Before the call, for a target aborts.
    std::printf("%s\n", entry.path().filename().c_str());
    std::fflush(stdout);
    std::ifstream file(entry.path(), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    target(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    ++count;
  }
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  for (const auto& [name, target] : targets) {
    if (std::strcmp(name, argv[1]) != 0) continue;
    try {
      return replay(target, argv[2]) > 0 ? 0 : 1;
    } catch (const std::exception& error) {
      std::printf("threw: %s\n", error.what());
      return 1;
    }
  }
  return 2;
}
