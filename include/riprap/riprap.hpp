#pragma once
/// @file
/// What a simulation needs: all policies but the optional ones, Model, Simulation, the biaxial test
/// and its records. Needs the headers of Eigen and Boost only.

#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/rankine.hpp>
#include <riprap/breakage/line_fit/failure_plane_through_centroid.hpp>
#include <riprap/breakage/line_fit/no_line.hpp>
#include <riprap/breakage/line_fit/total_least_squares.hpp>
#include <riprap/breakage/trigger/any_element.hpp>
#include <riprap/breakage/trigger/never_breaks.hpp>
#include <riprap/breakage/trigger/weibull_strength.hpp>
#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/contact/law/no_contact_force.hpp>
#include <riprap/contact/law/overlap_area_spring.hpp>
#include <riprap/contact/law/spring_dashpot.hpp>
#include <riprap/core/units.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/dynamics/damping/viscous_damping.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/dynamics/time_step/no_mass_scaling.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/experiment/curve.hpp>
#include <riprap/geometry/adapt/boost.hpp>
#include <riprap/output/csv.hpp>
#include <riprap/output/progress.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>
#include <riprap/version.hpp>
