#include <doctest/doctest.h>

#include <riprap/simulation/observer.hpp>
#include <vector>

using namespace riprap;

namespace {

struct WithHook {
  std::vector<int>& calls;
  int name;
  void after_step(int) { calls.push_back(name); }
};
struct WithoutHook {};

}  // namespace

TEST_CASE("observers are told in their order, and only those that have the hook") {
  std::vector<int> calls;
  WithHook first{calls, 1};
  WithoutHook second;
  WithHook third{calls, 3};
  notify(
      [](auto& o) {
        if constexpr (requires { o.after_step(0); }) o.after_step(0);
      },
      first, second, third);
  CHECK(calls == std::vector<int>{1, 3});
}
