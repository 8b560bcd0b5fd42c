# SPDX-License-Identifier: BSL-1.0
# doctest's Approx(x).epsilon(e) allows e (1 + |x|): of numbers far below 1, lengths in metres for
# one, it lets anything pass.
get_filename_component(tests ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
file(GLOB_RECURSE sources RELATIVE ${tests} ${tests}/*.hpp ${tests}/*.cpp)

set(violations "")
foreach(source IN LISTS sources)
  file(STRINGS ${tests}/${source} lines REGEX "doctest::Approx")
  if(lines)
    string(APPEND violations "\n  tests/${source}")
  endif()
endforeach()

if(violations)
  message(FATAL_ERROR "doctest::Approx(x).epsilon(e) allows e (1 + |x|), far more than a share e of a "
                      "small x. Compare with near or near_relative of tests/support/near.hpp "
                      "in:${violations}\n")
endif()
