// SPDX-License-Identifier: BSL-1.0
#include "work_through.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>
#include <vector>

namespace run_table {

void work_through(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& work,
                  const std::function<void()>& watch) {
  std::atomic<std::size_t> next{0};
  std::size_t at_work = std::min<std::size_t>(jobs, count);
  std::mutex mutex;
  std::condition_variable ended;
  std::vector<std::jthread> threads;
  for (std::size_t j = at_work; j > 0; --j)
    threads.emplace_back([&] {
      for (std::size_t k = next++; k < count; k = next++) work(k);
      const std::scoped_lock lock(mutex);
      --at_work;
      ended.notify_one();
    });
  std::unique_lock lock(mutex);
  while (at_work > 0) {
    ended.wait_for(lock, std::chrono::milliseconds(200));
    if (!watch) continue;
    lock.unlock();
    watch();
    lock.lock();
  }
}

std::string duration_text(double seconds) {
  char text[64];
  if (seconds < 100)
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  else if (seconds < 6000)
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  else
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  return text;
}

}  // namespace run_table
