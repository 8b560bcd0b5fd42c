// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Policies that have exactly what the concept of their role requires: code that compiles with them
/// needs no more than the concepts state. Each computes what a shipped model does, so that its
/// results are known. A test of one missing requirement derives from one and hides a member.

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/simulation/model.hpp>

namespace riprap::test::archetype {

/// A result: converts to T and can do nothing else.
template <class T>
class Gives {
 public:
  explicit constexpr Gives(T value) : value_(std::move(value)) {}
  constexpr operator T() const { return value_; }

 private:
  T value_;
};

/// A parameter: takes a T that may not be changed, and nothing that would first have to become one.
template <class T>
class Takes {
 public:
  Takes(const T& value) : value_(value) {}
  const T& get() const { return value_; }

 private:
  const T& value_;
};

/// Can be copied, but neither default-constructed nor assigned.
class Copyable {
 public:
  explicit Copyable(int) {}
  Copyable(const Copyable&) = default;
  Copyable& operator=(const Copyable&) = delete;
};

/// What a contact keeps: made from nothing, when asked for by name, copied and assigned.
template <class T>
class State {
 public:
  explicit State() = default;
  T value{};
};

struct Execution : Copyable {
  using Copyable::Copyable;
  template <class Work>
  void run(Takes<std::size_t> tasks, Work work) const {
    Serial{}.run(tasks.get(), work);
  }
};

struct BroadPhase : Copyable {
  using Copyable::Copyable;
  Gives<double> relative_skin{AllPairs{}.relative_skin};
  template <class Visit>
  void visit_pairs(Takes<std::span<const Box>> boxes, Visit visit) const {
    AllPairs{}.visit_pairs(boxes.get(), visit);
  }
};

struct NarrowPhase : Copyable {
  using Copyable::Copyable;
  using Cache = State<OverlapChord::Cache>;
  Gives<std::optional<ContactGeometry>> operator()(Takes<Ring> a, Takes<Ring> b,
                                                   Cache& cache) const {
    return Gives(OverlapChord{}(a.get(), b.get(), cache.value));
  }
};

struct ContactLaw : Copyable {
  using Copyable::Copyable;
  using History = State<LinearSpringCoulomb::History>;
  Gives<ContactForce> operator()(Takes<ContactGeometry> geometry, Takes<ContactMotion> motion,
                                 History& history) const {
    return Gives(LinearSpringCoulomb{}(geometry.get(), motion.get(), history.value));
  }
  Gives<double> stored_energy(Takes<ContactGeometry> geometry, Takes<History> history) const {
    return Gives(LinearSpringCoulomb{}.stored_energy(geometry.get(), history.get().value));
  }
  Gives<double> peak_stiffness() const { return Gives(LinearSpringCoulomb{}.peak_stiffness()); }
};

struct BondLaw : Copyable {
  using Copyable::Copyable;
  using State = test::archetype::State<BrittleBond::State>;
  Gives<BondTraction> operator()(Takes<BondDisplacement> displacement, State& state) const {
    return Gives(BrittleBond{}(displacement.get(), state.value));
  }
  Gives<double> stored_energy(Takes<BondDisplacement> displacement, Takes<State> state) const {
    return Gives(BrittleBond{}.stored_energy(displacement.get(), state.get().value));
  }
  Gives<BondFailure> failure(Takes<BondView<State>> bond) const {
    return Gives(BrittleBond{}.failure({bond.get().ends, bond.get().points, {}}));
  }
  Gives<double> peak_stiffness() const { return Gives(BrittleBond{}.peak_stiffness()); }
};

struct Integrator : Copyable {
  using Copyable::Copyable;
  static constexpr Gives<int> order{VelocityVerlet::order};
  static constexpr Gives<bool> has_second_kick{VelocityVerlet::has_second_kick};
  void advance(Body& body, Takes<Wrench> wrench, Takes<double> time_step) const {
    VelocityVerlet{}.advance(body, wrench.get(), time_step.get());
  }
  void second_kick(Body& body, Takes<Wrench> wrench, Takes<double> time_step) const {
    VelocityVerlet{}.second_kick(body, wrench.get(), time_step.get());
  }
};

struct BodyForce : Copyable {
  using Copyable::Copyable;
  Gives<Vec2> operator()(Takes<Body> body) const {
    return Gives<Vec2>(UniformBodyForce{}(body.get()));
  }
};

struct Damping : Copyable {
  using Copyable::Copyable;
  Gives<Wrench> operator()(Takes<Body> body, Takes<Wrench> applied) const {
    return Gives(LocalDamping{}(body.get(), applied.get()));
  }
};

struct TimeStep : Copyable {
  using Copyable::Copyable;
  Gives<double> time_step(Takes<double> mass, Takes<double> stiffness) const {
    return Gives(MassFloor{}.time_step(mass.get(), stiffness.get()));
  }
  Gives<double> mass_scaling(Takes<double> mass, Takes<double> smallest) const {
    return Gives(MassFloor{}.mass_scaling(mass.get(), smallest.get()));
  }
};

struct Boundary : Copyable {
  using Copyable::Copyable;
  void drive(std::vector<Body>&, Takes<double>) {}
};

class Region {
 public:
  explicit Region(const BoundaryPolygon& polygon) : polygon_(polygon) {}
  Gives<double> area() const { return Gives(polygon_.area()); }
  Gives<Vec2> semi_axes() const { return Gives(polygon_.semi_axes()); }
  Gives<double> solid_area() const { return Gives(polygon_.solid_area()); }
  Gives<std::size_t> lost() const { return Gives(polygon_.lost()); }

 private:
  BoundaryPolygon polygon_;
};

class SampleBoundary : public Copyable {
 public:
  using Copyable::Copyable;
  void drive(std::vector<Body>& bodies, Takes<double> time_step) {
    field_.drive(bodies, time_step.get());
  }
  void set_rate(Takes<double> axis_1, Takes<double> axis_2) {
    field_.set_rate(axis_1.get(), axis_2.get());
  }
  Region region(Takes<Particles> particles) const { return Region(field_.region(particles.get())); }

 private:
  StrainField field_;
};

struct Mesher : Copyable {
  using Copyable::Copyable;
  Gives<Mesh> operator()(Takes<Ring> ring) const { return Gives(UniformMesher{}(ring.get())); }
};

struct Element : Copyable {
  using Copyable::Copyable;
  static constexpr std::size_t nodes = 3;
  static constexpr std::array<TrianglePoint, 1> sampling_points = centroid_rule;
  static constexpr std::array<TrianglePoint, 1> integration_points = centroid_rule;
  StrainDisplacement<3> strain_displacement(Takes<std::array<Vec2, 3>> corners,
                                            Takes<Barycentric> at) const {
    return ConstantStrainTriangle{}.strain_displacement(corners.get(), at.get());
  }
  NodalMass<3> mass(Takes<std::array<Vec2, 3>> corners) const {
    return ConstantStrainTriangle{}.mass(corners.get());
  }
};

struct PlaneState : Copyable {
  using Copyable::Copyable;
  Eigen::Matrix3d elasticity(Takes<Rock> rock) const {
    return PlaneStress{}.elasticity(rock.get());
  }
  Gives<double> out_of_plane_stress(Takes<Rock> rock, Takes<Stress2> stress) const {
    return Gives(PlaneStress{}.out_of_plane_stress(rock.get(), stress.get()));
  }
};

struct Support : Copyable {
  using Copyable::Copyable;
  static constexpr Gives<bool> needs_flexibility{true};
  void apply_reactions(Takes<std::span<BoundaryLoad>> loads, Takes<InfluenceOperator> op) const {
    InertiaRelief{}.apply_reactions(loads.get(), op.get());
  }
};

struct Criterion : Copyable {
  using Copyable::Copyable;
  Gives<double> major_stress_at_failure(Takes<double> minor) const {
    return Gives(HoekBrown{}.major_stress_at_failure(minor.get()));
  }
  Gives<double> tensile_strength() const { return Gives(HoekBrown{}.tensile_strength()); }
};

struct Trigger : Copyable {
  using Copyable::Copyable;
  Gives<bool> operator()(Takes<FailureCount> failures) const {
    return Gives(FailedElementRatio{}(failures.get()));
  }
};

struct LoadTrigger : Copyable {
  using Copyable::Copyable;
  Gives<FailureMode> operator()(Takes<LoadedParticle> particle) const {
    const Stress2 mean = particle.get().mean_stress();
    return Gives(particle.get().criterion().evaluate(mean).mode);
  }
};

struct LineFit : Copyable {
  using Copyable::Copyable;
  Gives<std::optional<Line>> operator()(Takes<std::span<const WeightedPoint>> points,
                                        Takes<FailurePlanes> planes) const {
    return Gives(WeightedXY{}(points.get(), planes.get()));
  }
};

struct LoadLineFit : Copyable {
  using Copyable::Copyable;
  Gives<std::optional<Line>> operator()(Takes<LoadedParticle> particle) const {
    return Gives(std::optional<Line>(
        {particle.get().centroid(), particle.get().mean_stress().principal().major_direction}));
  }
};

struct Splitter : Copyable {
  using Copyable::Copyable;
  Gives<std::optional<CutRings>> operator()(Takes<Ring> ring, Takes<Line> line,
                                            Takes<double> mean_area) const {
    return Gives(StraightCut{}(ring.get(), line.get(), mean_area.get()));
  }
};

struct Inheritance : Copyable {
  using Copyable::Copyable;
  void operator()(Takes<Body> parent, Body& piece) const { RigidField{}(parent.get(), piece); }
};

}  // namespace riprap::test::archetype
