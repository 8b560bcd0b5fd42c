# SPDX-License-Identifier: BSL-1.0
# Compiles main.cpp with a compiler, or a standard, that riprap does not support: the first error must
# be the sentence of compiler.hpp.
list(TRANSFORM includes PREPEND -I)
set(ENV{LC_ALL} C)
execute_process(COMMAND ${compiler} ${options} -w -Wfatal-errors -fsyntax-only ${includes}
                        ${CMAKE_CURRENT_LIST_DIR}/main.cpp
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
string(REGEX MATCH "[^\n]*error: [^\n]*" first "${said}")
string(FIND "${first}" "\"${sentence}\"" place)
if(result EQUAL 0 OR place EQUAL -1)
  message(FATAL_ERROR "The first error is not \"${sentence}\", but \"${first}\"")
endif()
