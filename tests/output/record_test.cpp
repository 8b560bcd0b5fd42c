// SPDX-License-Identifier: BSL-1.0
#include <riprap/output/record.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>
#include <support/temporary_file.hpp>

using namespace riprap;

namespace {

std::vector<ReadRecord> records_in(const std::string& path) {
  std::vector<ReadRecord> records;
  read_records(path, "signature\n", [&](const ReadRecord& r) { records.push_back(r); });
  return records;
}

std::string two_records() {
  Record first("ONE ");
  first.add("f", std::vector<float>{0.5f, -2});
  first.add("d", 0.1);
  Record second("TWO ");
  second.add("elevenchars", std::vector<std::uint32_t>{1, 0xFFFFFFFFu});
  second.add("Q", std::uint64_t{1} << 52);
  second.add("none", std::vector<double>{});
  return first.bytes() + second.bytes();
}

}  // namespace

TEST_CASE("a record is laid out byte by byte as its comment says") {
  Record record("KIND");
  record.add("name", std::uint32_t{0x01020304});
  CHECK(record.bytes() == std::string("KIND\x14\0\0\0name\0\0\0\0\0\0\0I\1\0\0\0\4\3\2\1", 28));
}

TEST_CASE("records are read back by name") {
  const test::TemporaryFile file;
  write_file(file.path(), "signature\n" + two_records());
  const auto records = records_in(file.path());
  REQUIRE(records.size() == 2);
  CHECK(records[0].kind == "ONE ");
  CHECK(records[0]["f"] == std::vector<double>{0.5, -2});
  CHECK(records[0].number("d") == 0.1);
  CHECK(records[1]["elevenchars"] == std::vector<double>{1, 4294967295.0});
  CHECK(records[1].number("Q") == 4503599627370496.0);
  CHECK(records[1]["none"].empty());
  CHECK(!records[1].has("f"));
  CHECK_THROWS_WITH_AS((void)records[1]["f"], "record TWO : has no array f", InvalidInput);
  CHECK_THROWS_WITH_AS((void)records[1].number("none"), "record TWO : array none is empty",
                       InvalidInput);
}

TEST_CASE("a last record that was cut short is left out, wherever it was cut") {
  const test::TemporaryFile file;
  const std::string whole = two_records();
  Record first("ONE ");
  first.add("f", std::vector<float>{0.5f, -2});
  first.add("d", 0.1);
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    CAPTURE(length);
    write_file(file.path(), "signature\n" + whole.substr(0, length));
    const std::size_t expected =
        length == whole.size() ? 2 : static_cast<std::size_t>(length >= first.bytes().size());
    CHECK(records_in(file.path()).size() == expected);
  }
}

TEST_CASE("what is no file of records is refused") {
  const test::TemporaryFile file;
  CHECK_THROWS_WITH_AS(records_in(file.path()),
                       (file.path() + ": must be a file that can be read").c_str(), InvalidInput);
  write_file(file.path(), "signatur");
  CHECK_THROWS_AS(records_in(file.path()), InvalidInput);
  // An array that claims more values than its record has, and a type that there is not.
  for (const std::string& array : {std::string("n\0\0\0\0\0\0\0\0\0\0I\2\0\0\0....", 20),
                                   std::string("n\0\0\0\0\0\0\0\0\0\0x\1\0\0\0....", 20)}) {
    write_file(file.path(), "signature\n" + std::string("KIND\x14\0\0\0", 8) + array);
    CHECK_THROWS_WITH_AS(records_in(file.path()),
                         (file.path() + ": record KIND: an array does not end with it").c_str(),
                         InvalidInput);
  }
  CHECK_THROWS_AS(Record("LONGER"), InvalidInput);
  CHECK_THROWS_AS(Record("KIND").add("twelve_chars", 1.0), InvalidInput);
}
