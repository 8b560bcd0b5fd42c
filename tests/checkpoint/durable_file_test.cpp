// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <filesystem>
#include <vector>

#include <riprap/checkpoint/durable_file.hpp>
#include <riprap/core/errors.hpp>
#include <support/message_of.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

TEST_CASE("A file is read back as it was written") {
  const test::TemporaryFile file;
  std::vector<std::byte> bytes(3'000'000);  // more than one block
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<std::byte>(k * k);
  write_durable_file(file.path(), bytes);
  CHECK(read_whole_file(file.path()) == bytes);
  CHECK_FALSE(std::filesystem::exists(file.path() + ".part"));
  bytes.clear();
  write_durable_file(file.path(), bytes);
  CHECK(read_whole_file(file.path()).empty());
}

TEST_CASE("A file that cannot be written or read is named with the reason") {
  CHECK(test::message_of([] { (void)read_whole_file("/no/such/file"); }) ==
        "cannot read /no/such/file: No such file or directory");
  CHECK_THROWS_WITH_AS(write_durable_file("/no/such/file", {}),
                       "cannot write /no/such/file: No such file or directory", SimulationError);
}

TEST_CASE("What stood there stays if the new file cannot take its place") {
  const test::TemporaryFile folder;
  const std::filesystem::path taken = std::filesystem::path(folder.path()) / "taken";
  std::filesystem::create_directories(taken / "inside");
  CHECK_THROWS_AS(write_durable_file(taken.string(), {}), SimulationError);
  CHECK(std::filesystem::is_directory(taken));
  CHECK_FALSE(std::filesystem::exists(taken.string() + ".part"));
  std::filesystem::remove_all(folder.path());
}
