# SPDX-License-Identifier: BSL-1.0
# Headers that pages name are there: `folder/name.hpp` in back quotes, relative to include/riprap, to
# include or to the root.
cmake_policy(VERSION 3.21)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
file(GLOB_RECURSE pages ${root}/docs/*.md)
list(APPEND pages ${root}/README.md ${root}/CONTRIBUTING.md)

set(violations "")
set(count 0)
foreach(page IN LISTS pages)
  file(READ ${page} text)
  string(REGEX MATCHALL "`[a-z0-9_/]+/[a-z0-9_]+\\.hpp`" names "${text}")
  list(REMOVE_DUPLICATES names)
  foreach(name IN LISTS names)
    string(REPLACE "`" "" name "${name}")
    math(EXPR count "${count} + 1")
    if(NOT EXISTS ${root}/include/riprap/${name} AND NOT EXISTS ${root}/include/${name} AND
       NOT EXISTS ${root}/${name})
      string(REPLACE "${root}/" "" page "${page}")
      string(APPEND violations "\n  ${page}: ${name}")
    endif()
  endforeach()
endforeach()

if(violations OR count LESS 50)
  message(FATAL_ERROR "Headers that are not there, of ${count} that pages name:${violations}\n")
endif()
