// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The domain that a boundary makes.

#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

/// A boundary with a `domain()`: the domain is a periodic cell.
template <class B>
concept PeriodicBoundary = Boundary<B> && requires(B& boundary) { boundary.domain(); };

namespace internal {

template <class B>
struct DomainOfBoundary {
  using type = UnboundedDomain;
};
template <PeriodicBoundary B>
struct DomainOfBoundary<B> {
  using type = PeriodicDomain;
};

}  // namespace internal

/// PeriodicDomain for a PeriodicBoundary, else UnboundedDomain.
template <class B>
using DomainOf = typename internal::DomainOfBoundary<B>::type;

}  // namespace riprap
