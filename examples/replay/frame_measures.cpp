// SPDX-License-Identifier: BSL-1.0
#include "frame_measures.hpp"

#include <algorithm>
#include <utility>

#include <riprap/experiment/loading_view.hpp>
#include <riprap/measurement/local_strain.hpp>
#include <riprap/measurement/rattlers.hpp>
#include <riprap/particle/body.hpp>

namespace replay {

namespace {

using riprap::ReadRecord;

bool is_wall(const ReadRecord& particle) {
  return particle.number("motion") >= static_cast<double>(riprap::Motion::platen);
}

}  // namespace

FrameMeasures::FrameMeasures(const RecordedRun& run) : run_(run) {
  const auto is_shear = [](const ReadRecord& f) {
    return f.number("stage") == static_cast<double>(riprap::Stage::shear);
  };
  const auto first = std::find_if(run.frames.begin(), run.frames.end(), is_shear);
  reference_frame_ = first == run.frames.end() ? &run.frames.front() : &*first;
  reference_ = points(*reference_frame_);
}

std::vector<bool> FrameMeasures::rattlers(const ReadRecord& frame) const {
  const auto& ids = frame["id"];
  std::vector<riprap::BodyIndex> place(run_.particles.size(), 0);
  std::vector<bool> is_free;
  for (std::size_t k = 0; k < ids.size(); ++k) {
    place[static_cast<std::size_t>(ids[k])] = static_cast<riprap::BodyIndex>(k);
    is_free.push_back(particle(ids[k]).number("motion") == 0);
  }
  std::vector<riprap::LoadedContact> contacts;
  for (std::size_t k = 0; k < frame["a"].size(); ++k)
    if (frame["normal"][k] != 0 || frame["tangential"][k] != 0)
      contacts.push_back({place[static_cast<std::size_t>(frame["a"][k])],
                          place[static_cast<std::size_t>(frame["b"][k])]});
  return riprap::rattlers(contacts, is_free);
}

std::vector<riprap::MaterialPoint> FrameMeasures::points(const ReadRecord& frame) const {
  std::vector<riprap::PointPart> parts;
  for (std::size_t k = 0; k < frame["id"].size(); ++k) {
    const ReadRecord& p = particle(frame["id"][k]);
    if (is_wall(p)) continue;
    parts.push_back({{static_cast<riprap::ParticleId>(p.number("root")),
                      riprap::Vec2{frame["x"][k], frame["y"][k]}},
                     p.number("area")});
  }
  return riprap::joined_points(std::move(parts));
}

std::vector<double> FrameMeasures::deviatoric_strains(const ReadRecord& frame) const {
  const auto& ids = frame["id"];
  std::vector<double> out(ids.size(), 0);
  // Frames are in the order of their steps.
  if (frame.number("step") <= reference_frame_->number("step")) return out;
  std::vector<double> of_root(run_.particles.size(), 0);
  for (const auto& point : riprap::point_gradients(riprap::local_strain(reference_, points(frame))))
    of_root[point.id] = point.gradient.deviatoric_strain();
  for (std::size_t k = 0; k < ids.size(); ++k)
    if (!is_wall(particle(ids[k])))
      out[k] = of_root[static_cast<std::size_t>(particle(ids[k]).number("root"))];
  return out;
}

double mean_normal_force(const ReadRecord& frame) {
  double sum = 0;
  std::size_t count = 0;
  for (const double f : frame["normal"])
    if (f > 0) {
      sum += f;
      ++count;
    }
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

}  // namespace replay
