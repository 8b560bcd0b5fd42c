// SPDX-License-Identifier: BSL-1.0
// The processor's time that a compiler takes with -O2: compile/compose for the 25-line program of
// examples/compose, compile/never_fails for the same without breakage, compile/riprap_hpp for its
// only include; each header-only, and with /compiled for a program that links riprap::compiled. The
// library itself is not compiled. The compiler is that of the
// benchmarks; names that end in /clang are of clang 16, where CMake has found it.

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

namespace {

// The macros come from CMake.
const std::string compose = "cat '" RIPRAP_COMPOSE "'";
const std::string never_fails =
    "sed 's/.criterion(.*)$/.criterion(NeverFails{})/' '" RIPRAP_COMPOSE "'";
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
void compile(benchmark::State& state, const std::string& compiler, const std::string& source,
             const std::string& options) {
  const auto object = std::filesystem::temp_directory_path() / "riprap_compile_benchmark.o";
  const std::string command = source + " | '" + compiler + "' -std=c++20 -O2 " RIPRAP_INCLUDES +
                              options + " -x c++ -c - -o '" + object.string() + "'";
  for (auto _ : state) {
    const double before = time_of_commands();
    if (std::system(command.c_str()) != 0) state.SkipWithError("does not compile");
    state.SetIterationTime(time_of_commands() - before);
  }
  std::filesystem::remove(object);
}

void add(const std::string& name, const std::string& compiler, const std::string& source) {
  for (const auto& [mode, options] :
       {std::pair{"", ""}, std::pair{"/compiled", " -DRIPRAP_COMPILED"}})
    benchmark::RegisterBenchmark((name + mode).c_str(), compile, compiler, source, options)
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
}

[[maybe_unused]] const bool added = [] {
  add("compile/compose", RIPRAP_COMPILER, compose);
  add("compile/never_fails", RIPRAP_COMPILER, never_fails);
  add("compile/riprap_hpp", RIPRAP_COMPILER, riprap_hpp);
#ifdef RIPRAP_CLANG
  add("compile/compose/clang", RIPRAP_CLANG, compose);
  add("compile/riprap_hpp/clang", RIPRAP_CLANG, riprap_hpp);
#endif
  return true;
}();

}  // namespace
