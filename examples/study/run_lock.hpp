// SPDX-License-Identifier: BSL-1.0
#pragma once
// One study at a time works on a run, also where several work in the same folder on several
// machines: the lock is a folder beside that of the run, which only one of them can make (mkdir is
// exclusive on every file system, NFS included). A file `owner` in it names machine and processes.

#include <filesystem>
#include <string>

#include <sys/types.h>

namespace run_study {

// A process, and when it began, since numbers of processes are used again.
struct ProcessId {
  long number = 0;
  std::string begun{};  // as the system counts; empty where it does not say

  static ProcessId of(pid_t process);
  [[nodiscard]] bool is_alive() const;
};

class RunLock {
 public:
  // `folder` is that of the run, which need not be there.
  explicit RunLock(const std::filesystem::path& folder);
  ~RunLock() { release(); }
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  // False if another one has it. A lock whose processes are gone is taken over on the machine that
  // they were on; with `take_over` also one of another machine, whose processes cannot be seen
  // from here, and one without an owner. Throws riprap::SimulationError if the system refuses.
  [[nodiscard]] bool acquire(bool take_over);
  // The process that the study has started, so that the lock lasts as long as one of the two does.
  void note_child(pid_t child);
  void release();

  // Is the lock there, and its owner not known to be gone?
  [[nodiscard]] bool is_held() const;
  // "node7, process 4711"
  [[nodiscard]] std::string owner_text() const;

 private:
  [[nodiscard]] bool may_be_taken(bool take_over) const;
  void write_owner(pid_t child) const;

  std::filesystem::path folder_;
  bool is_mine_ = false;
};

}  // namespace run_study
