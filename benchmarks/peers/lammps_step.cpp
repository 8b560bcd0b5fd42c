// SPDX-License-Identifier: BSL-1.0
// lammps_step polygons|discs PACKING FOLDER  writes LAMMPS' input into FOLDER, runs `lmp` there,
// one process without threads, and reads its own times.

#include <cstdlib>
#include <exception>
#include <map>
#include <numbers>
#include <sstream>

#include <riprap/geometry/separation.hpp>

#include "packing.hpp"
#include "result.hpp"

namespace peers {
namespace {

constexpr double skin = 0.02;  // radius of a polygon's corners over the mean diameter

[[nodiscard]] std::ofstream open(const std::string& path) {
  std::ofstream out(path);
  if (!out) throw std::runtime_error("cannot write " + path);
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  return out;
}

[[nodiscard]] AreaProperties properties(const PlacedParticle& grain) {
  return area_properties(grain.polygon.ring());
}

// Head, atoms and velocities of a data file. `atom(out, grain)` writes what stands between the type
// and the place.
template <class Atom>
void write_atoms(std::ofstream& out, const Packing& packing, bool bodies, Atom&& atom) {
  const std::vector<PlacedParticle>& grains = packing.assembly.particles;
  const std::size_t count = grains.size();
  double reach = 0;
  for (const PlacedParticle& g : grains) reach = std::max(reach, centroid(g).norm());
  reach += 10 * packing.mean_diameter;
  out << "packing\n\n" << count << " atoms\n";
  if (bodies) out << count << " bodies\n";
  out << "2 atom types\n"
      << -reach << ' ' << reach << " xlo xhi\n"
      << -reach << ' ' << reach << " ylo yhi\n"
      << -packing.mean_diameter << ' ' << packing.mean_diameter << " zlo zhi\n\nAtoms\n\n";
  for (std::size_t i = 0; i < count; ++i) {
    const PlacedParticle& g = grains[i];
    const Vec2 x = centroid(g);
    out << i + 1 << ' ' << (is_free(g) ? 1 : 2) << ' ';
    atom(out, g);
    out << ' ' << x.x() << ' ' << x.y() << " 0\n";
  }
  out << "\nVelocities\n\n";
  for (std::size_t i = 0; i < count; ++i) {
    const PlacedParticle& g = grains[i];
    const Vec2 v = is_free(g) ? g.velocity : packing.field(centroid(g));
    // Rotation: LAMMPS takes the angular momentum of a body and the angular velocity of a disc.
    const double inertia =
        bodies ? packing.density * packing.assembly.thickness * properties(g).polar_moment : 1;
    out << i + 1 << ' ' << v.x() << ' ' << v.y() << " 0 0 0 " << inertia * g.angular_velocity
        << '\n';
  }
}

// LAMMPS takes spheres: the density of one with the mass of the disc.
void write_discs(const Packing& packing, const std::string& path) {
  std::ofstream out = open(path);
  write_atoms(out, packing, false, [&](std::ofstream& line, const PlacedParticle& g) {
    const double area = properties(g).area;
    const double diameter = equivalent_diameter(area);
    const double volume = std::numbers::pi / 6 * diameter * diameter * diameter;
    line << diameter << ' ' << packing.density * packing.assembly.thickness * area / volume;
  });
}

void write_polygons(const Packing& packing, const std::string& path) {
  std::ofstream out = open(path);
  const double areal_density = packing.density * packing.assembly.thickness;
  write_atoms(out, packing, true, [&](std::ofstream& line, const PlacedParticle& g) {
    line << "1 " << areal_density * properties(g).area;
  });
  out << "\nBodies\n\n";
  for (std::size_t i = 0; i < packing.assembly.particles.size(); ++i) {
    const PlacedParticle& g = packing.assembly.particles[i];
    const AreaProperties whole = properties(g);
    const std::vector<Vec2> core = inset(g.polygon.ring(), skin * packing.mean_diameter);
    const double inertia = areal_density * whole.polar_moment;
    out << i + 1 << " 1 " << 6 + 3 * core.size() + 1 << '\n'
        << core.size() << '\n'
        << 0.5 * inertia << ' ' << 0.5 * inertia << ' ' << inertia << " 0 0 0\n";
    for (const Vec2& v : core)
      out << v.x() - whole.centroid.x() << ' ' << v.y() - whole.centroid.y() << " 0\n";
    out << 2 * skin * packing.mean_diameter << '\n';
  }
}

void write_input(const Packing& packing, bool discs, const std::string& folder) {
  std::ofstream out = open(folder + "/in");
  const std::vector<PlacedParticle>& grains = packing.assembly.particles;
  double mean_mass = 0;
  for (const PlacedParticle& g : grains)
    mean_mass += packing.density * packing.assembly.thickness * properties(g).area /
                 static_cast<double>(grains.size());
  // A third of critical damping in the contact of two mean grains: LAMMPS has no local damping.
  const double dashpot = 0.6 * std::sqrt(packing.stiffness * mean_mass / 2);
  out << "units si\ndimension 2\nboundary f f p\ncomm_modify vel yes\n"
      << (discs ? "newton off\natom_style sphere\n" : "atom_style body rounded/polygon 3 8\n")
      << "read_data data\n"
      << "group free type 1\ngroup ring type 2\n"
      << "neighbor " << 0.1 * packing.mean_diameter << " bin\n"
      << "neigh_modify every 1 delay 0 check yes exclude group ring ring\n";
  if (discs)
    out << "pair_style gran/hooke/history " << packing.stiffness << ' ' << packing.stiffness << ' '
        << dashpot / (mean_mass / 2) << " NULL " << packing.friction << " 1\npair_coeff * *\n"
        << "fix motion free nve/sphere disc\n";
  else
    // No cohesion; a length of the contact far above any, so that it does not scale the force.
    out << "pair_style body/rounded/polygon " << dashpot << ' ' << dashpot << ' '
        << packing.friction << " 1 0\npair_coeff * * " << packing.stiffness << " 0\n"
        << "fix motion free nve/body\ncompute corners all body/local id 1 2\n";
  out << "fix field ring nve/noforce\nfix flat all enforce2d\n"
      << "timestep " << packing.time_step << "\nthermo 1000000\n"
      << "run " << spring_settling_steps << "\nrun " << spring_timed_steps
      << '\n'
      // What it leaves, in a run without steps.
      << (discs ? "dump end all custom 1 end id x y radius\n"
                : "dump end all local 1 end c_corners[1] c_corners[2] c_corners[3]\n")
      << "dump_modify end format float %.12g\nrun 0\n";
}

// CPU time per grain and step [ns] that LAMMPS gives for its last run with steps.
[[nodiscard]] double read_time(const std::string& path) {
  std::ifstream in(path);
  double wall = 0;
  double cpu = 0;
  double steps = 0;
  for (std::string line; std::getline(in, line);) {
    double seconds = 0;
    double atoms = 0;
    double share = 0;
    if (std::sscanf(line.c_str(), "Loop time of %lf on 1 procs for %lf steps with %lf atoms",
                    &seconds, &steps, &atoms) == 3)
      wall = 1e9 * seconds / steps / atoms;
    if (line.find("% CPU use") != std::string::npos && steps > 0 &&
        std::sscanf(line.c_str(), "%lf", &share) == 1)
      cpu = 0.01 * share * wall;
  }
  if (!(cpu > 0)) throw std::runtime_error("no times in " + path);
  return cpu;
}

struct Placed {
  std::vector<Vec2> ring;  // of a disc: its centre
  double radius = 0;       // of the circle round it, or of the disc
  Vec2 centre{0, 0};
};

// Grains as LAMMPS has left them, by id.
[[nodiscard]] std::vector<Placed> read_dump(const std::string& path, bool discs,
                                            std::size_t count) {
  std::ifstream in(path);
  std::vector<Placed> grains(count);
  std::string line;
  while (std::getline(in, line))
    if (line.starts_with("ITEM: ENTRIES") || line.starts_with("ITEM: ATOMS")) break;
  while (std::getline(in, line)) {
    std::istringstream fields(line);
    double id = 0;
    Vec2 x{0, 0};
    fields >> id >> x.x() >> x.y();
    Placed& grain = grains.at(static_cast<std::size_t>(id) - 1);
    grain.ring.push_back(x);
    if (discs) fields >> grain.radius;
  }
  for (Placed& grain : grains) {
    if (grain.ring.empty()) throw std::runtime_error("grains are missing in " + path);
    grain.centre = discs ? grain.ring[0] : area_properties(grain.ring).centroid;
    if (discs) continue;
    for (const Vec2& v : grain.ring)
      grain.radius = std::max(grain.radius, (v - grain.centre).norm());
  }
  return grains;
}

[[nodiscard]] ContactCount contacts(const Packing& packing, const std::vector<Placed>& grains,
                                    bool discs) {
  ContactCount count;
  const double rounding = discs ? 0 : 2 * skin * packing.mean_diameter;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const bool free = is_free(packing.assembly.particles[i]);
    count.grain(free);
    for (std::size_t j = 0; j < i; ++j) {
      if (!free && !is_free(packing.assembly.particles[j])) continue;
      const double near = grains[i].radius + grains[j].radius + rounding -
                          (grains[i].centre - grains[j].centre).norm();
      if (near <= 0) continue;
      const double depth =
          discs ? near : rounding + minimum_translation(grains[i].ring, grains[j].ring).depth;
      if (depth > 0) count.contact(free, is_free(packing.assembly.particles[j]), depth);
    }
  }
  return count;
}

void run(const std::string& shape, const std::string& path, const std::string& folder) {
  const bool discs = shape == "discs";
  const Packing packing = read(path);
  if (discs)
    write_discs(packing, folder + "/data");
  else
    write_polygons(packing, folder + "/data");
  write_input(packing, discs, folder);
  const std::string command =
      "cd '" + folder + "' && OMP_NUM_THREADS=1 lmp -in in -log log -screen none >&2";
  if (std::system(command.c_str()) != 0) throw std::runtime_error("lmp failed in " + folder);
  const double ns = read_time(folder + "/log");
  const ContactCount found = contacts(
      packing, read_dump(folder + "/end", discs, packing.assembly.particles.size()), discs);
  print_result("LAMMPS " + shape, {{"ns", ns},
                                   {"coordination", found.coordination()},
                                   {"overlap", found.mean_depth() / packing.mean_diameter},
                                   {"time_step", packing.time_step}});
}

}  // namespace
}  // namespace peers

int main(int count, char** arguments) try {
  if (count != 4) throw std::runtime_error("lammps_step polygons|discs PACKING FOLDER");
  peers::run(arguments[1], arguments[2], arguments[3]);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
