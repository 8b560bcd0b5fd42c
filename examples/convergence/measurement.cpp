// SPDX-License-Identifier: BSL-1.0
#include "measurement.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include <riprap/breakage/splitter/straight_cut.hpp>
#include <riprap/breakage/trigger/calibrated_limit.hpp>

namespace convergence {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

double degrees(const riprap::Vec2& direction) {
  return std::atan2(direction.y(), direction.x()) * 180 / std::numbers::pi;
}

Measurement measure(const LoadedParticle& particle, const Sample& sample, const MeshChoice& mesh,
                    const Field& field, double m_b, const Measurement* reference) {
  const riprap::HoekBrown criterion{.m_b = m_b};
  const std::vector<double> areas = field.areas();
  Measurement m{.mesh = mesh.name, .points = points_asked(mesh), .m_b = m_b};
  m.load = critical_load(criterion, field.stress, areas, limit);
  const double own_limit = limit_of(mesh);
  m.calibrated_load =
      std::isnan(own_limit) ? nothing : critical_load(criterion, field.stress, areas, own_limit);
  const auto lines = crack_lines(criterion, field, m.load);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    m.angles[k] = lines[k] ? degrees(lines[k]->direction) : nothing;
    m.accepted[k] = lines[k] && riprap::StraightCut{}(particle.ring, *lines[k], sample.mean_area);
  }
  const Measurement& beside = reference ? *reference : m;
  m.share = failed_share(criterion, field.stress, areas, beside.load);
  m.reference_load = beside.load;
  m.reference_angles = beside.angles;
  return m;
}

}  // namespace

double limit_of(const MeshChoice& mesh) {
  const unsigned points = points_asked(mesh);
  if (mesh.graded || points > 400) return nothing;
  return mesh.six_nodes ? riprap::calibrated_limit(riprap::LinearStrainTriangle{}, points)
                        : riprap::calibrated_limit(riprap::ConstantStrainTriangle{}, points);
}

std::string limits_text() {
  std::string text;
  for (const MeshChoice& mesh : meshes) text += " " + riprap::to_text(limit_of(mesh));
  return text;
}

std::vector<Measurement> measure(const LoadedParticle& particle, const Sample& sample,
                                 const Extent& extent) {
  std::vector<Measurement> all;
  const auto add = [&](Plane plane) {
    const std::size_t first = all.size();  // of the references
    const auto add_mesh = [&](const MeshChoice& mesh) {
      const Field field = stress_field(particle, sample.thickness, mesh, plane);
      for (std::size_t k = 0; k < m_b_values.size(); ++k) {
        const bool is_reference = all.size() < first + m_b_values.size();
        // A copy: `all` grows.
        const Measurement reference = is_reference ? Measurement{} : all[first + k];
        all.push_back(measure(particle, sample, mesh, field, m_b_values[k],
                              is_reference ? nullptr : &reference));
        all.back().plane = plane;
      }
    };
    for (const MeshChoice& mesh : meshes)
      if (plane == Plane::stress || !mesh.graded) add_mesh(mesh);
    if (plane == Plane::stress && extent.fine_mesh) add_mesh(fine_mesh);
  };
  add(Plane::stress);
  if (extent.plane_strain) add(Plane::strain);
  return all;
}

std::string to_lines(const std::vector<Measurement>& measurements) {
  std::string text = "mesh,points,plane,m_b,load,calibrated_load,share,reference_load";
  for (const char* name : line_names)
    text += std::string(",angle_") + name + ",reference_angle_" + name + ",accepted_" + name;
  text += "\n";
  for (const Measurement& m : measurements) {
    std::string name = m.mesh;
    for (char& c : name)
      if (c == ',') c = ';';
    char buffer[240];
    std::snprintf(buffer, sizeof buffer, "%s,%u,%s,%g,%.9g,%.9g,%.9g,%.9g", name.c_str(), m.points,
                  m.plane == Plane::strain ? "strain" : "stress", m.m_b, m.load, m.calibrated_load,
                  m.share, m.reference_load);
    text += buffer;
    for (std::size_t k = 0; k < line_names.size(); ++k) {
      std::snprintf(buffer, sizeof buffer, ",%.6g,%.6g,%d", m.angles[k], m.reference_angles[k],
                    m.accepted[k] ? 1 : 0);
      text += buffer;
    }
    text += "\n";
  }
  return text;
}

std::vector<Measurement> measurements_from(const std::string& lines) {
  std::vector<Measurement> all;
  std::istringstream text(lines);
  std::string line;
  std::getline(text, line);  // the names
  while (std::getline(text, line)) {
    std::istringstream fields(line);
    std::string field;
    const auto word = [&] {
      if (!std::getline(fields, field, ',')) throw std::runtime_error("line too short: " + line);
      return field;
    };
    const auto number = [&] { return std::stod(word()); };
    Measurement m;
    m.mesh = word();
    for (char& c : m.mesh)
      if (c == ';') c = ',';
    m.points = static_cast<unsigned>(number());
    m.plane = word() == "strain" ? Plane::strain : Plane::stress;
    for (double* const value : {&m.m_b, &m.load, &m.calibrated_load, &m.share, &m.reference_load})
      *value = number();
    for (std::size_t k = 0; k < line_names.size(); ++k) {
      m.angles[k] = number();
      m.reference_angles[k] = number();
      m.accepted[k] = number() != 0;
    }
    all.push_back(m);
  }
  return all;
}

}  // namespace convergence
