// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include <riprap/output/file.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

std::string refusal(const std::string& path) {
  try {
    write_file(path, "some text\n");
  } catch (const SimulationError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a written file holds the text byte by byte") {
  const test::TemporaryFile file;
  const std::string text("one\ntwo\r\n\0three", 16);
  write_file(file.path(), text);
  CHECK(file.text() == text);
}

TEST_CASE("a shorter text replaces all of a longer one") {
  const test::TemporaryFile file;
  write_file(file.path(), std::string(100'000, 'x'));
  write_file(file.path(), "short");
  CHECK(file.text() == "short");
  write_file(file.path(), "");
  CHECK(file.text().empty());
  CHECK(std::filesystem::exists(file.path()));
}

TEST_CASE("a file that cannot be opened is an error that names the path") {
  const test::TemporaryFile missing_folder;
  const std::string path = missing_folder.path() + "/curve.csv";
  CHECK(refusal(path) == "cannot write " + path);
  const std::string folder = std::filesystem::temp_directory_path().string();
  CHECK(refusal(folder) == "cannot write " + folder);
}

TEST_CASE("a disc that is full is an error even where a short text was only buffered") {
  // The device on which every write fails; not every system has it.
  if (!std::filesystem::exists("/dev/full")) return;
  CHECK(refusal("/dev/full") == "cannot write /dev/full");
}
