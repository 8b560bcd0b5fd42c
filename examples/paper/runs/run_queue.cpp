// SPDX-License-Identifier: BSL-1.0
// Which runs are left, threads that make them, and a line that says how far they are.

#include "run_queue.hpp"

#include <chrono>
#include <cstdio>
#include <exception>
#include <fstream>
#include <memory>
#include <mutex>

#include <unistd.h>

#include "../../run_table/work_through.hpp"
#include "study_run.hpp"

namespace study {

namespace fs = std::filesystem;

namespace {

struct Task {
  RunPlan plan;
  fs::path folder;
  WorkDone done{0};
  Task(const RunPlan& p, fs::path f) : plan(p), folder(std::move(f)) {}
};

// What keeps a folder from holding this finished run: nothing, that there is none, or a reason to
// make it again.
struct Finding {
  bool finished = false;
  std::string other;
};

Finding find_run(const RunPlan& plan, const fs::path& folder) {
  std::ifstream file(folder / "run.json");
  if (!file) return {};
  const Json found = Json::parse(file, nullptr, false);
  if (found.is_discarded() || !found.contains("parameters")) return {false, "cannot be read"};
  const Json wanted = plan.parameters();
  if (found["parameters"] == wanted) return {true, ""};
  const Json differences = Json::diff(found["parameters"], wanted);
  return {false, "was made with another " + differences.at(0)["path"].get<std::string>()};
}

void make_run(const RunPlan& plan, const fs::path& folder, WorkDone& done) {
  // Nothing of an earlier run is to be taken for a part of this one.
  fs::remove_all(folder);
  fs::create_directories(folder);
  switch (plan.variation) {
  case Variation::mean_tension_line:
  case Variation::failure_plane:
    return run_line_fit(plan, folder, done);
  case Variation::two_pinned_contacts:
    return run_pinned(plan, folder, done);
  case Variation::periodic_cell:
    return run_periodic(plan, folder, done);
  case Variation::recommended_preset:
    return run_recommended(plan, folder, done);
  case Variation::paper_preset:
    return run_paper(plan, folder, done);
  default:
    return plan.mode == Mode::nb ? run_nb(plan, folder, done) : run_wb(plan, folder, done);
  }
}

// The runs that are left and the threads' way through them.
class Queue {
 public:
  explicit Queue(std::vector<std::unique_ptr<Task>> tasks) : tasks_(std::move(tasks)) {
    for (const auto& task : tasks_) work_ += task->plan.work();
  }

  void run(unsigned jobs) {
    run_table::work_through(
        tasks_.size(), jobs, [this](std::size_t k) { make(*tasks_[k]); }, [this] { watch(); });
    print();
    if (in_place_) std::fputc('\n', stderr);
  }

  [[nodiscard]] const std::vector<std::string>& failed() const { return failed_; }

 private:
  using Clock = std::chrono::steady_clock;

  void make(Task& task) {
    std::string error;
    try {
      make_run(task.plan, task.folder, task.done);
    } catch (const std::exception& e) {
      error = e.what();
    }
    const std::scoped_lock lock(mutex_);
    task.done = task.plan.work();
    ++ended_;
    if (!error.empty()) note_failure(task, error);
  }

  void note_failure(const Task& task, const std::string& error) {
    failed_.push_back(task.folder.string());
    std::ofstream(task.folder / "error.txt") << error << "\n";
    std::fprintf(stderr, "%s%s failed: %s\n", in_place_ ? "\n" : "", task.plan.name().c_str(),
                 error.c_str());
  }

  void watch() {
    const auto now = Clock::now();
    if (now < next_print_) return;
    next_print_ = now + std::chrono::milliseconds(in_place_ ? 500 : 20000);
    print();
  }

  void print() {
    const std::scoped_lock lock(mutex_);
    double done = 0;
    std::string running;
    for (const auto& task : tasks_) {
      const double share = task->done / task->plan.work();
      done += task->done;
      if (share > 0 && share < 1)
        running +=
            "  " + task->plan.name() + " " + std::to_string(static_cast<int>(100 * share)) + " %";
    }
    const double share = done / work_;
    const double elapsed = std::chrono::duration<double>(Clock::now() - begun_).count();
    std::string line = std::to_string(ended_) + " of " + std::to_string(tasks_.size()) + " runs, " +
                       std::to_string(static_cast<int>(100 * share)) + " %, " +
                       run_table::duration_text(elapsed);
    // An estimate from the first per cent is worth nothing.
    if (share > 0.01 && share < 1)
      line += ", about " + run_table::duration_text(elapsed * (1 - share) / share) + " left";
    line += running;
    if (in_place_)
      std::fprintf(stderr, "\r%-110.110s", line.c_str());
    else
      std::fprintf(stderr, "%s\n", line.c_str());
    std::fflush(stderr);
  }

  std::vector<std::unique_ptr<Task>> tasks_;
  double work_ = 0;
  std::mutex mutex_;
  std::size_t ended_ = 0;
  std::vector<std::string> failed_;
  bool in_place_ = isatty(fileno(stderr)) != 0;
  const Clock::time_point begun_ = Clock::now();
  Clock::time_point next_print_ = begun_ + std::chrono::milliseconds(500);
};

}  // namespace

StudyOutcome make_runs(const std::vector<RunPlan>& plans, const fs::path& folder, unsigned jobs) {
  StudyOutcome outcome;
  std::vector<std::unique_ptr<Task>> tasks;
  for (const RunPlan& plan : plans) {
    const fs::path place = folder / plan.folder();
    const Finding found = find_run(plan, place);
    if (found.finished) {
      ++outcome.kept;
      continue;
    }
    if (!found.other.empty())
      std::fprintf(stderr, "%s %s: it is made again\n", place.string().c_str(),
                   found.other.c_str());
    tasks.push_back(std::make_unique<Task>(plan, place));
  }
  if (outcome.kept > 0)
    std::fprintf(stderr, "%zu of %zu runs are there already\n", outcome.kept, plans.size());
  if (tasks.empty()) return outcome;
  const std::size_t left = tasks.size();
  Queue queue(std::move(tasks));
  queue.run(jobs);
  outcome.failed = queue.failed();
  outcome.finished = left - outcome.failed.size();
  return outcome;
}

}  // namespace study
