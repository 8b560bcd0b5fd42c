// SPDX-License-Identifier: BSL-1.0
#include "child.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>

#include <riprap/core/errors.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace run_study {

namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note_signal(int signal) { noted = signal; }

void check(int error, const std::string& what) {
  if (error != 0)
    throw riprap::SimulationError("cannot start " + what + ": " + std::strerror(error));
}

// What a new process begins with, freed at the end.
struct Spawn {
  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
  Spawn() {
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&attributes);
  }
  ~Spawn() {
    posix_spawn_file_actions_destroy(&files);
    posix_spawnattr_destroy(&attributes);
  }
  Spawn(const Spawn&) = delete;
  Spawn& operator=(const Spawn&) = delete;
};

}  // namespace

std::string Exit::text() const {
  return signal != 0 ? "signal " + std::to_string(signal) : "exit code " + std::to_string(code);
}

pid_t Children::start(const std::vector<std::string>& command, const std::filesystem::path& log) {
  std::vector<std::string> words = command;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  Spawn spawn;
  posix_spawn_file_actions_addopen(&spawn.files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&spawn.files, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND,
                                   0666);
  posix_spawn_file_actions_adddup2(&spawn.files, 1, 2);
  posix_spawnattr_setflags(&spawn.attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&spawn.attributes, 0);
  const std::scoped_lock lock(mutex_);
  if (closed_) return 0;
  pid_t child = 0;
  check(posix_spawn(&child, argv[0], &spawn.files, &spawn.attributes, argv.data(), environ),
        command.front());
  running_.insert(child);
  return child;
}

Exit Children::wait(pid_t child) {
  siginfo_t info{};
  // Left as it is, so that its number is not used again as long as it is in the set.
  while (::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT) != 0 &&
         errno == EINTR) {
  }
  const std::scoped_lock lock(mutex_);
  running_.erase(child);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return {.signal = WTERMSIG(status)};
  return {.code = WEXITSTATUS(status)};
}

void Children::send(int signal) {
  const std::scoped_lock lock(mutex_);
  for (const pid_t child : running_) ::kill(child, signal);
}

void Children::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
}

NotedSignals::NotedSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1})
    if (std::signal(signal, note_signal) == SIG_IGN) std::signal(signal, SIG_IGN);
}

int NotedSignals::take() {
  const int signal = noted;
  if (signal != 0) noted = 0;
  return signal;
}

}  // namespace run_study
