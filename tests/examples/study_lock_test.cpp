// SPDX-License-Identifier: BSL-1.0
#include <study/run_lock.hpp>

#include <doctest/doctest.h>

#include <atomic>
#include <thread>
#include <vector>

#include <study/child.hpp>
#include <support/temporary_folder.hpp>
#include <unistd.h>

using namespace run_study;
using riprap::test::TemporaryFolder;

namespace {

// The name of this machine, as a lock has it.
std::string host(const TemporaryFolder& folder) {
  RunLock lock(folder / "host");
  REQUIRE(lock.acquire(false));
  const std::string owner = folder.text("host.lock/owner");
  return owner.substr(0, owner.find(' '));
}

// A number that no process has any more.
long number_of_ended_process(const TemporaryFolder& folder) {
  Children children;
  const pid_t child = children.start({"/bin/true"}, folder / "log");
  CHECK(children.wait(child).code == 0);
  return child;
}

}  // namespace

TEST_CASE("one has the lock, until it gives it back") {
  const TemporaryFolder folder;
  RunLock first(folder / "run");
  RunLock second(folder / "run");
  CHECK(!first.is_held());
  CHECK(first.acquire(false));
  CHECK(second.is_held());
  CHECK(!second.acquire(false));
  CHECK(!second.acquire(true));  // its owner is alive on this machine
  CHECK(second.owner_text() == host(folder) + ", process " + std::to_string(::getpid()));
  second.release();  // which it does not have
  CHECK(first.is_held());
  first.release();
  CHECK(!std::filesystem::exists(folder / "run.lock"));
  CHECK(second.acquire(false));
}

TEST_CASE("a lock is taken over when its processes are gone on the same machine") {
  const TemporaryFolder folder;
  const std::string here = host(folder);
  const std::string gone = std::to_string(number_of_ended_process(folder));
  const std::string alive = std::to_string(::getpid());
  RunLock lock(folder / "run");
  const auto left_by = [&](const std::string& owner) {
    folder.write("run.lock/owner", owner + "\n");
    return lock.acquire(false);
  };
  CHECK(!left_by(here + " " + alive + " - 0 -"));
  CHECK(!left_by(here + " " + gone + " - " + alive + " -"));  // the run that it started goes on
  CHECK(left_by(here + " " + gone + " - 0 -"));
  CHECK(left_by(here + " " + gone + " - " + gone + " -"));
#ifdef __linux__
  CHECK(left_by(here + " " + alive + " 1 0 -"));  // the number is another process's by now
#endif
  CHECK(!std::filesystem::exists(folder / "run.lock/next"));
}

TEST_CASE("a lock of another machine, and one without an owner, are taken over on demand") {
  const TemporaryFolder folder;
  for (const char* owner : {"elsewhere 1 - 0 -\n", "", "nonsense\n"}) {
    folder.write("run.lock/owner", owner);
    RunLock lock(folder / "run");
    CHECK(lock.is_held());
    CHECK(!lock.acquire(false));
    CHECK(lock.acquire(true));
  }
}

TEST_CASE("of several that find a lock without its process one takes it over") {
  const TemporaryFolder folder;
  const std::string gone =
      host(folder) + " " + std::to_string(number_of_ended_process(folder)) + " - 0 -\n";
  for (int round = 0; round < 50; ++round) {
    folder.write("run.lock/owner", gone);
    std::atomic<int> taken{0};
    std::vector<std::unique_ptr<RunLock>> locks;
    for (int k = 0; k < 4; ++k) locks.push_back(std::make_unique<RunLock>(folder / "run"));
    {
      std::vector<std::jthread> threads;
      for (const auto& lock : locks)
        threads.emplace_back([&taken, &lock] { taken += lock->acquire(false) ? 1 : 0; });
    }
    CHECK(taken == 1);
    locks.clear();
    CHECK(!std::filesystem::exists(folder / "run.lock"));
  }
}
