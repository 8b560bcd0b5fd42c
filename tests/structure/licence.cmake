# SPDX-License-Identifier: BSL-1.0
# Every source file names its licence in its first line, or after the #! of a script.
cmake_policy(VERSION 3.21)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
file(GLOB_RECURSE files RELATIVE ${root}
     ${root}/.ci/* ${root}/benchmarks/* ${root}/cmake/* ${root}/docs/* ${root}/examples/*
     ${root}/include/* ${root}/tests/*)

set(violations "")
set(count 0)
foreach(file IN LISTS files ITEMS CMakeLists.txt)
  file(STRINGS ${root}/${file} lines LIMIT_COUNT 2)
  list(POP_FRONT lines first)
  if(first MATCHES "^#!")
    list(POP_FRONT lines first)
  elseif(NOT file MATCHES "(\\.([ch]pp|ipp|cmake|sh|py|in)|CMakeLists\\.txt)$")
    continue()
  endif()
  math(EXPR count "${count} + 1")
  if(NOT first MATCHES "^(//|#) SPDX-License-Identifier: BSL-1\\.0$")
    string(APPEND violations "\n  ${file}")
  endif()
endforeach()

if(violations OR count LESS 100)
  message(FATAL_ERROR "These of ${count} files do not begin with the line\n"
                      "  SPDX-License-Identifier: BSL-1.0\nas a comment:${violations}\n")
endif()

file(STRINGS ${root}/LICENSE first LIMIT_COUNT 1)
if(NOT first MATCHES "^Copyright \\(c\\) 20[0-9][0-9].* the riprap authors$")
  message(FATAL_ERROR "LICENSE does not begin with the copyright of the riprap authors")
endif()
