// SPDX-License-Identifier: BSL-1.0
#include <exception>

#include <riprap/conformance/execution.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct LastToFirst {  // the other way round, to show that results do not depend on the order
  template <class Work>
  void run(std::size_t tasks, Work&& work) const {
    std::exception_ptr error;  // the last one caught is that of the lowest task
    while (tasks > 0) try {
        work(--tasks);
      } catch (...) {
        error = std::current_exception();
      }
    if (error) std::rethrow_exception(error);
  }
};

int main() {
  const Assembly sample = random_assembly({.count = 300, .seed = 1});  // two tasks
  const auto model = Model{}.criterion(NeverFails{});
  Simulation sim{model.execution(LastToFirst{}), sample, Rock{}};
  Simulation twin{model, sample, Rock{}};
  sim.boundary().set_rate(50, 50), twin.boundary().set_rate(50, 50);
  for (int i = 0; i < 400; ++i) sim.step(), twin.step();
  bool same = twin.particles().body(299).contact.force.norm() > 0;  // it has met others
  for (BodyIndex i = 0; i < sample.particles.size(); ++i)
    same = same && sim.particles().body(i).position == twin.particles().body(i).position;
  return same && execution_violations(LastToFirst{}).empty() ? 0 : 1;
}
