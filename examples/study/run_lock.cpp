// SPDX-License-Identifier: BSL-1.0
#include "run_lock.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include <riprap/core/errors.hpp>
#include <riprap/output/file.hpp>
#include <sys/stat.h>
#include <unistd.h>

namespace run_study {

namespace fs = std::filesystem;

namespace {

std::string host_name() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

// Of an owner file: machine, study, the run that it has started.
struct Owner {
  std::string host;
  ProcessId study;
  ProcessId run;
};

bool read_owner(const fs::path& lock, Owner& owner) {
  std::ifstream file(lock / "owner");
  std::string begun_study;
  std::string begun_run;
  if (!(file >> owner.host >> owner.study.number >> begun_study >> owner.run.number >> begun_run))
    return false;
  if (begun_study != "-") owner.study.begun = begun_study;
  if (begun_run != "-") owner.run.begun = begun_run;
  return true;
}

// Field 22 of /proc/N/stat, behind the name in brackets, which may have blanks.
std::string time_begun(long process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t bracket = text.rfind(')');
  if (bracket == text.npos) return {};
  std::istringstream fields(text.substr(bracket + 1));
  std::string field;
  for (int k = 3; k <= 22; ++k) fields >> field;
  return field;
}

// False if it is there already.
bool make_exclusively(const fs::path& folder) {
  if (::mkdir(folder.c_str(), 0777) == 0) return true;
  if (errno == EEXIST) return false;
  throw riprap::SimulationError("cannot make the folder " + folder.string() + ": " +
                                std::strerror(errno));
}

}  // namespace

ProcessId ProcessId::of(pid_t process) {
  return {static_cast<long>(process), process > 0 ? time_begun(process) : ""};
}

bool ProcessId::is_alive() const {
  if (number <= 0) return false;
  if (::kill(static_cast<pid_t>(number), 0) != 0 && errno == ESRCH) return false;
  return begun.empty() || begun == time_begun(number);
}

RunLock::RunLock(const fs::path& folder) : folder_(folder) { folder_ += ".lock"; }

bool RunLock::may_be_taken(bool take_over) const {
  Owner owner;
  if (!read_owner(folder_, owner)) return take_over;
  if (owner.host != host_name()) return take_over;
  return !owner.study.is_alive() && !owner.run.is_alive();
}

bool RunLock::acquire(bool take_over) {
  if (!make_exclusively(folder_)) {
    if (!may_be_taken(take_over)) return false;
    // Only one of those who see that the owner is gone makes this folder, and looks again: another
    // one may have taken over and be at work by now.
    const fs::path next = folder_ / "next";
    std::error_code error;
    if (!fs::create_directory(next, error)) return false;
    const bool may_be = may_be_taken(take_over);
    if (may_be) write_owner(0);
    fs::remove(next, error);
    if (!may_be) return false;
  } else {
    write_owner(0);
  }
  is_mine_ = true;
  return true;
}

void RunLock::write_owner(pid_t child) const {
  const auto text = [](const ProcessId& id) {
    return " " + std::to_string(id.number) + " " + (id.begun.empty() ? "-" : id.begun);
  };
  riprap::write_file(folder_ / "owner", host_name() + text(ProcessId::of(::getpid())) +
                                            text(ProcessId::of(child)) + "\n");
}

void RunLock::note_child(pid_t child) { write_owner(child); }

void RunLock::release() {
  if (!is_mine_) return;
  is_mine_ = false;
  std::error_code ignored;
  fs::remove(folder_ / "owner", ignored);
  fs::remove(folder_, ignored);
}

bool RunLock::is_held() const {
  std::error_code ignored;
  return fs::exists(folder_, ignored) && !may_be_taken(false);
}

std::string RunLock::owner_text() const {
  Owner owner;
  if (!read_owner(folder_, owner)) return "no owner named";
  return owner.host + ", process " + std::to_string(owner.study.number);
}

}  // namespace run_study
