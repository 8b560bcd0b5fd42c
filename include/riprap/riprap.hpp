#pragma once
/// @file
/// What a simulation needs: policies, Model, Simulation, the biaxial test and its records. Needs
/// the headers of Eigen and Boost only.

#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/core/units.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
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
