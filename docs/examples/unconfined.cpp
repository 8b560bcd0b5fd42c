// SPDX-License-Identifier: BSL-1.0
#include <cstdio>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/experiment/unconfined_compression.hpp>  // not part of riprap.hpp
using namespace riprap;

int main() {
  const Rock limestone{.young = 50e9, .poisson = 0.25};
  const HoekBrown criterion{.compressive_strength = 120e6, .m_b = 10};
  const UnconfinedCompression test{.width = 0.054, .height = 0.119, .friction = 0.2};
  const UnconfinedResult result = test.run(limestone, criterion, UniformMesher{.triangles = 5000});
  std::printf("RatF %.2f: %zu elements in shear, %zu in tension\n", result.ratio(), result.shear,
              result.tensile);
  if (const auto line = failure_line(result, criterion, WeightedXY{}))
    std::printf("failure line through (%.4f, %.4f) m\n", line->point.x(), line->point.y());
  return result.least_normal_force() > 0 ? 0 : 1;  // the platens were not glued on anywhere
}
