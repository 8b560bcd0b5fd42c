// SPDX-License-Identifier: BSL-1.0
// The analysis and the picture of the single-particle example, for a particle out of a run.

#include "run_process.hpp"

#include <string>

#include "../../single_particle/picture.hpp"

void study::draw_process(const Case& particle, const riprap::BreakEvent& event,
                         const std::filesystem::path& file) {
  const Analysis analysis = analyse(particle);
  // The polygon has been to the laboratory and back: that costs the last digits.
  const double tolerance = 1e-6 * riprap::diameter(particle.polygon.ring());
  if (!analysis.crack || analysis.failures.failed != event.failures.failed ||
      analysis.failures.first_failed != event.failures.first_failed ||
      (analysis.crack->line.point - event.line.point).norm() > tolerance ||
      (analysis.crack->line.direction - event.line.direction).norm() > 1e-6)
    throw riprap::SimulationError("particle " + std::to_string(event.particle.id) +
                                  " broke in the run along another line than on its own");
  picture(analysis).save(file.string());
}
