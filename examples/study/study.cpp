// SPDX-License-Identifier: BSL-1.0
// study: biaxial tests of a table on one machine or several, resumable, with statistics and plots

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "combinations.hpp"
#include "options.hpp"
#include "plot.hpp"
#include "run_folder.hpp"
#include "run_lock.hpp"
#include "tables.hpp"

namespace {

namespace fs = std::filesystem;
using namespace run_study;

// Of sysexits.h: not finished, and worth another call.
constexpr int not_finished = 75;

Study read_study(const Options& o) {
  TableFile file = read_table(table_path(o.table));
  for (TableRow& row : file.rows)
    if (o.seeds > 0 && row.seeds.size() > o.seeds) row.seeds.resize(o.seeds);
  return study_of(file);
}

void list_runs(const Study& study, const Options& o) {
  for (const Run& run : runs_of_shard(study.runs, o.shard)) {
    const RunFolder folder(o.making.folder, run);
    const RunLock lock(folder.finished());
    const bool held = lock.is_held();
    std::printf("%-10s %s%s\n", held ? "locked" : to_text(folder.state()).c_str(),
                run.folder.c_str(), held ? (" by " + lock.owner_text()).c_str() : "");
  }
}

// What is wrong is found before runs are made.
struct Wanted {
  std::optional<Against> against;
  std::vector<Plot> plots{};
};
Wanted wanted_results(const Study& study, const Options& o) {
  Wanted wanted;
  if (!o.against.empty()) wanted.against = against_from(o.against, study.runs);
  for (const std::string& text : o.plots) {
    wanted.plots.push_back(plot_from(text, o.where));
    wanted.plots.back().log_x = o.log_x;
    check_plot(wanted.plots.back(), study);
  }
  return wanted;
}

std::size_t count_finished(const Study& study, const fs::path& folder) {
  return static_cast<std::size_t>(std::ranges::count_if(study.runs, [&](const Run& run) {
    return RunFolder(folder, run).state() == RunState::finished;
  }));
}

// False if a plot cannot be drawn of what is there.
bool write_results(const Study& study, const Wanted& wanted, const fs::path& folder) {
  const std::vector<FinishedRun> runs = finished_runs(study, folder);
  if (runs.empty()) return true;
  const std::vector<Combination> all = combinations_of(runs);
  riprap::write_file(folder / "runs.csv", runs_csv(study, runs));
  riprap::write_file(folder / "summary.csv", summary_csv(study, all, wanted.against));
  riprap::write_file(folder / "table.md", table_md(study, all));
  std::string files = "runs.csv, summary.csv, table.md";
  bool all_drawn = true;
  for (const Plot& plot : wanted.plots) {
    try {
      riprap::chart_sheet({chart_of(plot, study, all)}).save(folder / file_name(plot));
      files += ", " + file_name(plot);
    } catch (const riprap::InvalidInput& error) {
      std::fprintf(stderr, "error: %s\n", error.what());
      all_drawn = false;
    }
  }
  std::printf("results in %s: %s\n", folder.c_str(), files.c_str());
  return all_drawn;
}

int exit_code(const Outcome& outcome, std::size_t runs) {
  std::printf(
      "%zu runs: %zu made, %zu were there, %zu failed, %zu unfinished, %zu at work elsewhere\n",
      runs, outcome.finished, outcome.kept, outcome.failed, outcome.unfinished, outcome.elsewhere);
  if (outcome.unfinished + outcome.elsewhere > 0) return not_finished;
  return outcome.failed > 0 ? command_line::failed : command_line::finished;
}

int make_study(const Options& o) {
  const Study study = read_study(o);
  if (o.list) {
    list_runs(study, o);
    return command_line::finished;
  }
  const Wanted wanted = wanted_results(study, o);
  int code = command_line::finished;
  if (!o.summary) {
    if (!fs::exists(o.making.program))
      throw riprap::InvalidInput("there is no program " + o.making.program.string() +
                                 ", which makes the runs");
    riprap::make_folder(o.making.folder);
    const std::vector<Run> runs = runs_of_shard(study.runs, o.shard);
    code = exit_code(make_runs(runs, o.making), runs.size());
  }
  const std::size_t finished = count_finished(study, o.making.folder);
  std::printf("%zu of the %zu runs of the table are finished\n", finished, study.runs.size());
  // Of many shards the last one, or a --summary, makes the tables.
  if (!o.summary && o.shard.count > 1 && finished < study.runs.size()) return code;
  const bool all_drawn = write_results(study, wanted, o.making.folder);
  return all_drawn || code != command_line::finished ? code : command_line::wrong_command;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  return command_line::run_program({}, [&] { return make_study(options); });
}
