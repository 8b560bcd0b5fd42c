# SPDX-License-Identifier: BSL-1.0
# How riprap's own tests, examples and benchmarks are compiled. Nothing of this reaches a project
# that uses riprap: its warnings and its floating-point flags are its own choice.
# riprap_developer_target(TARGET [COMPILED]): with COMPILED linked to riprap::compiled, unless
# RIPRAP_TEST_COMPILED is off.

function(riprap_developer_target target)
  if(ARGN STREQUAL COMPILED AND RIPRAP_TEST_COMPILED)
    target_link_libraries(${target} PRIVATE riprap::compiled)
  else()
    target_link_libraries(${target} PRIVATE riprap::riprap)
  endif()
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)

  # Warnings that g++ 12 and clang 16 both know. Eigen, Boost and the other libraries are imported
  # targets, whose headers count as system headers and raise none.
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wold-style-cast -Wnon-virtual-dtor
    -Woverloaded-virtual -Wdouble-promotion -Wextra-semi
    # g++ 12 sees overlapping copies and bounds exceeded in plain std::string concatenation, depending
    # on what it inlines; g++ 13 no longer does. The sanitizers check both at run time.
    "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict;-Wno-array-bounds;-Wno-stringop-overflow>"
    $<$<BOOL:${RIPRAP_WARNINGS_AS_ERRORS}>:-Werror>)

  # The same input gives the same bytes, whatever the compiler and the optimisation level: a
  # product and a sum must not be fused into one rounding by one of them and not by the other.
  target_compile_options(${target} PRIVATE -ffp-contract=off)
endfunction()
