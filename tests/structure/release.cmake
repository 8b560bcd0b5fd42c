# SPDX-License-Identifier: BSL-1.0
# The version and the date of the latest release are the same wherever they are written.
cmake_policy(VERSION 3.21)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
file(STRINGS ${root}/include/riprap/core/version.hpp version
     REGEX "^#define RIPRAP_VERSION_(MAJOR|MINOR|PATCH) [0-9]+$")
string(REGEX MATCHALL "[0-9]+" version "${version}")
list(JOIN version "." version)

file(STRINGS ${root}/CHANGELOG.md release REGEX "^## [0-9]" LIMIT_COUNT 1)
if(NOT release MATCHES "^## ([0-9.]+) - (20[0-9][0-9]-[01][0-9]-[0-3][0-9])$")
  message(FATAL_ERROR "CHANGELOG.md: '${release}' is not '## VERSION - YYYY-MM-DD'")
endif()
set(date ${CMAKE_MATCH_2})
file(READ ${root}/CITATION.cff citation)
if(NOT CMAKE_MATCH_1 STREQUAL version
   OR NOT citation MATCHES "\nversion: ${version}\ndate-released: \"${date}\"\n")
  message(FATAL_ERROR "version.hpp has ${version}, CHANGELOG.md '${release}'; one of them, or the "
                      "version and the date in CITATION.cff, is another")
endif()
