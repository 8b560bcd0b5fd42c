// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of the biaxial example and the policies they stand for.

#include <cstdint>
#include <string>

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/line_fit/line_fit_choice.hpp>
#include <riprap/contact/law/contact_law_choice.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/dynamics/integrator/integrator_choice.hpp>
#include <riprap/riprap.hpp>
#include <riprap/stress/plane_state/plane_state_choice.hpp>
#include <riprap/stress/support/support_choice.hpp>
#ifdef _OPENMP
#include <riprap/core/execution/threads.hpp>
#endif

struct Options {
  unsigned particles = 500;
  double pressure = 2e6;
  double strain = 0.2;
  std::uint64_t seed = 1;
  bool breakage = true;
  std::string criterion = "hoek-brown";
  std::string line_fit = "xy";
  std::string support = "inertia-relief";
  std::string boundary = "particles";
  std::string contact = "linear";
  std::string integrator = "euler";
  double mean_diameter = 0.016;
  double thickness = 0.016;
  unsigned fewest_vertices = 3;
  unsigned most_vertices = 5;
  unsigned mesh_triangles = 100;
  double ratf = 0.4;
  unsigned check_every = 1;
  double inertial_number = 1e-3;
  std::string plane = "stress";
  double minimum_piece_area = 0.08;
  double maximum_piece_aspect = 3;
  std::string out = "biaxial-out";
  bool paraview = false;
  int threads = 1;
  bool timer = false;

  // Do contact law, integrator, support and boundary have their defaults, for which there are
  // programs without choices?
  [[nodiscard]] bool compiled_in() const {
    return contact == "linear" && integrator == "euler" && support == "inertia-relief" &&
           boundary == "particles";
  }
};

// What the assembly is to be made of.
riprap::RandomAssembly chosen_assembly(const Options& options);

// Fills the options from the command line; exits on --help and on unknown or malformed options.
Options read_options(int argc, char** argv);

using AnyCriterion = riprap::CriterionChoice<riprap::HoekBrown, riprap::MohrCoulomb,
                                             riprap::Griffith, riprap::ModifiedGriffith,
                                             riprap::Murrell, riprap::Hobbs, riprap::Franklin>;
using AnyLineFit = riprap::LineFitChoice<riprap::WeightedXY, riprap::WeightedX, riprap::WeightedY>;
using AnyContact = riprap::ContactLawChoice<riprap::LinearSpringCoulomb, riprap::OverlapAreaSpring,
                                            riprap::SpringDashpot>;
using AnyIntegrator = riprap::IntegratorChoice<riprap::SymplecticEuler, riprap::VelocityVerlet>;
using AnySupport = riprap::SupportChoice<riprap::InertiaRelief, riprap::TwoPinnedContacts>;
using AnyPlane = riprap::PlaneStateChoice<riprap::PlaneStress, riprap::PlaneStrain>;

// One thread or several: a choice costs nothing here, for it is made once for all tasks.
struct AnyExecution {
  int threads = 1;

  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
#ifdef _OPENMP
    if (threads > 1) return riprap::Threads{threads}.run(tasks, work);
#endif
    riprap::Serial{}.run(tasks, work);
  }
};
static_assert(riprap::Execution<AnyExecution>);

// What is chosen at run time goes through one more model of its role ...
AnyCriterion chosen_criterion(const Options& options);
AnyLineFit chosen_line_fit(const Options& options);
AnyPlane chosen_plane(const Options& options);
AnyContact chosen_contact(const Options& options);
AnyIntegrator chosen_integrator(const Options& options);
AnySupport chosen_support(const Options& options);

// ... and costs a little in the hot loops, so that the default has two programs of its own, and one
// that reads a clock. Which boundary there is decides at compile time whether the plane is
// periodic. One source file each.
void run_with_inertia_relief(const Options& options);
void run_without_breakage(const Options& options);
void run_timed(const Options& options);
void run_choices_particles(const Options& options);
void run_choices_platens(const Options& options);
void run_choices_periodic(const Options& options);
