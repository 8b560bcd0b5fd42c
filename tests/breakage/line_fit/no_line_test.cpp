// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/no_line.hpp>

#include <doctest/doctest.h>

#include <support/point_clouds.hpp>

using namespace riprap;

TEST_CASE("no cloud has a line where no line is drawn") {
  FailurePlanes planes;
  planes.count = 1;
  CHECK_FALSE(NoLine{}(test::scattered_points(), planes));
}
