// SPDX-License-Identifier: BSL-1.0
#include <riprap/riprap.hpp>

int main() {}
