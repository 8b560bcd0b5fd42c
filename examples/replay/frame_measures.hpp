// SPDX-License-Identifier: BSL-1.0
#pragma once
// What is measured of a frame when it is packed: rattlers, strain since the start of shear, and the
// mean normal force.

#include <cstddef>
#include <vector>

#include <riprap/measurement/material_points.hpp>

#include "recorded_run.hpp"

namespace replay {

class FrameMeasures {
 public:
  explicit FrameMeasures(const RecordedRun& run);

  // Whether each particle of a frame carries no load, in its order.
  [[nodiscard]] std::vector<bool> rattlers(const riprap::ReadRecord& frame) const;

  // Deviatoric strain around each particle of a frame since the first one of shear, or the first of
  // all where there is no shear. Pieces have that of the intact particle they come from; 0 before
  // that frame, for platens and walls, and where it is not known.
  [[nodiscard]] std::vector<double> deviatoric_strains(const riprap::ReadRecord& frame) const;

 private:
  [[nodiscard]] const riprap::ReadRecord& particle(double id) const {
    return run_.particles[static_cast<std::size_t>(id)].record;
  }
  [[nodiscard]] std::vector<riprap::MaterialPoint> points(const riprap::ReadRecord& frame) const;

  const RecordedRun& run_;
  const riprap::ReadRecord* reference_frame_ = nullptr;
  std::vector<riprap::MaterialPoint> reference_{};
};

// Of the contacts with a normal force, which the strong network is above [N].
[[nodiscard]] double mean_normal_force(const riprap::ReadRecord& frame);

}  // namespace replay
