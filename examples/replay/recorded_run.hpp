// SPDX-License-Identifier: BSL-1.0
#pragma once
// A run as its frames have it.

#include <cstddef>
#include <string>
#include <vector>

#include <riprap/output/record.hpp>

namespace replay {

struct RecordedParticle {
  riprap::ReadRecord record;  // PART
  // The frames that have it: [first, last]; none if it broke before the next frame.
  std::size_t first = 0;
  std::size_t last = 0;
  bool seen = false;
};

struct RecordedBreak {
  riprap::ReadRecord record;  // BREK
  std::size_t frame = 0;      // the last one before
};

struct RecordedRun {
  riprap::ReadRecord head;                    // RUN
  std::vector<RecordedParticle> particles{};  // in the order of their ids, which are 0, 1, 2, ...
  std::vector<riprap::ReadRecord> frames{};   // FRAM
  std::vector<RecordedBreak> breaks{};
};

// Reads every `every`th frame, and those at the ends of stages. Throws InvalidInput if the file
// cannot be read, is no file of frames or has none.
RecordedRun read_run(const std::string& file, unsigned every);

}  // namespace replay
