# SPDX-License-Identifier: BSL-1.0
# Runs the program of the README header-only and with riprap::compiled: the tables are the same to
# the last byte.
cmake_policy(VERSION 3.21)
foreach(way header_only compiled)
  file(REMOVE_RECURSE ${folder}/${way})
  file(MAKE_DIRECTORY ${folder}/${way})
  execute_process(COMMAND ${${way}} WORKING_DIRECTORY ${folder}/${way}
                  OUTPUT_QUIET ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${folder}/header_only/biaxial.csv
                        ${folder}/compiled/biaxial.csv
                COMMAND_ERROR_IS_FATAL ANY)
