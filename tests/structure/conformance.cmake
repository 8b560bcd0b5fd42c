# SPDX-License-Identifier: BSL-1.0
# Every model that is shipped runs through the axioms of its role: tests/conformance/ROLE_test.cpp includes
# its header. A model is a header beside its role's concepts.hpp that asserts the concept, or a
# choice at run time.
cmake_policy(VERSION 3.21)
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)

# Their axiom is the same: no result depends on them.
foreach(role neighbour_list detection screening operator_store)
  set(role_of_${role} acceleration)
endforeach()

set(violations "")
set(count 0)
file(GLOB concepts ${root}/include/riprap/*/*/concepts.hpp)
foreach(concept IN LISTS concepts)
  get_filename_component(folder ${concept} DIRECTORY)
  get_filename_component(role ${folder} NAME)
  if(DEFINED role_of_${role})
    set(role ${role_of_${role}})
  endif()
  if(NOT EXISTS ${root}/tests/conformance/${role}_test.cpp)
    string(APPEND violations "\n  tests/conformance/${role}_test.cpp is missing")
    continue()
  endif()
  file(READ ${root}/tests/conformance/${role}_test.cpp test)

  file(GLOB headers RELATIVE ${root}/include ${folder}/*.hpp)
  foreach(header IN LISTS headers)
    file(READ ${root}/include/${header} text)
    if(NOT header MATCHES "_choice\\.hpp$" AND NOT text MATCHES "\nstatic_assert\\([A-Za-z]+<")
      continue()
    endif()
    math(EXPR count "${count} + 1")
    string(FIND "${test}" "#include <${header}>" place)
    if(place EQUAL -1)
      string(APPEND violations "\n  tests/conformance/${role}_test.cpp does not include ${header}")
    endif()
  endforeach()
endforeach()

if(violations OR count EQUAL 0)
  message(FATAL_ERROR "Models without a test of their axioms, among ${count}:${violations}\n")
endif()
