// SPDX-License-Identifier: BSL-1.0
// table ROUNDS JSON PACKAGES [NOTE...]  reads what all programs have printed, a line each behind
// round, kind and number of grains, prints the table of medians and writes it to JSON with the
// single rounds. PACKAGES says which versions of the other codes have run, notes what has not.

#include <algorithm>
#include <exception>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace peers {
namespace {

using nlohmann::ordered_json;

// One code at one task: its value of each key in each round.
struct Row {
  std::string kind;  // step, checks/2MPa, checks/14MPa
  unsigned grains = 0;
  std::string name;
  std::map<std::string, std::map<int, double>> values;
};

[[nodiscard]] std::vector<Row> read_rounds(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot read " + path);
  std::vector<Row> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream fields(line);
    std::string round, kind, grains, name;
    for (std::string* field : {&round, &kind, &grains, &name}) std::getline(fields, *field, '\t');
    const auto number = static_cast<unsigned>(std::stoul(grains));
    auto row = std::find_if(rows.begin(), rows.end(), [&](const Row& r) {
      return r.kind == kind && r.grains == number && r.name == name;
    });
    if (row == rows.end())
      row =
          rows.insert(rows.end(), Row{.kind = kind, .grains = number, .name = name, .values = {}});
    for (std::string pair; std::getline(fields, pair, '\t');) {
      const std::size_t equals = pair.find('=');
      row->values[pair.substr(0, equals)][std::stoi(round)] = std::stod(pair.substr(equals + 1));
    }
  }
  if (rows.empty()) throw std::runtime_error("no results in " + path);
  return rows;
}

[[nodiscard]] double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

[[nodiscard]] std::vector<double> all(const Row& row, const std::string& key) {
  std::vector<double> out;
  if (const auto found = row.values.find(key); found != row.values.end())
    for (const auto& [round, value] : found->second) out.push_back(value);
  return out;
}

// Median over the rounds of the ratio within a round; 0 where the other one is missing.
[[nodiscard]] double ratio(const Row& row, const Row* other) {
  if (!other) return 0;
  std::vector<double> ratios;
  const auto& others = other->values.at("ns");
  for (const auto& [round, value] : row.values.at("ns"))
    if (const auto found = others.find(round); found != others.end())
      ratios.push_back(value / found->second);
  return median(ratios);
}

// The row of steps of the code whose name begins and ends so.
[[nodiscard]] const Row* find(const std::vector<Row>& rows, unsigned grains,
                              const std::string& begin, const std::string& end) {
  for (const Row& row : rows)
    if (row.kind == "step" && row.grains == grains && row.name.starts_with(begin) &&
        row.name.ends_with(end))
      return &row;
  return nullptr;
}

// Whatever differs between the codes, beside what the table says itself.
constexpr const char* differences[] = {
    "N counts all grains, those of the ring too (15 % of 500, 5 % of 5000), which do not touch "
    "each other. CPU time of the stepping alone; ratios are the medians of the ratios within a "
    "round.",

    "Steps are not equal: riprap and LAMMPS take the one that springs of 2e7 N/m ask for, Box2D "
    "and Chipmunk 1/60 s with 1e-5 of axial strain in it.",

    "Contact models: riprap and LAMMPS discs have linear springs with tangential history and "
    "Coulomb slip. LAMMPS polygons have springs at corners near an edge, without history, and its "
    "mu does not act as tangential friction. Box2D (8 velocity and 3 position iterations) and "
    "Chipmunk (10) exchange impulses between rigid bodies and can hold no prescribed stiffness.",

    "Damping: riprap local damping of 0.7, LAMMPS dashpots of 0.3 critical in the contacts, the "
    "engines no restitution.",

    "Packings: round samples of both sizes cut from one periodic sample of 500 grains in early "
    "shear, the outermost mean diameter of it as ring; neighbours lie together in memory. Polygons "
    "have 5 to 8 corners (Box2D takes no more than 8) and 2 MPa; LAMMPS rounds corners with 0.02 "
    "of the mean size and Box2D has a skin of 0.01 of it, both inside the outline. Discs come from "
    "a periodic sample of regular polygons with 16 corners, with the same distribution of sizes "
    "but at 5 MPa, to have as many contacts, and so overlap more.",

    "Confinement: in riprap and LAMMPS the ring keeps the mean strain rates of the periodic "
    "sample, for the same steps in both, and the stress rises; the engines widen so that contacts "
    "stay as many as in that.",

    "Contacts are those of a free grain: overlapping pairs in riprap and LAMMPS, pairs with an "
    "impulse in the engines. Overlap is the mean depth over the mean size.",

    "Precision is double, in Box2D single. riprap is built with the flags in its name and "
    "-ffp-contract=off, the others as their packages were: Debian's Chipmunk has its assertions "
    "on, and LAMMPS runs as one process with one thread. With -march=x86-64-v3 g++ 12 fuses some "
    "products and sums all the same, so that the last bits of riprap's two builds differ.",

    "Checking: sharp grains (3 to 5 corners) within a ring, shear stage of a biaxial test. CPU "
    "time of it times the share that a clock gives to bound, check and splitting; that pieces "
    "are more grains with more contacts is not counted."};

[[nodiscard]] std::string processor() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

// A number, or a dash for none.
[[nodiscard]] std::string text(double value, int digits) {
  if (value == 0) return "-";
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << value;
  return out.str();
}

class Table {
 public:
  Table(std::vector<Row> rows, const std::string& packages, std::vector<std::string> notes)
      : rows_(std::move(rows)), notes_(std::move(notes)) {
    notes_.insert(notes_.begin(), std::begin(differences), std::end(differences));
    std::size_t rounds = 0;
    for (const Row& row : rows_) rounds = std::max(rounds, row.values.at("ns").size());
    json_ = {{"rounds", rounds},     {"processor", processor()},      {"compiler", RIPRAP_COMPILER},
             {"packages", packages}, {"rows", ordered_json::array()}, {"notes", notes_}};
    std::cout << processor() << ", " << RIPRAP_COMPILER << ", " << rounds << " rounds\n"
              << packages << '\n';
  }

  void print_steps() {
    std::cout << "\nStep without breakage, ns per particle-step\n"
              << "     N  code                               median    best   worst"
                 "  / riprap -O2  / -O3 v3  contacts  overlap %\n";
    for (const Row& row : rows_) {
      if (row.kind != "step") continue;
      const double to_o2 = ratio(row, find(rows_, row.grains, "riprap", "-O2"));
      const double to_o3 = ratio(row, find(rows_, row.grains, "riprap -O3", ""));
      print_head(row);
      std::cout << std::setw(14) << text(to_o2, 2) << std::setw(10) << text(to_o3, 2)
                << std::setw(10) << text(median(all(row, "coordination")), 2) << std::setw(11)
                << text(100 * median(all(row, "overlap")), 2) << '\n';
      add_json(row, {{"ratio_to_riprap_O2", to_o2}, {"ratio_to_riprap_O3", to_o3}});
    }
  }

  void print_checks() {
    std::cout << "\nAll checking of stress in a biaxial test, ns per particle-step of shear\n"
              << "     N  code                               median    best   worst"
                 "  / LAMMPS discs    breaks  strain %\n";
    for (const Row& row : rows_) {
      if (row.kind == "step") continue;
      const double to_discs = ratio(row, find(rows_, row.grains, "LAMMPS", "discs"));
      print_head(row);
      std::cout << std::setw(16) << text(to_discs, 2) << std::setw(10)
                << text(median(all(row, "breaks")), 0) << std::setw(10)
                << text(100 * median(all(row, "strain")), 1) << '\n';
      add_json(row, {{"ratio_to_LAMMPS_discs", to_discs}});
    }
  }

  void print_notes() const {
    std::cout << "\nNot like for like:\n";
    for (const std::string& note : notes_) std::cout << "- " << note << '\n';
  }

  void write(const std::string& path) const {
    std::ofstream out(path);
    out << json_.dump(2) << '\n';
    if (!out.flush()) throw std::runtime_error("cannot write " + path);
  }

 private:
  static void print_head(const Row& row) {
    const std::vector<double> ns = all(row, "ns");
    const std::string task =
        row.kind == "step" ? "" : ", " + row.kind.substr(row.kind.find('/') + 1);
    std::cout << std::setw(6) << row.grains << "  " << std::left << std::setw(32) << row.name + task
              << std::right << std::setw(9) << text(median(ns), 1) << std::setw(8)
              << text(*std::min_element(ns.begin(), ns.end()), 1) << std::setw(8)
              << text(*std::max_element(ns.begin(), ns.end()), 1);
  }

  void add_json(const Row& row, const ordered_json& ratios) {
    const std::vector<double> ns = all(row, "ns");
    ordered_json entry = {{"kind", row.kind},
                          {"grains", row.grains},
                          {"code", row.name},
                          {"median_ns", median(ns)},
                          {"best_ns", *std::min_element(ns.begin(), ns.end())},
                          {"worst_ns", *std::max_element(ns.begin(), ns.end())}};
    entry.update(ratios);
    for (const auto& [key, rounds] : row.values)
      if (key != "ns") entry[key] = median(all(row, key));
    entry["rounds_ns"] = ns;
    json_["rows"].push_back(entry);
  }

  std::vector<Row> rows_;
  std::vector<std::string> notes_;
  ordered_json json_;
};

}  // namespace
}  // namespace peers

int main(int count, char** arguments) try {
  if (count < 4) throw std::runtime_error("table ROUNDS JSON PACKAGES [NOTE...]");
  peers::Table table(peers::read_rounds(arguments[1]), arguments[3],
                     {arguments + 4, arguments + count});
  table.print_steps();
  table.print_checks();
  table.print_notes();
  table.write(arguments[2]);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
