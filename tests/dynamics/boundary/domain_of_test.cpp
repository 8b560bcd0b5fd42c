// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/boundary/domain_of.hpp>

#include <doctest/doctest.h>

#include <concepts>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/dynamics/boundary/strain_field.hpp>

using namespace riprap;

TEST_CASE("a periodic cell has a domain, other boundaries have none") {
  CHECK(PeriodicBoundary<PeriodicCell>);
  CHECK_FALSE(PeriodicBoundary<StrainField>);
  CHECK(std::same_as<DomainOf<PeriodicCell>, PeriodicDomain>);
  CHECK(std::same_as<DomainOf<StrainField>, UnboundedDomain>);
  CHECK(std::same_as<DomainOf<RigidPlatens>, UnboundedDomain>);
  CHECK(std::same_as<DomainOf<NoBoundary>, UnboundedDomain>);
}
