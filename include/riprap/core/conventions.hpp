// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The conventions of riprap. This header owns them; nothing else restates them.
///
/// - SI units everywhere: m, kg, s, N, Pa, rad, J. See core/units.hpp for literals such as 2.0_MPa.
/// - Stress is positive in compression. Principal stresses are ordered major >= minor.
/// - Axes 1 and 2 span the plane; the biaxial test loads axis 2. Angles are measured from axis 1,
///   counter-clockwise.
/// - Rings of vertices are counter-clockwise and open (the first vertex is not repeated).
/// - A contact normal points from body a to body b; the tangent is the normal turned by +90
///   degrees; a contact force is the force that a exerts on b. Penetration depth is >= 0.
/// - Volumetric strain is positive in contraction, axial strain in shortening.
/// - The out-of-plane thickness is an explicit length [m] in every mass, force and stress.
/// - Tolerances are relative to the size of the particles concerned.

#include <riprap/core/compiler.hpp>

#if defined(__FAST_MATH__)
#error "riprap needs IEEE arithmetic; compile it without -ffast-math"
#endif
