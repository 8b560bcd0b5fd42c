// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A file that is gone after the test.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace riprap::test {

class TemporaryFile {
 public:
  TemporaryFile()
      : path_(std::filesystem::temp_directory_path() /
              ("riprap_test_" + std::to_string(std::random_device{}()))) {}
  ~TemporaryFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] std::string path() const { return path_.string(); }
  [[nodiscard]] std::string text() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::filesystem::path path_;
};

}  // namespace riprap::test
