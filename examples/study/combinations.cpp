// SPDX-License-Identifier: BSL-1.0
#include "combinations.hpp"

#include <algorithm>
#include <set>

#include <riprap/core/errors.hpp>

#include "../command_line/number.hpp"
#include "results.hpp"
#include "run_folder.hpp"

namespace run_study {

namespace {

// The parameters but for the seed.
std::map<std::string, std::string> key_of(const Run& run) {
  auto key = run.parameters;
  key.erase("seed");
  return key;
}

bool has_coordinate(const Run& run, const std::string& option) {
  return std::ranges::any_of(run.coordinates, [&](const auto& c) { return c.first == option; });
}

// Do all coordinates of `other` but for the one of `option` have their value in `run`, too?
bool agrees(const Run& run, const Run& other, const std::string& option) {
  return std::ranges::all_of(other.coordinates, [&](const auto& c) {
    return c.first == option ||
           (has_coordinate(run, c.first) && value_of(run, c.first) == c.second);
  });
}

}  // namespace

std::vector<FinishedRun> finished_runs(const Study& study, const std::filesystem::path& folder) {
  std::vector<FinishedRun> out;
  for (const Run& run : study.runs) {
    const RunFolder place(folder, run);
    if (place.state() != RunState::finished) continue;
    place.check_parameters();
    out.push_back({&run, results_in(place.finished())});
  }
  return out;
}

std::vector<double> Combination::values(std::size_t column) const {
  std::vector<double> out;
  for (const FinishedRun* run : runs) out.push_back(run->results[column]);
  return out;
}

std::vector<Combination> combinations_of(const std::vector<FinishedRun>& runs) {
  std::vector<Combination> all;
  std::map<std::map<std::string, std::string>, std::size_t> places;
  for (const FinishedRun& run : runs) {
    const auto [place, is_new] = places.try_emplace(key_of(*run.run), all.size());
    if (is_new) all.emplace_back();
    all[place->second].runs.push_back(&run);
  }
  return all;
}

std::string value_of(const Run& run, const std::string& option) {
  if (option == "row") return run.row;
  const auto found = run.parameters.find(option);
  return found == run.parameters.end() ? "" : found->second;
}

bool is_same_value(const std::string& a, const std::string& b) {
  const auto number_a = command_line::number_from<double>(a);
  const auto number_b = command_line::number_from<double>(b);
  return number_a && number_b ? *number_a == *number_b : a == b;
}

Against against_from(const std::string& text, const std::vector<Run>& runs) {
  const std::size_t equals = std::min(text.find('='), text.size());
  Against against{text.substr(0, equals), ""};
  const std::string wanted = equals == text.size() ? "" : text.substr(equals + 1);
  std::set<std::string> options;
  for (const Run& run : runs) {
    if (!run.row.empty()) options.insert("row");
    for (const auto& c : run.coordinates) options.insert(c.first);
    if (against.option == "row" ? run.row.empty() : !has_coordinate(run, against.option)) continue;
    const std::string value = value_of(run, against.option);
    if (!wanted.empty() && !is_same_value(value, wanted)) continue;
    against.value = value;
    return against;
  }
  std::string known;
  for (const std::string& option : options) known += (known.empty() ? "" : ", ") + option;
  if (options.contains(against.option)) throw riprap::InvalidInput("--against: no run has " + text);
  throw riprap::InvalidInput("--against: '" + against.option +
                             "' is not what runs of the table differ in: " + known);
}

const Combination* reference_of(const Combination& combination, const Against& against,
                                const std::vector<Combination>& all) {
  const Run& run = combination.first();
  const bool is_row = against.option == "row";
  if (!is_row && !has_coordinate(run, against.option)) return nullptr;
  for (const Combination& other : all) {
    const Run& first = other.first();
    if (value_of(first, against.option) != against.value) continue;
    if (!is_row && (first.row != run.row || !agrees(first, run, against.option))) continue;
    if (agrees(run, first, against.option)) return &other == &combination ? nullptr : &other;
  }
  return nullptr;
}

std::vector<double> paired_differences(const Combination& combination, const Combination& reference,
                                       std::size_t column) {
  std::vector<double> out;
  for (const FinishedRun* run : combination.runs)
    for (const FinishedRun* other : reference.runs)
      if (run->run->seed == other->run->seed)
        out.push_back(run->results[column] - other->results[column]);
  return out;
}

}  // namespace run_study
