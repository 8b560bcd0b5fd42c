// The stress check of a particle with four contacts, meshed with N triangles: by influence
// operator, and by what it replaces, in which every check assembles, factorises and solves, all
// memory and the symbolic analysis being kept. Both locate the contacts on the mesh first, and go
// round the 500 particles of a usual sample, whose data do not fit in the nearest caches. Not
// measured: sorting contact forces by particle, turning them into its frame, and the criterion
// (criterion/*).

#include <deque>
#include <map>

#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/mesh/uniform_mesher.hpp>
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
  void locate(const Mesh& mesh, Loads& loads) const {
    for (std::size_t k = 0; k < contacts; ++k)
      loads[k] = {mesh.nearest_boundary_point(arms[k]), forces[k], 0};
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

struct ByOperator {
  InfluenceOperator op;
  explicit ByOperator(Mesh mesh)
      : op(std::move(mesh), ConstantStrainTriangle{}, PlaneStress{}, Rock{}, size, false) {}

  [[nodiscard]] const Mesh& mesh() const { return op.mesh(); }
  void find(const Loads& loads, ElementStress& stress) const {
    stress.reset(mesh().size());
    for (const BoundaryLoad& load : loads) op.add_stress(load.at, load.force, stress);
  }
};

struct BySolution {
  AssembleAndSolve<ConstantStrainTriangle, PlaneStress> system;
  explicit BySolution(const Mesh& mesh)
      : system(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, size,
               DeterminateSupport::on_opposite_sides(mesh)) {}

  [[nodiscard]] const Mesh& mesh() const { return system.mesh(); }
  void find(const Loads& loads, ElementStress& stress) {
    system.factorise();
    system.solve_free(loads, stress);
  }
};

template <class Method>
void check(benchmark::State& state) {
  static std::map<std::int64_t, std::deque<Method>> ready;  // set up once per N
  std::deque<Method>& methods = ready[state.range(0)];
  const std::vector<Loaded> loaded = loaded_particles();
  if (methods.empty())
    for (const Loaded& p : loaded) methods.emplace_back(p.mesh(state.range(0)));
  Loads loads;
  ElementStress stress;
  std::size_t i = 0;
  for (auto _ : state) {
    loaded[i].locate(methods[i].mesh(), loads);
    methods[i].find(loads, stress);
    benchmark::DoNotOptimize(stress.values().data());
    if (++i == particles) i = 0;
  }
  count_time(state, "element", static_cast<double>(state.range(0)));
}

// What every new shape costs once: its mesh and its operator.
void build_operator(benchmark::State& state) {
  const std::vector<Loaded> loaded = loaded_particles();
  std::size_t i = 0;
  double bytes = 0;
  for (auto _ : state) {
    const ByOperator built(loaded[i].mesh(state.range(0)));
    bytes += static_cast<double>(built.op.bytes());
    if (++i == particles) i = 0;
  }
  state.counters["kB"] = benchmark::Counter(1e-3 * bytes, benchmark::Counter::kAvgIterations);
}

BENCHMARK(check<BySolution>)->Name("stress/assemble_and_solve")->Arg(60)->Arg(100)->Arg(300);
BENCHMARK(check<ByOperator>)->Name("stress/operator")->Arg(60)->Arg(100)->Arg(300);
BENCHMARK(build_operator)->Name("stress/build_operator")->Arg(60)->Arg(100)->Arg(300);

}  // namespace
}  // namespace bench
