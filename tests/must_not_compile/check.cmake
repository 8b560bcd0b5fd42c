# SPDX-License-Identifier: BSL-1.0
# Compiles a program, to its first error or, with `whole`, to its end, and compares the error with the
# comment that the program begins with, after the line of the licence. A policy that makes the mistake
# is called Mine; the error must name it. With RIPRAP_COMPILED there is less to parse.
cmake_policy(VERSION 3.21)

file(READ ${program} text)
string(REGEX REPLACE "^// SPDX-[^\n]*\n" "" text "${text}")
string(REGEX MATCH "^(// [^\n]*\n)+" comment "${text}")
string(REGEX REPLACE "\n?// " " " sentence "${comment}")
string(STRIP "${sentence}" sentence)
list(TRANSFORM includes PREPEND -I)
set(ENV{LC_ALL} C)
set(stop -Wfatal-errors)
if(whole)
  set(stop "")
endif()
execute_process(COMMAND ${compiler} -std=c++20 -fsyntax-only -DRIPRAP_COMPILED ${stop} ${includes} ${program}
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
if(result EQUAL 0)
  message(FATAL_ERROR "${program} compiles")
endif()

string(REGEX MATCHALL "[^\n]*error: [^\n]*" errors "${said}")
list(LENGTH errors count)
string(FIND "${errors}" "error: static assertion failed: ${sentence}" place)
if(NOT count EQUAL 1 OR place EQUAL -1)
  message(FATAL_ERROR "not one error, which says \"${sentence}\", but:\n${said}")
endif()
if(text MATCHES "Mine" AND NOT said MATCHES "(= |<)(const )?Mine ?[],>;*]")
  message(FATAL_ERROR "the error does not name the policy's type:\n${said}")
endif()
