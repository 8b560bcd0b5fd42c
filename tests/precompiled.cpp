// SPDX-License-Identifier: BSL-1.0
// Nothing: CMake writes a precompiled header for a target with a source that uses it, and main.cpp
// has to include doctest by itself.
