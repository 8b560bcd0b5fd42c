// SPDX-License-Identifier: BSL-1.0
// path_keys [PAGE]  Prints the keys of a path file with their defaults, as rows of a table. With a
// page: fails for every row that does not stand in it, word for word.

#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include <riprap/experiment/loading_stage.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/experiment/read_path.hpp>
using namespace riprap;

namespace {

template <class T>
std::string text(const T& value) {
  std::ostringstream out;
  if constexpr (std::is_enum_v<T>)
    out << '"' << names_of(value)[static_cast<std::size_t>(value)] << '"';
  else
    out << std::boolalpha << value;
  return out.str();
}

template <class T>
std::string row(const std::string& head, const T& part) {
  std::string keys;
  if constexpr (!std::is_empty_v<T>)
    T::for_each_parameter(part, [&](const char* name, const auto& value) {
      keys += (keys.empty() ? "`" : ", `") + std::string(name) + " = " + text(value) + "`";
    });
  return "| " + head + " | " + (keys.empty() ? "-" : keys) + " |";
}

// The alternatives that files may name.
template <class... T>
void add_rows(const std::variant<T...>*, const std::string& key, std::vector<std::string>& rows) {
  const auto add = [&]<class One>(const One& part) {
    if constexpr (internal::ReadFromFile<One>)
      rows.push_back(row("`" + key + " = \"" + One::name + "\"`", part));
  };
  (add(T{}), ...);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::string> rows{
      "| top of the file | `confining_pressure = " + text(LoadingPath<>{}.confining_pressure) +
          "` |",
      row("`[preparation]`", Preparation{}), row("`[[stage]]`", LoadingStage<>{})};
  add_rows(static_cast<const AxisControl*>(nullptr), "control", rows);
  add_rows(static_cast<const EndCondition*>(nullptr), "condition", rows);
  std::string page;
  if (argc > 1) {
    std::ifstream file(argv[1]);
    page.assign(std::istreambuf_iterator<char>(file), {});
  }
  int missing = 0;
  for (const std::string& line : rows) {
    if (argc > 1 && page.find(line + "\n") != std::string::npos) continue;
    missing += argc > 1;
    std::printf("%s\n", line.c_str());
  }
  if (missing > 0) std::printf("%d of these rows do not stand in %s\n", missing, argv[1]);
  return missing > 0;
}
