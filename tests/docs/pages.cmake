# SPDX-License-Identifier: BSL-1.0
# A page shows the program of its example, to the letter but for the line of the licence, between
# fences; every page of docs/policies has a program and every program a page. The README shows
# examples/compose likewise, without the line that says what it does.
cmake_policy(VERSION 3.21)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
set(violations "")

# Compares PAGE with the program of FILE, both relative to the root.
function(compare page file)
  if(NOT EXISTS ${root}/${page} OR NOT EXISTS ${root}/${file})
    string(APPEND violations "\n  ${page} or ${file} is missing")
  else()
    file(READ ${root}/${page} shown)
    file(READ ${root}/${file} text)
    string(REGEX REPLACE "^// SPDX-[^\n]*\n" "" text "${text}")
    string(REGEX REPLACE "^// [a-z_]+:[^\n]*\n" "" text "${text}")
    string(FIND "${shown}" "\n```cpp\n${text}```\n" place)
    if(place EQUAL -1)
      string(APPEND violations "\n  ${page} does not show ${file} as it is")
    endif()
  endif()
  set(violations "${violations}" PARENT_SCOPE)
endfunction()

file(GLOB pages ${root}/docs/policies/*.md)
file(GLOB programs ${root}/docs/policies/examples/*.cpp)
set(roles "")
foreach(path IN LISTS pages programs)
  get_filename_component(role ${path} NAME_WE)
  list(APPEND roles ${role})
endforeach()
list(REMOVE_DUPLICATES roles)
foreach(role IN LISTS roles)
  compare(docs/policies/${role}.md docs/policies/examples/${role}.cpp)
endforeach()
compare(docs/conformance.md docs/examples/conformance.cpp)
compare(docs/reading.md docs/examples/reading.cpp)
compare(docs/unconfined.md docs/examples/unconfined.cpp)
compare(README.md examples/compose/compose.cpp)

if(violations OR NOT roles)
  message(FATAL_ERROR "Pages and programs differ:${violations}\n")
endif()
