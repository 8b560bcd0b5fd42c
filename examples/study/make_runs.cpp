// SPDX-License-Identifier: BSL-1.0
#include "make_runs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <mutex>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include "../command_line/program.hpp"
#include "../run_table/work_through.hpp"
#include "child.hpp"
#include "run_folder.hpp"
#include "run_lock.hpp"

namespace run_study {

namespace fs = std::filesystem;

namespace {

std::string text_of(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

// "finished", "interrupted" or "failed", as the summary of a run has it; nothing without one.
std::string status_in(const fs::path& folder) {
  const auto summary = nlohmann::json::parse(text_of(folder / "summary.json"), nullptr, false);
  if (!summary.is_object()) return {};
  return summary.value("status", "");
}

// The end of what a program has printed.
std::string last_lines(const fs::path& log) {
  const std::string text = text_of(log);
  constexpr std::size_t most = 2000;
  return text.size() > most ? "...\n" + text.substr(text.size() - most) : text;
}

// The axial strain that a run has reached, from the last whole row of its curve.
double strain_reached(const fs::path& folder) {
  const std::string text = text_of(folder / "curve.csv");
  const std::size_t end = text.rfind('\n');
  if (end == text.npos || end == 0) return 0;
  const std::size_t begin = text.rfind('\n', end - 1);
  return begin == text.npos ? 0 : std::strtod(text.c_str() + begin + 1, nullptr);
}

class Maker {
 public:
  Maker(const std::vector<Run>& runs, const Making& making) : making_(making) {
    for (const Run& run : runs) {
      const RunFolder folder(making.folder, run);
      folder.check_parameters();
      if (folder.state() == RunState::finished) {
        ++outcome_.kept;
        continue;
      }
      left_.push_back({&run, folder});
      work_ += run.work;
    }
  }

  Outcome make() {
    if (outcome_.kept > 0)
      std::fprintf(stderr, "%zu of %zu runs are there already\n", outcome_.kept,
                   outcome_.kept + left_.size());
    if (left_.empty()) return outcome_;
    run_table::work_through(
        left_.size(), making_.jobs, [&](std::size_t k) { make(left_[k]); }, [&] { watch(); });
    if (in_place_) std::fputc('\n', stderr);
    return outcome_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Left {
    const Run* run;
    RunFolder folder;
  };

  void make(const Left& left) {
    try {
      attempt(left);
    } catch (const std::exception& error) {
      note_failure(left, error.what(), false);
    }
  }

  void attempt(const Left& left) {
    if (stopped_) return count(outcome_.unfinished, *left.run);
    RunLock lock(left.folder.finished());
    if (!lock.acquire(making_.take_over)) return count(outcome_.elsewhere, *left.run);
    // Another study may have been here since.
    const RunState state = left.folder.state();
    if (state == RunState::finished) return count(outcome_.kept, *left.run);
    if (state == RunState::failed && !making_.retry)
      return note_failure(left, "it has failed before; --retry makes it again", false);
    left.folder.forget_failure();
    left.folder.prepare();
    const pid_t child = children_.start(command(left.folder), left.folder.part() / "log.txt");
    if (child == 0) return count(outcome_.unfinished, *left.run);
    begin(left);
    lock.note_child(child);
    const Exit exit = children_.wait(child);
    end(left);
    judge(left, exit);
  }

  [[nodiscard]] std::vector<std::string> command(const RunFolder& folder) const {
    std::vector<std::string> words{making_.program.string()};
    const std::string part = folder.part().string();
    if (making_.checkpoint_every > 0 && folder.has_checkpoint())
      words.insert(words.end(), {"--resume", part});
    else
      words.insert(words.end(),
                   {"--config", (folder.part() / "parameters.toml").string(), "--out", part});
    if (making_.checkpoint_every > 0)
      words.insert(words.end(), {"--checkpoint-every", std::to_string(making_.checkpoint_every)});
    if (making_.threads > 1)
      words.insert(words.end(), {"--threads", std::to_string(making_.threads)});
    return words;
  }

  void judge(const Left& left, const Exit& exit) {
    if (exit.signal == 0 && exit.code == 0) {
      left.folder.finish();
      return count(outcome_.finished, *left.run);
    }
    // It has been told to stop, by this program or by somebody else.
    const bool told = exit.signal == SIGTERM || exit.signal == SIGINT || exit.signal == SIGUSR1;
    if (stopped_ || told || status_in(left.folder.part()) == "interrupted")
      return count(outcome_.unfinished, *left.run);
    // A command that the program refuses says nothing about the run.
    const bool refused = exit.signal == 0 && exit.code == command_line::wrong_command;
    const std::string log = last_lines(left.folder.part() / "log.txt");
    note_failure(left,
                 refused ? "the program refuses the command: " + log : exit.text() + "\n" + log,
                 !refused);
  }

  void begin(const Left& left) {
    const std::scoped_lock lock(mutex_);
    running_.push_back(&left);
  }
  void end(const Left& left) {
    const std::scoped_lock lock(mutex_);
    std::erase(running_, &left);
  }
  void count(std::size_t& counter, const Run& run) {
    const std::scoped_lock lock(mutex_);
    ++counter;
    (&counter == &outcome_.finished ? made_ : passed_) += run.work;
  }
  void note_failure(const Left& left, const std::string& reason, bool is_new) {
    if (is_new) left.folder.fail(reason);
    const std::scoped_lock lock(mutex_);
    passed_ += left.run->work;
    ++outcome_.failed;
    std::fprintf(stderr, "%s%s: %s\n", in_place_ ? "\n" : "", left.run->folder.c_str(),
                 reason.substr(0, reason.find('\n')).c_str());
  }

  void watch() {
    if (const int signal = NotedSignals::take()) {
      stopped_ = true;
      children_.close();
      // Without checkpoints the biaxial example does not know SIGUSR1, which would kill it.
      if (signal != SIGUSR1 || making_.checkpoint_every > 0) children_.send(signal);
      if (signal == SIGUSR1) children_.send(SIGTERM);
    }
    const auto now = Clock::now();
    if (now < next_print_) return;
    next_print_ = now + std::chrono::milliseconds(in_place_ ? 500 : 20000);
    print(std::chrono::duration<double>(now - begun_).count());
  }

  void print(double elapsed) {
    const std::scoped_lock lock(mutex_);
    double made = made_;
    for (const Left* left : running_) {
      const double strain = std::strtod(left->run->parameters.at("strain").c_str(), nullptr);
      if (strain > 0)
        made += left->run->work * std::min(1.0, strain_reached(left->folder.part()) / strain);
    }
    const double left = work_ - passed_ - made;
    std::string line = std::to_string(outcome_.finished) + " of " + std::to_string(left_.size()) +
                       " runs made, " + std::to_string(running_.size()) + " running, " +
                       run_table::duration_text(elapsed);
    // An estimate from the first per cent is worth nothing.
    if (stopped_)
      line += ", stopping";
    else if (made > 0.01 * (work_ - passed_) && left > 0)
      line += ", about " + run_table::duration_text(elapsed * left / made) + " left";
    if (in_place_)
      std::fprintf(stderr, "\r%-78.78s", line.c_str());
    else
      std::fprintf(stderr, "%s\n", line.c_str());
  }

  Making making_;
  NotedSignals signals_;
  Children children_;
  std::vector<Left> left_;
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;  // of what follows
  Outcome outcome_;
  std::vector<const Left*> running_;
  double work_ = 0;    // of all runs that are left
  double made_ = 0;    // of those that were made now
  double passed_ = 0;  // of those that need not, or could not be made
  const bool in_place_ = isatty(fileno(stderr)) != 0;
  const Clock::time_point begun_ = Clock::now();
  Clock::time_point next_print_ = begun_ + std::chrono::seconds(1);
};

}  // namespace

Outcome make_runs(const std::vector<Run>& runs, const Making& making) {
  return Maker(runs, making).make();
}

}  // namespace run_study
