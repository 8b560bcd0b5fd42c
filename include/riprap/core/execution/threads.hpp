// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Several threads at once, by OpenMP. Not part of riprap.hpp: compile and link with -fopenmp.

#ifndef _OPENMP
#error "riprap: Threads needs OpenMP: compile with -fopenmp or link to riprap::threads"
#endif

#include <omp.h>

#include <cstddef>
#include <exception>
#include <limits>

#include <riprap/core/errors.hpp>
#include <riprap/core/execution/concepts.hpp>

namespace riprap {

/// Shares tasks out among `count` threads. Results are those of Serial, byte for byte.
struct Threads {
  int count = omp_get_max_threads();

  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    std::exception_ptr error;
    std::size_t first_error = std::numeric_limits<std::size_t>::max();
    // Tasks are of uneven length, for some particles are checked and most are not. For a single one
    // no thread is woken; else always the same number, since OpenMP ends threads that a run leaves
    // out.
#pragma omp parallel for num_threads(count) schedule(dynamic) if (tasks > 1)
    for (std::size_t k = 0; k < tasks; ++k) {
      try {
        work(k);
      } catch (...) {
#pragma omp critical(riprap_threads)
        if (k < first_error) {
          first_error = k;
          error = std::current_exception();
        }
      }
    }
    if (error) std::rethrow_exception(error);
  }

  void validate() const { require(count >= 1, "Threads.count", count, "must be 1 or more"); }
};

static_assert(Execution<Threads>);

}  // namespace riprap
