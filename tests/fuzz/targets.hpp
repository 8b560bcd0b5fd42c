// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The fuzz targets: each takes any bytes, aborts where riprap breaks a rule, and throws nothing.

#include "input.hpp"

namespace riprap::fuzz {

void polygon(Bytes bytes);
void contact(Bytes bytes);
void cut(Bytes bytes);
void mesh(Bytes bytes);
void wkt(Bytes bytes);
void options(Bytes bytes);

}  // namespace riprap::fuzz
