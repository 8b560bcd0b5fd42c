# SPDX-License-Identifier: BSL-1.0
# Every header includes compiler.hpp, or another one that does, so that an old compiler reports
# its sentence before anything else.
get_filename_component(include ${CMAKE_CURRENT_LIST_DIR}/../../include ABSOLUTE)
file(GLOB_RECURSE headers RELATIVE ${include} ${include}/riprap/*.hpp)
list(REMOVE_ITEM headers riprap/core/compiler.hpp)

set(violations "")
foreach(header IN LISTS headers)
  file(STRINGS ${include}/${header} lines REGEX "^#include <riprap/")
  if(NOT lines)
    string(APPEND violations "\n  include/${header}")
  endif()
endforeach()

if(violations)
  message(FATAL_ERROR "These have to include <riprap/core/compiler.hpp>:${violations}\n")
endif()
