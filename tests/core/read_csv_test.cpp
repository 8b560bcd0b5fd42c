// SPDX-License-Identifier: BSL-1.0
#include <riprap/core/read_csv.hpp>

#include <doctest/doctest.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <support/message_of.hpp>

using namespace riprap;
using test::message_of;

namespace {

/// Sum of all numbers of a table with the columns a and b.
double sum(const std::string& text) {
  std::istringstream in(text);
  internal::CsvReader rows(in, "t.csv", "a,b");
  double total = 0;
  while (rows.next()) total += rows.number(0) + rows.number(1);
  return total;
}
std::string refusal(const std::string& text) {
  return message_of([&] { (void)sum(text); });
}

}  // namespace

TEST_CASE("numbers are read below the header, in any decimal form") {
  CHECK(sum("a,b\n1,2\n") == 3);
  CHECK(sum("a,b\n+1e0,-2.5\n.5,1.") == 0);
  CHECK(sum("a,b\n") == 0);
}

TEST_CASE("blanks, blank lines, comments, carriage returns and a byte order mark do not count") {
  CHECK(sum("\xEF\xBB\xBF# sizes\n\n a , b \r\n\t1, 2 \r\n\r\n  # more\n3,4") == 10);
}

TEST_CASE("whatever else is refused with file, line, value and rule") {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "t.csv: empty: must begin with the header a,b"},
      {"# a,b\n\n", "t.csv: empty: must begin with the header a,b"},
      {"1,2\n", "t.csv, line 1: header '1,2': must be a,b"},
      {"\nb,a\n", "t.csv, line 2: header 'b,a': must be a,b"},
      {"a,b,c\n", "t.csv, line 1: header 'a,b,c': must be a,b"},
      {"a,b\n1\n", "t.csv, line 2: 1 cells: must be 2, a,b"},
      {"a,b\n1,2\n\n1,2,3\n", "t.csv, line 4: 3 cells: must be 2, a,b"},
      {"a,b\n1;2\n", "t.csv, line 2: 1 cells: must be 2, a,b"},
      {"a,b\n1,\n", "t.csv, line 2: b = '': must be a finite number"},
      {"a,b\nx,1\n", "t.csv, line 2: a = 'x': must be a finite number"},
      {"a,b\n1,2 m\n", "t.csv, line 2: b = '2 m': must be a finite number"},
      {"a,b\n1,nan\n", "t.csv, line 2: b = 'nan': must be a finite number"},
      {"a,b\n-inf,1\n", "t.csv, line 2: a = '-inf': must be a finite number"},
      {"a,b\n1e999,1\n", "t.csv, line 2: a = '1e999': must be a finite number"},
      {"a,b\n+-1,1\n", "t.csv, line 2: a = '+-1': must be a finite number"},
      {"a,b\n0x1,1\n", "t.csv, line 2: a = '0x1': must be a finite number"},
      {"a,b\n\"1\",1\n", "t.csv, line 2: a = '\"1\"': must be a finite number"},
  };
  for (const auto& [text, message] : cases) {
    CAPTURE(text);
    CHECK(refusal(text) == message);
  }
}

TEST_CASE("a file that cannot be read is refused with the reason") {
  CHECK(message_of([] { (void)internal::open_text("/no/such/file.csv"); }) ==
        "cannot read /no/such/file.csv: No such file or directory");
  // A folder can be opened, and fails with the first line.
  CHECK(message_of([] {
          auto folder = internal::open_text("/");
          internal::LineReader lines(folder, "/");
          (void)lines.next();
        }) == "cannot read /: is it a file of text?");
}
