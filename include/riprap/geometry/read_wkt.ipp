// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <charconv>

#include <riprap/geometry/read_wkt.hpp>

namespace riprap {}  // namespace riprap
