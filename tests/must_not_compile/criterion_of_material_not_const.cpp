// SPDX-License-Identifier: BSL-1.0
// riprap: of_material of a Criterion must be const and return a Criterion, beside
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : HoekBrown {
  const HoekBrown& of_material(MaterialIndex) { return *this; }
  std::size_t materials() const { return 1; }
};

const auto model = Model{}.criterion(Mine{});
