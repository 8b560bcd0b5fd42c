# SPDX-License-Identifier: BSL-1.0
# A plain configuration without a library that is needed says which option does without it, and the
# README names all options.
file(REMOVE_RECURSE ${build})
foreach(part IN ITEMS doctest:TESTS CLI11:EXAMPLES nlohmann_json:EXAMPLES)
  string(REPLACE ":" ";" part ${part})
  list(GET part 0 library)
  list(GET part 1 option)
  execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${build} -G ${generator}
                          -DCMAKE_CXX_COMPILER=${compiler} "-DCMAKE_PREFIX_PATH=${prefix_path}"
                          -DRIPRAP_BUILD_TESTS=OFF -DRIPRAP_BUILD_EXAMPLES=OFF
                          -DRIPRAP_BUILD_${option}=ON -UCMAKE_DISABLE_FIND_PACKAGE_*
                          -DCMAKE_DISABLE_FIND_PACKAGE_${library}=ON
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " text "${said}")
  string(FIND "${text}" "was not found; -DRIPRAP_BUILD_${option}=OFF leaves the" place)
  if(result EQUAL 0 OR place EQUAL -1 OR NOT text MATCHES "riprap: ${library}, ")
    message(FATAL_ERROR "Without ${library} the configuration ends with ${result}:\n${said}")
  endif()
endforeach()

file(READ ${source}/README.md readme)
file(STRINGS ${source}/CMakeLists.txt options REGEX "^option\\(RIPRAP_")
foreach(option IN LISTS options)
  string(REGEX MATCH "RIPRAP_[A-Z_]+" option "${option}")
  if(NOT readme MATCHES "`${option}`")
    message(FATAL_ERROR "README.md does not name ${option}")
  endif()
endforeach()
