// SPDX-License-Identifier: BSL-1.0
#include "recorded_run.hpp"

#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/output/frame_records.hpp>

namespace replay {

namespace {

using riprap::ReadRecord;

// Frames are taken as the file is read: it may have many.
class Reader {
 public:
  explicit Reader(unsigned every) : every_(every) {}

  void take(const ReadRecord& record) {
    if (record.kind == "RUN ") {
      run_.head = record;
    } else if (record.kind == "PART") {
      riprap::require(record.number("id") == static_cast<double>(run_.particles.size()),
                      "frames: id of a particle", record.number("id"), "must be the next one");
      run_.particles.push_back({record});
    } else if (record.kind == "FRAM") {
      take_frame(record);
    } else if (record.kind == "BREK") {
      run_.breaks.push_back({record, run_.frames.empty() ? 0 : run_.frames.size() - 1});
    }  // other kinds are of a later version
  }

  RecordedRun finish(const std::string& file) {
    if (run_.frames.empty()) throw riprap::InvalidInput(file + ": has no frame");
    for (std::size_t f = 0; f < run_.frames.size(); ++f)
      for (const double id : run_.frames[f]["id"]) {
        riprap::require(id < static_cast<double>(run_.particles.size()), "frames: particle", id,
                        "must come before the frame that has it");
        RecordedParticle& p = run_.particles[static_cast<std::size_t>(id)];
        if (!p.seen) p.first = f;
        p.seen = true;
        p.last = f;
      }
    return std::move(run_);
  }

 private:
  // The frame before this one stays if it is the last of its stage or one of every few.
  void take_frame(const ReadRecord& frame) {
    const bool is_first =
        run_.frames.empty() || frame.number("stage") != run_.frames.back().number("stage");
    if (is_first) in_stage_ = 0;
    if (!is_first && (in_stage_ - 1) % every_ != 0) {
      run_.frames.pop_back();
      for (RecordedBreak& b : run_.breaks)
        if (b.frame == run_.frames.size()) --b.frame;
    }
    ++in_stage_;
    run_.frames.push_back(frame);
  }

  unsigned every_;
  unsigned in_stage_ = 0;  // frames of this stage so far
  RecordedRun run_{};
};

}  // namespace

RecordedRun read_run(const std::string& file, unsigned every) {
  Reader reader(every);
  riprap::read_records(file, riprap::frames_signature,
                       [&](const ReadRecord& record) { reader.take(record); });
  return reader.finish(file);
}

}  // namespace replay
