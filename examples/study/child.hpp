// SPDX-License-Identifier: BSL-1.0
#pragma once
// A program that runs beside this one, and the signals that are passed on to it.

#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <sys/types.h>

namespace run_study {

// How a program ended.
struct Exit {
  int code = 0;    // if it ended by itself
  int signal = 0;  // that ended it, or 0

  [[nodiscard]] std::string text() const;  // "exit code 1", "signal 9"
};

// The programs that are running now.
class Children {
 public:
  // Starts a program in a process group of its own, so that a signal of the terminal reaches it
  // once and through this program; what it prints is added to the file `log`. 0 if no more are to
  // be started. Throws riprap::SimulationError if that fails.
  pid_t start(const std::vector<std::string>& command, const std::filesystem::path& log);
  Exit wait(pid_t child);
  // Sends the signal to all that are running.
  void send(int signal);
  // No more are to be started.
  void close();

 private:
  std::mutex mutex_;
  std::set<pid_t> running_;
  bool closed_ = false;
};

// From its making on SIGINT, SIGTERM and SIGUSR1 are noted; those that the program was started to
// ignore stay ignored.
class NotedSignals {
 public:
  NotedSignals();
  // The signal that came since the last call, or 0.
  [[nodiscard]] static int take();
};

}  // namespace run_study
