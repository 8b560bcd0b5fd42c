// SPDX-License-Identifier: BSL-1.0
// The stress check of a particle with four contacts, meshed with N triangles: stress/operator by
// the compact operator; stress/operator_exact by the exact one, where a particle may break;
// stress/assemble_and_solve by what they replace, in which every check assembles, factorises and
// solves, all memory and the symbolic analysis being kept. All locate the contacts on the mesh
// first, and go round the 500 particles of a usual sample, whose data do not fit in the nearest
// caches. stress/check is the whole of what is done where the bound does not hold: it also counts
// the elements that may have failed, and renews the bound. stress/bound says at most steps that
// none of this is needed: it goes through four contacts and what each may do. stress/comparison is
// for those of whom it cannot say so: it compares their loads with those of the last check. Not
// measured: finding the contacts of a particle.

#include <deque>
#include <map>

#include <riprap/acceleration/screening/failure_screening.hpp>
#include <riprap/acceleration/screening/stress_change_bound.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>

#include "support.hpp"

namespace bench {
namespace {

constexpr std::size_t particles = 500;
constexpr std::size_t contacts = 4;
using Loads = std::array<BoundaryLoad, contacts>;

// A particle with forces at points of its outline, in its own frame.
struct Loaded {
  ConvexPolygon polygon;
  std::array<Vec2, contacts> arms;
  std::array<Vec2, contacts> forces;

  [[nodiscard]] Mesh mesh(std::int64_t triangles) const {
    return UniformMesher{static_cast<unsigned>(triangles)}(polygon.ring());
  }
  [[nodiscard]] Loads located(const Mesh& mesh) const {
    Loads loads;
    for (std::size_t k = 0; k < contacts; ++k)
      loads[k] = {nearest_boundary_point(mesh, arms[k]), forces[k], 0};
    return loads;
  }
};

[[nodiscard]] std::vector<Loaded> loaded_particles() {
  Random random(1);
  std::vector<Loaded> all;
  while (all.size() < particles) {
    Loaded p{random_polygon(blunt, size, random), {}, {}};
    const auto last = static_cast<unsigned>(p.polygon.size()) - 1;
    for (std::size_t k = 0; k < contacts; ++k) {
      const std::size_t i = random.uniform_integer(1, last);
      p.arms[k] = p.polygon[i] + random.uniform(0, 1) * (p.polygon[i - 1] - p.polygon[i]);
      p.forces[k] = {random.uniform(-1e3, 1e3), random.uniform(-1e3, 1e3)};
    }
    all.push_back(p);
  }
  return all;
}

[[nodiscard]] InfluenceOperator exact_operator(const Loaded& p, std::int64_t triangles) {
  return {p.mesh(triangles), ConstantStrainTriangle{}, PlaneStress{}, Rock{}, size, false};
}

struct ByExactOperator {
  InfluenceOperator op;
  ElementStress stress{};
  ByExactOperator(const Loaded& p, std::int64_t triangles) : op(exact_operator(p, triangles)) {}

  void operator()(const Loaded& p) {
    stress.reset(op.sampling_points().size());
    for (const BoundaryLoad& load : p.located(op.mesh()))
      op.add_stress(load.at, load.force_body, stress);
    benchmark::DoNotOptimize(stress.values().data());
  }
};

struct BySolution {
  AssembleAndSolve<ConstantStrainTriangle, PlaneStress> system;
  ElementStress stress{};
  BySolution(const Loaded& p, std::int64_t triangles) : BySolution(p.mesh(triangles)) {}
  explicit BySolution(const Mesh& mesh)
      : system(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, size,
               DeterminateSupport::on_opposite_sides(mesh)) {}

  void operator()(const Loaded& p) {
    system.factorise();
    system.solve_free(p.located(system.mesh()), stress);
    benchmark::DoNotOptimize(stress.values().data());
  }
};

template <bool whole>
struct ByOperator {
  InfluenceOperatorF32 op;
  StressChangeBound reference{};
  std::array<ContactLoad, contacts> loads{};
  ByOperator(const Loaded& p, std::int64_t triangles) : op(exact_operator(p, triangles)) {
    for (std::size_t k = 0; k < contacts; ++k)
      loads[k] = {p.arms[k], p.forces[k], 0, static_cast<std::uint32_t>(k)};
  }

  void operator()(const Loaded& p) {
    static FailureScreening screening{MohrRadiusTable::of(HoekBrown{})};
    static ElementStressF32 stress;
    Loads placed;
    std::array<LocatedPoint, contacts> places;
    for (std::size_t k = 0; k < contacts; ++k) {
      places[k] = op.locator().nearest(p.arms[k]);
      placed[k] = {places[k].at, p.forces[k], 0};
    }
    op.find_stress(placed, 1, stress);
    benchmark::DoNotOptimize(stress.values.data());
    if constexpr (!whole) return;
    const ScreeningResult result = screening(stress, 1 + 2 * op.elements() / 5);
    static WeightedInfluence influence;
    influence.assign(op, placed, places, screening.factors());
    reference.reset(loads, placed, places, Rotation{}, influence, result.stress_margin);
  }
};

template <class Method>
void check(benchmark::State& state) {
  static std::map<std::int64_t, std::deque<Method>> ready;  // set up once per N
  std::deque<Method>& methods = ready[state.range(0)];
  const std::vector<Loaded> loaded = loaded_particles();
  if (methods.empty())
    for (const Loaded& p : loaded) methods.emplace_back(p, state.range(0));
  std::size_t i = 0;
  for (auto _ : state) {
    methods[i](loaded[i]);
    if (++i == particles) i = 0;
  }
  count_time(state, "element", static_cast<double>(state.range(0)));
}

// Particles with their bounds, under loads that have changed a little.
std::vector<ByOperator<true>> bounded(const std::vector<Loaded>& loaded) {
  std::vector<ByOperator<true>> all;
  for (const Loaded& p : loaded) {
    all.emplace_back(p, 100);
    all.back()(p);
  }
  return all;
}
void change_loads(std::vector<ByOperator<true>>& all) {
  for (ByOperator<true>& one : all)
    for (ContactLoad& load : one.loads) {
      load.arm_lab *= 1 - 1e-7;
      load.force_lab *= 1 + 1e-4;
    }
}

// At most steps it is known contact by contact that a particle holds.
void bound(benchmark::State& state) {
  std::vector<ByOperator<true>> all = bounded(loaded_particles());
  std::vector<StressChangeBound::Sensitivities> sensitivities(particles);
  for (std::size_t i = 0; i < particles; ++i)
    benchmark::DoNotOptimize(
        all[i].reference.within_limit(all[i].loads, Rotation{}, sensitivities[i]));
  change_loads(all);
  std::size_t i = 0;
  std::size_t held = 0;
  for (auto _ : state) {
    IncrementalBound one(Rotation{}, contacts);
    for (std::size_t k = 0; k < contacts; ++k)
      one.accumulate(sensitivities[i][k], all[i].loads[k].arm_lab, all[i].loads[k].force_lab);
    held += one.within_budget();
    if (++i == particles) i = 0;
  }
  state.counters["held"] =
      benchmark::Counter(static_cast<double>(held), benchmark::Counter::kAvgIterations);
}

// Else most of them are known to hold without an evaluation.
void comparison(benchmark::State& state) {
  std::vector<ByOperator<true>> all = bounded(loaded_particles());
  change_loads(all);
  StressChangeBound::Sensitivities sensitivities;
  std::size_t i = 0;
  std::size_t held = 0;
  for (auto _ : state) {
    held += all[i].reference.within_limit(all[i].loads, Rotation{}, sensitivities);
    benchmark::DoNotOptimize(sensitivities);
    if (++i == particles) i = 0;
  }
  state.counters["held"] =
      benchmark::Counter(static_cast<double>(held), benchmark::Counter::kAvgIterations);
}

// What every new shape costs once: its mesh, its operator and the compact form of it.
void build_operator(benchmark::State& state) {
  const std::vector<Loaded> loaded = loaded_particles();
  std::size_t i = 0;
  double bytes = 0;
  for (auto _ : state) {
    const InfluenceOperatorF32 built(exact_operator(loaded[i], state.range(0)));
    bytes += static_cast<double>(built.bytes());
    if (++i == particles) i = 0;
  }
  state.counters["kB"] = benchmark::Counter(1e-3 * bytes, benchmark::Counter::kAvgIterations);
}

BENCHMARK(check<BySolution>)->Name("stress/assemble_and_solve")->Arg(60)->Arg(100)->Arg(300);
BENCHMARK(check<ByOperator<false>>)->Name("stress/operator")->Arg(60)->Arg(100)->Arg(300);
BENCHMARK(check<ByOperator<true>>)->Name("stress/check")->Arg(60)->Arg(100)->Arg(300);
BENCHMARK(check<ByExactOperator>)->Name("stress/operator_exact")->Arg(60)->Arg(100)->Arg(300);
BENCHMARK(bound)->Name("stress/bound");
BENCHMARK(comparison)->Name("stress/comparison");
BENCHMARK(build_operator)->Name("stress/build_operator")->Arg(60)->Arg(100)->Arg(300);

}  // namespace
}  // namespace bench
