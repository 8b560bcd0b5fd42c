// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The course of a biaxial test as frames in a file: poses, contacts and breaks.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/stage.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/output/file.hpp>
#include <riprap/output/frame_records.hpp>

namespace riprap {

/// An observer of BiaxialTest that writes frames into the file `frames.bin` of a folder: one at the
/// start and the end of each stage, and between them as often as its members say; and each particle
/// once, when it appears, and each break, with the stresses that caused it. The records and their
/// arrays are in docs/replay.md.
///
/// A record is in the file as soon as it is written; one that a kill cuts short is left out by
/// those who read it. The state is named for checkpoints: `restored()` cuts the file to its length
/// at the checkpoint, so that a run that goes on writes the same bytes as one that never stopped.
class FrameWriter {
 public:
  double strain_between = 0.001;  ///< axial strain between frames of shear [-]
  double share_between = 0.025;   ///< of the progress of an earlier stage, between its frames [-]

  /// The folder is made when the first frame is written, and an earlier file is then replaced.
  explicit FrameWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

  [[nodiscard]] static std::filesystem::path file_in(const std::filesystem::path& folder) {
    return folder / "frames.bin";
  }
  /// Removes the file, and the folder if nothing else is in it.
  static void remove(const std::filesystem::path& folder) {
    std::error_code ignored;  // what cannot be removed shows when it is written
    if (std::filesystem::remove(file_in(folder), ignored) &&
        !std::filesystem::is_symlink(folder, ignored))
      std::filesystem::remove(folder, ignored);
  }

  /// Throws InvalidInput unless both intervals are above 0.
  void validate() const {
    require_positive("FrameWriter.strain_between", strain_between);
    require_positive("FrameWriter.share_between", share_between);
  }
  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  /// The file, for checkpoints, which bring it to the disk; empty before the first frame.
  [[nodiscard]] std::string appended_file() const {
    return bytes_ > 0 ? file_in(folder_).string() : std::string();
  }

  template <class Sim>
  void begin_stage(const BiaxialView<Sim>& view) {
    validate();
    next_strain_ = strain_between;
    next_share_ = share_between;
    write_frame(view);
  }
  template <class Sim>
  void progress(const BiaxialView<Sim>& view) {
    const bool is_shear = view.stage == Stage::shear;
    double& next = is_shear ? next_strain_ : next_share_;
    const double reached = is_shear ? view.axial_strain() : view.done;
    if (reached < next || view.sim.steps() == last_step_) return;
    // Multiples of the interval, whatever was left out.
    const double between = is_shear ? strain_between : share_between;
    while (next <= reached) next += between;
    write_frame(view);
  }
  template <class Sim>
  void end_stage(const BiaxialView<Sim>& view) {
    if (view.sim.steps() != last_step_) write_frame(view);
  }
  template <class Sim>
  void before_splits(const Sim& sim) {
    breaking_.clear();
    if constexpr (Sim::breakable)
      for (const auto& [i, crack] : sim.cracks())
        breaking_.emplace_back(sim.particles().ancestry(i).id, breaking_particle(sim, i));
  }
  template <class Sim>
  void record_break(const BiaxialView<Sim>& view, const BreakEvent& event) {
    write_new_particles(view.sim.particles());
    const auto state = std::find_if(breaking_.begin(), breaking_.end(),
                                    [&](const auto& p) { return p.first == event.particle.id; });
    if (state == breaking_.end()) return;  // the observer joined within the step
    add_event(state->second, event);
    state->second.add("stage", static_cast<std::uint32_t>(view.stage));
    state->second.add("strain", view.axial_strain());
    append(state->second);
  }

  /// What a checkpoint keeps.
  static void for_each_field(auto& self, auto&& visit) {
    visit("bytes", self.bytes_);
    visit("frames", self.frames_);
    visit("next_particle", self.next_particle_);
    visit("last_step", self.last_step_);
    visit("next_strain", self.next_strain_);
    visit("next_share", self.next_share_);
  }
  /// Throws SimulationError if the file is gone or shorter than it was.
  void restored() {
    file_.reset();
    if (bytes_ > 0) file_.emplace(file_in(folder_).string(), bytes_);
  }

 private:
  template <class Sim>
  void write_frame(const BiaxialView<Sim>& view) {
    if (bytes_ == 0) begin_file(view);
    write_new_particles(view.sim.particles());
    const double thickness = view.sim.particles().thickness();
    Record record = frame_record(view.sim);
    record.add("stage", static_cast<std::uint32_t>(view.stage));
    record.add("strains", std::vector<double>{view.axial_strain(), view.volumetric_strain()});
    const Stress2 stress = average_stress(view.sim.interactions(), view.area, thickness);
    record.add("stress", std::vector<double>{stress.s11, stress.s22, stress.s12});
    append(record);
    ++frames_;
    last_step_ = view.sim.steps();
  }
  template <class Sim>
  void begin_file(const BiaxialView<Sim>& view) {
    make_folder(folder_.string());
    append_bytes(frames_signature);
    Record record = run_record(view.sim);
    record.add("pressure", view.confining_pressure);
    record.add("diameter", view.mean_diameter);
    append(record);
  }
  void write_new_particles(const Particles& particles) {
    std::vector<BodyIndex> added;
    for (BodyIndex i = 0; i < particles.size(); ++i)
      if (particles.ancestry(i).id >= next_particle_) added.push_back(i);
    std::sort(added.begin(), added.end(), [&](BodyIndex i, BodyIndex j) {
      return particles.ancestry(i).id < particles.ancestry(j).id;
    });
    for (const BodyIndex i : added) append(particle_record(particles, i));
    if (!added.empty()) next_particle_ = particles.ancestry(added.back()).id + 1;
  }
  void append(const Record& record) { append_bytes(record.bytes()); }
  void append_bytes(std::string_view bytes) {
    if (!file_) file_.emplace(file_in(folder_).string());
    file_->append(bytes);
    bytes_ += bytes.size();
  }

  std::filesystem::path folder_;
  std::optional<AppendedFile> file_;
  std::vector<std::pair<ParticleId, Record>> breaking_;  // within a step
  std::uint64_t bytes_ = 0;
  std::uint64_t frames_ = 0;
  ParticleId next_particle_ = 0;  // the first one that is not in the file
  std::uint64_t last_step_ = 0;
  double next_strain_ = 0;
  double next_share_ = 0;
};

}  // namespace riprap
