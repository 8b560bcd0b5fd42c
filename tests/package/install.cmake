# SPDX-License-Identifier: BSL-1.0
# Installs riprap as its user would, and then moves it to `prefix`. Clears what the package tests
# have left there before.
get_filename_component(folder ${prefix} DIRECTORY)
set(build ${folder}/build)
set(first ${folder}/first)
foreach(left build first moved installed compiled add_subdirectory fetch_content pkg_config)
  file(REMOVE_RECURSE ${folder}/${left})
endforeach()
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${source} -B ${build} -G ${generator}
          -DCMAKE_CXX_COMPILER=${compiler} "-DCMAKE_PREFIX_PATH=${prefix_path}"
          -DRIPRAP_BUILD_TESTS=OFF -DRIPRAP_BUILD_EXAMPLES=OFF -DRIPRAP_BUILD_BENCHMARKS=OFF
          -DRIPRAP_INSTALL_COMPILED=ON -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_BUILD_TYPE=Release
          -DCMAKE_CXX_FLAGS_RELEASE=-O0  # compiling takes longer than running
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build ${build} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${build} --prefix ${first}
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${first} ${prefix})

file(GLOB_RECURSE wanted RELATIVE ${source} ${source}/include/*.hpp ${source}/include/*.ipp)
list(APPEND wanted
     share/cmake/riprap/riprapConfig.cmake share/cmake/riprap/riprapConfigVersion.cmake
     share/cmake/riprap/riprapTargets-release.cmake share/cmake/riprap/riprapTargets.cmake
     share/cmake/riprap/riprap_hdf5.cmake
     lib/libriprap_compiled.a share/doc/riprap/LICENSE share/pkgconfig/riprap.pc)
file(GLOB_RECURSE files RELATIVE ${prefix} ${prefix}/*)
list(SORT files)
list(SORT wanted)
if(NOT files STREQUAL wanted)
  message(FATAL_ERROR "Installed:\n${files}\nThis should be:\n${wanted}")
endif()

list(FILTER files INCLUDE REGEX "^share/")
foreach(file IN LISTS files)
  file(READ ${prefix}/${file} text)
  foreach(place ${build} ${source} ${first})
    string(FIND "${text}" ${place} found)
    if(NOT found EQUAL -1)
      message(FATAL_ERROR "${file} names ${place}: the package cannot be moved")
    endif()
  endforeach()
endforeach()
