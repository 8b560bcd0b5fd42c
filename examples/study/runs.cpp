// SPDX-License-Identifier: BSL-1.0
#include "runs.hpp"

#include <CLI/Error.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <optional>
#include <sstream>

#include "../biaxial/options.hpp"
#include "../command_line/number.hpp"
#include "../command_line/toml.hpp"

namespace run_study {

namespace {

constexpr std::size_t most_runs = 1000000;
constexpr std::size_t longest_name = 120;

// What the command decides, or `seeds` does.
constexpr std::array not_of_a_table{"seed",   "out",  "threads", "timer",           "config",
                                    "resume", "help", "version", "checkpoint-every"};

// One value for each option, in the order of the table.
struct Combination {
  std::vector<Setting> settings{};
  std::vector<std::string> of_row{};  // options that may tell it from others
};

// Does the message name the option?
bool names_option(const std::string& message, const std::string& option) {
  const std::string wanted = "--" + option;
  for (std::size_t at = message.find(wanted); at != message.npos;
       at = message.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    const char next = end < message.size() ? message[end] : ' ';
    if (next != '-' && std::isalnum(static_cast<unsigned char>(next)) == 0) return true;
  }
  return false;
}

[[noreturn]] void fail(const TableFile& file, const TableRow& row, const Combination& combination,
                       const std::string& message) {
  int line = row.line;
  for (const Setting& s : combination.settings)
    if (names_option(message, s.option)) line = s.line;
  throw riprap::InvalidInput(place(file, line) + message);
}

void check_name(const TableFile& file, const Setting& s) {
  const std::string where = place(file, s.line);
  if (std::ranges::find(not_of_a_table, s.option) != not_of_a_table.end())
    throw riprap::InvalidInput(where + "'" + s.option + "' is not set by a table" +
                               (s.option == "seed" ? ", whose seeds are 'seeds'" : ""));
  for (const std::string& value : s.values)
    if (value.empty()) throw riprap::InvalidInput(where + s.option + ": must not be empty");
}

Options options_of(const TableFile& file, const TableRow& row, const Combination& combination) {
  std::vector<std::string> arguments;
  for (const Setting& s : combination.settings)
    arguments.push_back("--" + s.option + "=" + s.values.front());
  Options options;
  try {
    options = options_from(arguments);
    check_values(options);
  } catch (const CLI::ExtrasError&) {
    for (const Setting& s : combination.settings) {
      try {
        (void)options_from({"--" + s.option + "=" + s.values.front()});
      } catch (const CLI::ExtrasError&) {
        throw riprap::InvalidInput(place(file, s.line) + "'" + s.option +
                                   "' is not the name of an option, without its dashes");
      } catch (const CLI::ParseError&) {  // it goes with another one
      }
    }
    throw;
  } catch (const CLI::ParseError& error) {
    fail(file, row, combination, error.what());
  } catch (const riprap::InvalidInput& error) {
    fail(file, row, combination, command_line::in_options(error.what(), options.names));
  }
  return options;
}

// Steps of all particles: before shear, and in shear, which are inversely proportional to its rate.
double work_of(const Options& o) {
  return o.assembly.count * (2.3 + 5 * o.test.axial_strain * 1e-3 / o.test.inertial_number *
                                       std::sqrt(14e6 / o.test.confining_pressure));
}

std::vector<Combination> combinations_of(const TableFile& file, const TableRow& row) {
  Combination first;
  for (const Setting& s : file.base) {
    const auto same = [&](const Setting& other) { return other.option == s.option; };
    if (std::ranges::none_of(row.settings, same)) first.settings.push_back(s);
  }
  std::vector<Combination> all{first};
  for (const Setting& s : row.settings) {
    std::vector<Combination> longer;
    if (all.size() * s.values.size() * row.seeds.size() > most_runs)
      throw riprap::InvalidInput(place(file, row.line) + "more than a million runs");
    for (const Combination& c : all)
      for (const std::string& value : s.values) {
        longer.push_back(c);
        longer.back().settings.push_back({s.option, {value}, false, s.line});
        if (s.is_list || row.name.empty()) longer.back().of_row.push_back(s.option);
      }
    all = std::move(longer);
  }
  return all;
}

// "2e6" for "2e+06".
std::string short_number(const std::string& text) {
  const std::size_t e = text.find('e');
  if (!command_line::number_from<double>(text) || e == text.npos) return text;
  const std::string sign = text.compare(e + 1, 1, "-") == 0 ? "-" : "";
  const std::size_t digits = text.find_first_not_of("+-0", e + 1);
  return text.substr(0, e + 1) + sign + (digits == text.npos ? "0" : text.substr(digits));
}

std::string in_file_name(std::string text) {
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 &&
        std::string_view(".+-=_").find(c) == std::string_view::npos)
      c = '-';
  if (text.starts_with('.')) text.front() = '-';
  return text;
}

// FNV-1a of the options, whatever the version that wrote them.
std::string hash_of(const std::map<std::string, std::string>& parameters) {
  std::uint32_t hash = 2166136261U;
  for (const auto& [name, value] : parameters)
    for (const char c : name + "=" + value + "\n")
      hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  char text[16];
  std::snprintf(text, sizeof text, "_%08x", static_cast<unsigned>(hash));
  return text;
}

std::string name_of(const Run& run) {
  std::string name = in_file_name(run.row);
  for (const auto& [option, value] : run.coordinates)
    name += (name.empty() ? "" : "_") + option + "=" + in_file_name(short_number(value));
  return name + (name.empty() ? "" : "_") + "seed=" + std::to_string(run.seed);
}

// Names that are too long, or that several runs have, end with a hash of all parameters.
void name_folders(std::vector<Run>& runs) {
  std::map<std::string, int> count;
  for (Run& run : runs) {
    run.folder = name_of(run);
    ++count[run.folder];
  }
  for (Run& run : runs) {
    const bool is_long = run.folder.size() > longest_name;
    if (!is_long && count[run.folder] == 1) continue;
    if (is_long) run.folder.resize(longest_name);
    run.folder += hash_of(run.parameters);
  }
}

void replace_line(std::string& text, const std::string& name, const std::string& value) {
  const std::size_t begin = text.find("\n" + name + " = ");
  if (begin == text.npos) throw std::logic_error("no " + name + " among the parameters");
  const std::size_t end = text.find('\n', begin + 1);
  text.replace(begin, end - begin, "\n" + name + " = " + value);
}

void add_runs(const TableFile& file, const TableRow& row, std::vector<Run>& runs) {
  for (const Combination& combination : combinations_of(file, row)) {
    const Options options = options_of(file, row, combination);
    Run run{.row = row.name, .toml = options.toml, .work = work_of(options), .line = row.line};
    run.parameters = options_in(options.toml);
    for (const std::string& option : combination.of_row) {
      const auto found = run.parameters.find(option);
      if (found != run.parameters.end()) run.coordinates.emplace_back(option, found->second);
    }
    for (const std::uint64_t seed : row.seeds) {
      run.seed = seed;
      run.parameters["seed"] = std::to_string(seed);
      replace_line(run.toml, "seed", std::to_string(seed));
      runs.push_back(run);
    }
  }
}

}  // namespace

std::map<std::string, std::string> options_in(const std::string& toml) {
  std::map<std::string, std::string> options;
  std::istringstream lines(toml);
  std::string line;
  while (std::getline(lines, line)) {
    const std::size_t equals = line.find('=');
    if (line.empty() || line.front() == '#' || equals == line.npos) continue;
    options[command_line::trimmed(line.substr(0, equals))] =
        command_line::toml_value(line.substr(equals + 1)).items.front();
  }
  return options;
}

Study study_of(const TableFile& file) {
  Study study;
  const auto note = [&](const Setting& s) {
    check_name(file, s);
    if (std::ranges::find(study.options, s.option) == study.options.end())
      study.options.push_back(s.option);
  };
  std::ranges::for_each(file.base, note);
  for (const TableRow& row : file.rows) {
    std::ranges::for_each(row.settings, note);
    add_runs(file, row, study.runs);
  }
  if (study.runs.empty()) throw riprap::InvalidInput(place(file, 1) + "no runs");
  std::map<std::string, int> lines;
  for (const Run& run : study.runs) {
    const auto [other, is_new] = lines.try_emplace(run.toml, run.line);
    if (!is_new)
      throw riprap::InvalidInput(place(file, run.line) + name_of(run) +
                                 ": the same run as one of the row in line " +
                                 std::to_string(other->second));
  }
  name_folders(study.runs);
  return study;
}

Shard shard_from(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const auto index = command_line::number_from<std::uint64_t>(text.substr(0, slash));
  const auto count = slash == text.size()
                         ? std::nullopt
                         : command_line::number_from<std::uint64_t>(text.substr(slash + 1));
  if (!index || !count || *index < 1 || *index > *count)
    throw riprap::InvalidInput("--shard: '" + text + "' is not I/N with 1 <= I <= N");
  return {*index, *count};
}

std::vector<Run> runs_of_shard(const std::vector<Run>& runs, const Shard& shard) {
  std::vector<Run> out;
  for (std::size_t k = shard.index - 1; k < runs.size(); k += shard.count) out.push_back(runs[k]);
  return out;
}

}  // namespace run_study
