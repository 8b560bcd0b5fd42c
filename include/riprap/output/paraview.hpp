// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A series of files for ParaView: particles and contacts at each record.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <riprap/experiment/stage.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/measurement/coarse_grained_stress.hpp>
#include <riprap/measurement/contact_stress.hpp>
#include <riprap/measurement/fragments.hpp>
#include <riprap/measurement/local_strain.hpp>
#include <riprap/measurement/material_points.hpp>
#include <riprap/measurement/rattlers.hpp>
#include <riprap/output/bonds_vtp.hpp>
#include <riprap/output/vtp.hpp>

namespace riprap {

/// What particles_vtp adds on request.
struct ParticleArrays {
  /// The state since which strain is measured (root_centroids); without points there are none of
  /// its arrays.
  std::vector<MaterialPoint> reference{};
  double kernel_radius = 0;  ///< of the coarse-grained stress [m]; 0: no such arrays
};

namespace internal {

/// Gradient of displacements since a state, of each body by its root; zero where there is none.
[[nodiscard]] inline std::vector<DisplacementGradient>
gradients_since(const std::vector<MaterialPoint>& reference, const Particles& particles) {
  const auto points = point_gradients(local_strain(reference, root_centroids(particles)));
  std::vector<DisplacementGradient> out(particles.size());
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    if (particles.body(i).is_wall()) continue;
    const ParticleId root = particles.ancestry(i).root;
    const auto found =
        std::lower_bound(points.begin(), points.end(), root,
                         [](const PointGradient& p, ParticleId id) { return p.id < id; });
    if (found != points.end() && found->id == root) out[i] = found->gradient;
  }
  return out;
}

}  // namespace internal

/// Particles as polygons. Arrays: `id`, `parent` (-1: none), `root`, `generation`; `material`,
/// the place in the list of rocks; `motion`, the place in enum Motion (0: free); `velocity` [m/s]
/// and `spin` [rad/s]; `s11`, `s22`, `s12`, the mean stress of the particle [Pa], compression
/// positive; `rattler` (0 or 1), of a fragment in a model with bonds, which has its number
/// `fragment`; where particles can break, `rat`. On request `volumetric_strain` (contraction
/// positive), `deviatoric_strain` [-] and `rotation` [rad] of the material around the intact
/// particle it comes from, since the reference (zero where that is unknown); `cg_s11`, `cg_s22`,
/// `cg_s12`, coarse-grained stress at the centroid [Pa].
template <class Sim>
[[nodiscard]] VtpFile particles_vtp(const Sim& sim, const ParticleArrays& more = {}) {
  const Particles& particles = sim.particles();
  VtpFile file(VtpCells::polygons);
  for (BodyIndex i = 0; i < particles.size(); ++i) file.add_cell(particles.ring(i));

  const auto add = [&](const char* name, auto value) {
    file.add_values(name, [&](std::size_t k) { return value(static_cast<BodyIndex>(k)); });
  };
  const auto number = [](ParticleId id) {
    return id == no_particle ? std::int64_t{-1} : std::int64_t{id};
  };
  add("id", [&](BodyIndex i) { return number(particles.ancestry(i).id); });
  add("parent", [&](BodyIndex i) { return number(particles.ancestry(i).parent); });
  add("root", [&](BodyIndex i) { return number(particles.ancestry(i).root); });
  add("generation", [&](BodyIndex i) { return particles.ancestry(i).generation; });
  add("material", [&](BodyIndex i) { return static_cast<int>(particles.material(i)); });
  add("motion", [&](BodyIndex i) { return static_cast<int>(particles.body(i).motion); });
  add("velocity", [&](BodyIndex i) { return particles.body(i).velocity; });
  add("spin", [&](BodyIndex i) { return particles.body(i).angular_velocity; });
  const std::vector<Stress2> stresses = contact_stresses(sim.interactions(), particles);
  add("s11", [&](BodyIndex i) { return stresses[i].s11; });
  add("s22", [&](BodyIndex i) { return stresses[i].s22; });
  add("s12", [&](BodyIndex i) { return stresses[i].s12; });
  const std::vector<bool> is_rattler = [&] {
    if constexpr (has_bonds<Sim>) return fragment_rattlers(sim);
    return rattlers(sim.contacts(), particles);
  }();
  add("rattler", [&](BodyIndex i) { return static_cast<int>(is_rattler[i]); });
  if constexpr (has_bonds<Sim>) {
    const std::vector<std::uint32_t> numbers = fragment_numbers(sim);
    add("fragment", [&](BodyIndex i) { return numbers[i]; });
  }
  if constexpr (Sim::breakable) {
    const std::vector<double> ratios = sim.failed_ratios();
    add("rat", [&](BodyIndex i) { return ratios[i]; });
  }
  if (!more.reference.empty()) {
    const auto gradients = internal::gradients_since(more.reference, particles);
    add("volumetric_strain", [&](BodyIndex i) { return gradients[i].volumetric_strain(); });
    add("deviatoric_strain", [&](BodyIndex i) { return gradients[i].deviatoric_strain(); });
    add("rotation", [&](BodyIndex i) { return gradients[i].rotation(); });
  }
  if (more.kernel_radius > 0) {
    const std::vector<Stress2> smooth =
        coarse_grained_stresses(sim.interactions(), particles, LucyKernel{more.kernel_radius});
    add("cg_s11", [&](BodyIndex i) { return smooth[i].s11; });
    add("cg_s22", [&](BodyIndex i) { return smooth[i].s22; });
    add("cg_s12", [&](BodyIndex i) { return smooth[i].s12; });
  }
  return file;
}

/// Contacts as lines from centroid to centroid through the contact point. Arrays: `a` and `b`, the
/// ids of the two particles; `normal_force` and `tangential_force` [N]; `depth` [m].
template <class Sim>
[[nodiscard]] VtpFile contacts_vtp(const Sim& sim) {
  using ContactType = typename Sim::Contacts::ContactType;
  std::vector<const ContactType*> contacts;
  VtpFile file(VtpCells::lines);
  sim.contacts().for_each_touching([&](const ContactType& c) {
    contacts.push_back(&c);
    const Vec2& point = c.geometry.point;
    const std::vector<Vec2> line{point - c.branch_arm_a(), point, point - c.branch_arm_b()};
    file.add_cell(line);
  });
  const auto add = [&](const char* name, auto value) {
    file.add_values(name, [&](std::size_t k) { return value(*contacts[k]); });
  };
  const auto id = [&](BodyIndex i) { return sim.particles().ancestry(i).id; };
  add("a", [&](const ContactType& c) { return id(c.a); });
  add("b", [&](const ContactType& c) { return id(c.b); });
  add("normal_force", [](const ContactType& c) { return c.force.normal; });
  add("tangential_force", [](const ContactType& c) { return c.force.tangential; });
  add("depth", [](const ContactType& c) { return c.geometry.depth; });
  return file;
}

/// Writes `particles_0000.vtp`, `contacts_0000.vtp` and so on into a folder, and beside them the
/// two collections to open, `particles.pvd` and `contacts.pvd`; those of bonds, too, if the model
/// has them. As an observer of BiaxialTest it writes at each record, and the time of the series is
/// the axial strain; elsewhere call `write`. The first state removes the files of an earlier series
/// from the folder.
class ParaViewSeries {
 public:
  bool local_strain = true;  ///< arrays of strain since the first state of the series
  /// Radius of the kernel of the coarse-grained stress over the mean diameter of the intact
  /// particles [-]; 0: no such arrays.
  double kernel_diameters = 3;

  /// The folder is made when the first state is written.
  explicit ParaViewSeries(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Removes the files of a series, by their names, and the folder if nothing else is in it.
  static void remove(const std::filesystem::path& folder) {
    std::error_code ignored;  // what cannot be removed shows when it is written
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
      if (entry.is_regular_file(ignored) && is_of_series(entry.path().filename().string()))
        found.push_back(entry.path());
    for (const auto& path : found) std::filesystem::remove(path, ignored);
    // Fails, as it should, where something else is in the folder.
    if (!found.empty() && !std::filesystem::is_symlink(folder, ignored))
      std::filesystem::remove(folder, ignored);
  }

  /// Adds the present state.
  /// @param time what ParaView shows as time: sim.time() [s], a strain [-], larger at each call
  /// @throws SimulationError if a file cannot be written
  template <class Sim>
  void write(const Sim& sim, double time) {
    if (times_.empty()) {
      remove(folder_);
      make_folder(folder_);
      if (local_strain) arrays_.reference = root_centroids(sim.particles());
      arrays_.kernel_radius = kernel_diameters * equivalent_diameter(sim.mean_area());
    }
    const std::string file = "_" + number_text(times_.size()) + ".vtp";
    particles_vtp(sim, arrays_).save(folder_ / ("particles" + file));
    contacts_vtp(sim).save(folder_ / ("contacts" + file));
    if constexpr (has_bonds<Sim>) bonds_vtp(sim).save(folder_ / ("bonds" + file));
    times_.push_back(time);
    write_collections();
  }

  template <class Sim>
  void record(const BiaxialView<Sim>& view) {
    write(view.sim, view.axial_strain());
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("times", self.times_);
    visit("reference", self.arrays_.reference);
    visit("kernel_radius", self.arrays_.kernel_radius);
  }
  /// The series goes on after the states of a checkpoint.
  void restored() {
    if (!times_.empty()) write_collections();
  }

 private:
  // Written anew each time, so that what a stopped run leaves can be opened.
  void write_collections() const {
    for (const std::string name : {"particles", "contacts"})
      write_file(folder_ / (name + ".pvd"), collection(name));
    if (std::error_code ignored; std::filesystem::exists(folder_ / "bonds_0000.vtp", ignored))
      write_file(folder_ / "bonds.pvd", collection("bonds"));
  }
  // "particles_0123.vtp", "contacts.pvd" and the like, or what a killed program left of one.
  [[nodiscard]] static bool is_of_series(std::string_view name) {
    if (name.ends_with(".part")) name.remove_suffix(5);
    for (const std::string_view kind : {"particles", "contacts", "bonds"}) {
      if (!name.starts_with(kind)) continue;
      const std::string_view rest = name.substr(kind.size());
      if (rest == ".pvd") return true;
      if (!rest.starts_with('_') || !rest.ends_with(".vtp")) return false;
      const std::string_view digits = rest.substr(1, rest.size() - 5);
      return digits.size() >= 4 && digits.find_first_not_of("0123456789") == digits.npos;
    }
    return false;
  }
  [[nodiscard]] static std::string number_text(std::size_t number) {
    return internal::padded_number(number, 4);
  }
  [[nodiscard]] std::string collection(const std::string& name) const {
    std::string text = "<VTKFile type=\"Collection\" version=\"0.1\">\n<Collection>\n";
    for (std::size_t k = 0; k < times_.size(); ++k)
      text += "<DataSet timestep=\"" + to_text(times_[k]) + "\" part=\"0\" file=\"" + name + "_" +
              number_text(k) + ".vtp\"/>\n";
    return text + "</Collection>\n</VTKFile>\n";
  }

  std::filesystem::path folder_;
  std::vector<double> times_;
  ParticleArrays arrays_;
};

}  // namespace riprap
