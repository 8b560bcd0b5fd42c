// SPDX-License-Identifier: BSL-1.0
// contact_models: contact models compared in the biaxial test: strength, energy, breakages, cost
// Runs that the folder has already are kept, so that a study can be stopped and continued.

#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "../command_line/program.hpp"
#include "run.hpp"

namespace fs = std::filesystem;
using namespace contact_models;

namespace {

struct NamedModel {
  const char* name;
  const char* description;
  Result (*run)(const Setup&);
};
const std::vector<NamedModel> models{
    {"chord", "OverlapChord, LinearSpringCoulomb", run_chord},
    {"incremental", "OverlapChord, IncrementalSpring", run_incremental},
    {"area", "OverlapChord, OverlapAreaSpring", run_area},
    {"moments", "OverlapMoments, EnergyConservingSpring", run_moments},
};

struct Options {
  std::vector<double> pressures{0.5, 2, 8, 14};  // [MPa]
  unsigned samples = 8;
  unsigned particles = 500;
  double strain = 0.2;
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string out = "contact_models";
};

struct Task {
  const NamedModel* model;
  Setup setup;
  fs::path file;
};

// What the result depends on: a file with another first line is made again.
std::string key(const Task& task) {
  char text[160];
  std::snprintf(text, sizeof text, "# %s, %g MPa, seed %llu, %u particles, strain %g",
                task.model->description, 1e-6 * task.setup.pressure,
                static_cast<unsigned long long>(task.setup.seed), task.setup.particles,
                task.setup.strain);
  return text;
}

void write(const Task& task, const Result& result) {
  std::string text = key(task) + "\n";
  for (const Column& column : columns) {
    char number[80];
    std::snprintf(number, sizeof number, "%s,%.17g\n", column.name, result.*column.value);
    text += number;
  }
  fs::path partial = task.file;
  partial += ".part";
  std::ofstream(partial) << text;
  fs::rename(partial, task.file);
}

bool read(const Task& task, Result& result) {
  std::ifstream file(task.file);
  std::string line;
  if (!std::getline(file, line) || line != key(task)) return false;
  for (const Column& column : columns) {
    if (!std::getline(file, line)) return false;
    const auto comma = line.find(',');
    if (comma == std::string::npos || line.substr(0, comma) != column.name) return false;
    result.*column.value = std::stod(line.substr(comma + 1));
  }
  return true;
}

// Makes the runs that are missing; says how far it is.
void make_runs(const std::vector<Task>& tasks, unsigned jobs) {
  std::vector<const Task*> missing;
  Result unused;
  for (const Task& task : tasks)
    if (!read(task, unused)) missing.push_back(&task);
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex mutex;
  std::string error;
  const double begin = static_cast<double>(std::time(nullptr));
  {
    std::vector<std::jthread> threads;
    for (unsigned j = 0; j < jobs; ++j)
      threads.emplace_back([&] {
        for (std::size_t k = next++; k < missing.size(); k = next++) {
          const Task& task = *missing[k];
          try {
            write(task, task.model->run(task.setup));
          } catch (const std::exception& e) {
            const std::scoped_lock lock(mutex);
            error = task.file.string() + ": " + e.what();
          }
          const std::scoped_lock lock(mutex);
          ++done;
          const double minutes = (static_cast<double>(std::time(nullptr)) - begin) / 60;
          std::fprintf(stderr, "%zu of %zu runs, about %.0f min left\n", done, missing.size(),
                       minutes * static_cast<double>(missing.size() - done) /
                           static_cast<double>(done));
        }
      });
  }
  if (!error.empty()) throw std::runtime_error(error);
}

// Mean and standard deviation of a sample.
std::string cell(const std::vector<double>& values, const char* format, double unit = 1) {
  double mean = 0;
  for (const double v : values) mean += unit * v / static_cast<double>(values.size());
  double squares = 0;
  for (const double v : values) squares += (unit * v - mean) * (unit * v - mean);
  char text[80];
  if (values.size() < 2) {
    std::snprintf(text, sizeof text, format, mean);
    return text;
  }
  const std::string both = std::string(format) + " ± " + format;
  std::snprintf(text, sizeof text, both.c_str(), mean,
                std::sqrt(squares / static_cast<double>(values.size() - 1)));
  return text;
}

struct TableColumn {
  const char* title;
  double Result::*value;
  const char* format;
  double unit;
};
constexpr std::array<TableColumn, 10> table_columns{
    {{"peak sin φ", &Result::peak, "%.3f", 1},
     {"residual", &Result::residual, "%.3f", 1},
     {"volume %", &Result::volumetric_strain, "%.1f", 100},
     {"2M/N", &Result::coordination, "%.2f", 1},
     {"breakages", &Result::breakages, "%.0f", 1},
     {"law %", &Result::law, "%.2f", 100},
     {"splitting %", &Result::splitting, "%.2f", 100},
     {"damping %", &Result::damping, "%.1f", 100},
     {"overlap %", &Result::overlap, "%.2f", 100},
     {"step µs", &Result::step_time, "%.0f", 1}}};

std::string table(const std::vector<Task>& tasks) {
  std::string text = "| MPa | model |";
  std::string rule = "\n|---|---|";
  for (const TableColumn& column : table_columns) {
    text += std::string(" ") + column.title + " |";
    rule += "---|";
  }
  text += rule + "\n";
  std::map<std::pair<double, const NamedModel*>, std::vector<Result>> rows;
  std::vector<std::pair<double, const NamedModel*>> order;
  for (const Task& task : tasks) {
    const std::pair key{task.setup.pressure, task.model};
    if (!rows.contains(key)) order.push_back(key);
    read(task, rows[key].emplace_back());
  }
  for (const auto& row : order) {
    char pressure[32];
    std::snprintf(pressure, sizeof pressure, "| %g | ", 1e-6 * row.first);
    text += pressure + std::string(row.second->name) + " |";
    for (const TableColumn& column : table_columns) {
      std::vector<double> values;
      for (const Result& r : rows[row]) values.push_back(r.*column.value);
      text += " " + cell(values, column.format, column.unit) + " |";
    }
    text += "\n";
  }
  return text;
}

int compare(const Options& o) {
  fs::create_directories(o.out);
  std::vector<Task> tasks;
  for (const double pressure : o.pressures)
    for (const NamedModel& model : models)
      for (unsigned seed = 1; seed <= o.samples; ++seed) {
        std::ostringstream name;
        name << model.name << "_" << pressure << "MPa_" << seed << ".csv";
        tasks.push_back(
            {&model, {1e6 * pressure, seed, o.particles, o.strain}, fs::path(o.out) / name.str()});
      }
  make_runs(tasks, o.jobs);
  const std::string text = table(tasks);
  std::ofstream(fs::path(o.out) / "table.md") << text;
  std::fputs(text.c_str(), stdout);
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  CLI::App app{"Contact models compared in the biaxial test. Mean and standard deviation of the "
               "samples; energies as shares of the boundary work, what is made is negative."};
  app.add_option("--pressures", o.pressures, "confining pressures [MPa]")->capture_default_str();
  app.add_option("--samples", o.samples, "seeds 1, 2, ...")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--particles", o.particles, "of a sample")->capture_default_str();
  app.add_option("--strain", o.strain, "axial strain of shear")->capture_default_str();
  app.add_option("--jobs", o.jobs, "runs at a time")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--out", o.out, "folder of the results; runs in it are kept")
      ->capture_default_str();
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  return command_line::run_program({}, [&] { return compare(o); });
}
