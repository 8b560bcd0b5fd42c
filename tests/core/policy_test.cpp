// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <memory>
#include <riprap/core/policy.hpp>
#include <type_traits>

using namespace riprap;

namespace {

struct Nothing {};
struct CannotBeCopied {
  std::unique_ptr<int> owned;
};
struct ValidateIsNotConst {
  void validate() {}
};
struct CountsValidations {
  int* count;
  void validate() const { ++*count; }
};

static_assert(Policy<Nothing> && check_policy<Nothing>());
static_assert(Policy<CountsValidations>);
static_assert(Policy<bool (*)(double)>);
static_assert(!Policy<CannotBeCopied>);
static_assert(!Policy<ValidateIsNotConst>);

}  // namespace

TEST_CASE("a policy with a validate function is validated, one without is always valid") {
  int count = 0;
  validate(CountsValidations{&count});
  CHECK(count == 1);
  validate(Nothing{});
  CHECK(count == 1);
}

TEST_CASE("an error in the rules of a policy begins with the name that it is given") {
  struct Bad {
    void validate() const { throw InvalidInput("Bad.value = 1: must be 2"); }
  };
  CHECK_THROWS_WITH_AS(validate_named("law 3", Bad{}), "law 3: Bad.value = 1: must be 2",
                       InvalidInput);
  validate_named("law 3", Nothing{});
}

TEST_CASE("a lambda with captures can be copied and not assigned, and may be a policy") {
  const auto lambda = [limit = 3.0](double x) { return x > limit; };
  CHECK(Policy<decltype(lambda)>);
  CHECK(!std::is_copy_assignable_v<decltype(lambda)>);
}
