// SPDX-License-Identifier: BSL-1.0
// The processor's time that a compiler takes with -O2: compile/compose for the 25-line program of
// examples/compose, compile/riprap_hpp for its only include. The compiler is that of the
// benchmarks; names that end in /clang are of clang 16, where CMake has found it.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

// The macros come from CMake.
const std::string compose = "cat '" RIPRAP_COMPOSE "'";
const std::string riprap_hpp = "echo '#include <riprap/riprap.hpp>'";

// Processor's time [s] of the commands that have ended.
double time_of_commands() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Compiles what the command `source` writes.
void compile(benchmark::State& state, const std::string& compiler, const std::string& source) {
  const auto object = std::filesystem::temp_directory_path() / "riprap_compile_benchmark.o";
  const std::string command = source + " | '" + compiler +
                              "' -std=c++20 -O2 " RIPRAP_INCLUDES " -x c++ -c - -o '" +
                              object.string() + "'";
  for (auto _ : state) {
    const double before = time_of_commands();
    if (std::system(command.c_str()) != 0) state.SkipWithError("does not compile");
    state.SetIterationTime(time_of_commands() - before);
  }
  std::filesystem::remove(object);
}

void add(const std::string& name, const std::string& compiler, const std::string& source) {
  benchmark::RegisterBenchmark(name.c_str(), compile, compiler, source)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kSecond);
}

[[maybe_unused]] const bool added = [] {
  add("compile/compose", RIPRAP_COMPILER, compose);
  add("compile/riprap_hpp", RIPRAP_COMPILER, riprap_hpp);
#ifdef RIPRAP_CLANG
  add("compile/compose/clang", RIPRAP_CLANG, compose);
  add("compile/riprap_hpp/clang", RIPRAP_CLANG, riprap_hpp);
#endif
  return true;
}();

}  // namespace
