// SPDX-License-Identifier: BSL-1.0
// Runs made by a program that stands for the biaxial example.
#include <study/make_runs.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <sstream>
#include <thread>

#include <study/run_folder.hpp>
#include <study/run_lock.hpp>
#include <support/message_of.hpp>
#include <support/temporary_folder.hpp>
#include <unistd.h>

using namespace run_study;
using riprap::test::contains;
using riprap::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

// Notes in ../starts how it was called; seed 13 fails, seed 15 is refused, seed 14 goes on until it
// is told to stop, or is resumed. It writes a checkpoint at SIGUSR1 and its summary at SIGTERM.
constexpr auto program_text = R"(#!/usr/bin/env bash
while (($#)); do
  case $1 in
    --out) out=$2 ;;
    --resume) out=$2 resumed=resumed ;;
    --checkpoint-every) every=$2 ;;
  esac
  shift 2
done
stop() { echo '{"status": "interrupted"}' >"$out/summary.json"; exit 1; }
trap stop TERM
trap 'mkdir -p "$out/checkpoints"; touch "$out/checkpoints/1"' USR1
seed=$(sed -n 's/^seed = //p' "$out/parameters.toml")
echo "$seed ${resumed:-new} ${every:-0}" >>"${out%/*}/starts"
if ((seed == 13)); then echo "out of control"; exit 1; fi
if ((seed == 15)); then echo "no such option"; exit 2; fi
while ((seed == 14)) && [[ -z ${resumed:-} ]]; do sleep 0.02; done
echo '{"status": "finished"}' >"$out/summary.json"
)";

struct FakeStudy {
  TemporaryFolder folder;
  Making making;

  FakeStudy() {
    folder.write("program", program_text);
    fs::permissions(folder / "program", fs::perms::owner_all);
    making.folder = folder / "study";
    fs::create_directories(making.folder);
    making.program = folder / "program";
    making.jobs = 2;
  }
  [[nodiscard]] static std::vector<Run> runs(const std::string& seeds) {
    return study_of(table_from_toml("t.toml", "seeds = " + seeds + "\n")).runs;
  }
  [[nodiscard]] Outcome make(const std::string& seeds) const {
    return make_runs(runs(seeds), making);
  }
  // Sorted, each with a blank behind it.
  [[nodiscard]] std::string starts() const {
    std::istringstream text(folder.text("study/starts"));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    std::ranges::sort(lines);
    std::string all;
    for (const std::string& line : lines) all += line + "; ";
    return all;
  }
  [[nodiscard]] bool has(const std::string& name) const { return fs::exists(making.folder / name); }
  // Sends this process a signal once a run has begun.
  [[nodiscard]] std::jthread signal_later(int signal, const std::string& begun) const {
    return std::jthread([this, signal, begun] {
      while (!contains(starts(), begun)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
      ::kill(::getpid(), signal);
    });
  }
};

}  // namespace

TEST_CASE("what is finished has its name and is not made again") {
  const FakeStudy study;
  Outcome outcome = study.make("[1, 2]");
  CHECK(outcome.finished == 2);
  CHECK(study.has("seed=1/summary.json"));
  CHECK(!study.has("seed=1.part"));
  CHECK(!study.has("seed=1.lock"));
  CHECK(study.folder.text("study/seed=2/parameters.toml") == FakeStudy::runs("[2]")[0].toml);
  outcome = study.make("[1, 2, 3]");
  CHECK(outcome.kept == 2);
  CHECK(outcome.finished == 1);
  CHECK(study.starts() == "1 new 0; 2 new 0; 3 new 0; ");
}

TEST_CASE("a run that fails leaves its message, and is made again on demand") {
  FakeStudy study;
  Outcome outcome = study.make("[1, 13]");
  CHECK(outcome.finished == 1);
  CHECK(outcome.failed == 1);
  CHECK(study.folder.text("study/seed=13.failed/error.txt") == "exit code 1\nout of control\n\n");
  CHECK(!study.has("seed=13.part"));
  CHECK(study.make("[1, 13]").failed == 1);
  CHECK(study.starts() == "1 new 0; 13 new 0; ");
  study.making.retry = true;
  CHECK(study.make("[1, 13]").failed == 1);
  CHECK(study.starts() == "1 new 0; 13 new 0; 13 new 0; ");
}

TEST_CASE("a command that the program refuses is no failure of the run") {
  const FakeStudy study;
  CHECK(study.make("[15]").failed == 1);
  CHECK(!study.has("seed=15.failed"));
  CHECK(study.make("[15]").failed == 1);
  CHECK(study.starts() == "15 new 0; 15 new 0; ");
}

TEST_CASE("runs that another study is making are left out") {
  const FakeStudy study;
  RunLock lock(study.making.folder / "seed=1");
  CHECK(lock.acquire(false));
  Outcome outcome = study.make("[1, 2]");
  CHECK(outcome.elsewhere == 1);
  CHECK(outcome.finished == 1);
  lock.release();
  outcome = study.make("[1, 2]");
  CHECK(outcome.finished == 1);
}

TEST_CASE("two studies in one folder make each run once") {
  const FakeStudy study;
  Outcome a;
  {
    const std::jthread other([&] { a = study.make("12"); });
    const Outcome b = study.make("12");
    CHECK(b.failed + b.unfinished == 0);
  }
  CHECK(a.failed + a.unfinished == 0);
  CHECK(std::ranges::count(study.starts(), ';') == 12);
}

TEST_CASE("a study that is stopped leaves its runs to be gone on with") {
  FakeStudy study;
  study.making.jobs = 1;
  {
    const std::jthread sender = study.signal_later(SIGTERM, "14 new");
    const Outcome outcome = study.make("[1, 14, 2]");
    CHECK(outcome.finished == 1);
    CHECK(outcome.unfinished == 2);
  }
  CHECK(study.folder.text("study/seed=14.part/summary.json") == "{\"status\": \"interrupted\"}\n");
  CHECK(!study.has("seed=14.lock"));
  CHECK(!study.has("seed=2.part"));
}

TEST_CASE("with checkpoints SIGUSR1 has one written, and the run goes on from it") {
  FakeStudy study;
  study.making.checkpoint_every = 100;
  {
    const std::jthread sender = study.signal_later(SIGUSR1, "14 new");
    CHECK(study.make("[14]").unfinished == 1);
  }
  CHECK(study.has("seed=14.part/checkpoints/1"));
  CHECK(study.make("[14]").finished == 1);
  CHECK(study.starts() == "14 new 100; 14 resumed 100; ");
  CHECK(study.has("seed=14/checkpoints/1"));
}

TEST_CASE("runs of other parameters are not mixed") {
  const FakeStudy study;
  CHECK(study.make("[1]").finished == 1);
  auto runs = FakeStudy::runs("[1]");
  runs[0].toml += "more = 1\n";
  const std::string message =
      riprap::test::message_of([&] { (void)make_runs(runs, study.making); });
  CHECK(contains(message, "was made with other parameters than those of the table"));
  CHECK(contains(message, "'' in place of 'more = 1'"));
}
