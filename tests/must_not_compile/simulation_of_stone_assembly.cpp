// SPDX-License-Identifier: BSL-1.0
// riprap: a StoneAssembly is no Assembly: give its member assembly, after
// bond_common_edges(sample.assembly, cluster) for each of sample.clusters() if its stones are to
// hold together
#include <riprap/particle/random_stones.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

Simulation sim{Model{}, random_platen_stones({}, {}), Rock{}};
