# SPDX-License-Identifier: BSL-1.0
# Configures riprap, and a project that finds an installed riprap under `prefix`, with packages of
# Eigen that claim other versions than that of the headers they name: 3.3 and later are accepted,
# whatever the major version; an older one is refused in one sentence.
cmake_policy(VERSION 3.21)
include(CMakePackageConfigHelpers)

# Like Eigen's own package, it accepts requests for its own major version only.
function(write_eigen folder version)
  file(WRITE ${folder}/Eigen3Config.cmake
       "add_library(Eigen3::Eigen INTERFACE IMPORTED)\n"
       "target_include_directories(Eigen3::Eigen INTERFACE \"${eigen}\")\n")
  write_basic_package_version_file(${folder}/Eigen3ConfigVersion.cmake VERSION ${version}
                                   COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
  file(WRITE ${folder}/eigen3.pc
       "Name: Eigen3\nDescription: for a test\nVersion: ${version}\nCflags: -I${eigen}\n")
endfunction()

# expect(WHAT SENTENCE): `result` and `said` of WHAT are those of an acceptance, or of a refusal with
# SENTENCE.
function(expect what sentence)
  string(REGEX REPLACE "[ \n]+" " " text "${said}")
  string(FIND "${text}" "${sentence}" place)
  if(accepted AND NOT result EQUAL 0 OR NOT accepted AND (result EQUAL 0 OR place EQUAL -1))
    message(FATAL_ERROR "${what} with Eigen ${version} ends with ${result}:\n${said}")
  endif()
endfunction()

file(REMOVE_RECURSE ${folder})
file(WRITE ${folder}/user/CMakeLists.txt
     "cmake_minimum_required(VERSION 3.21...3.30)\nproject(user LANGUAGES CXX)\n"
     "find_package(riprap REQUIRED)\n")
foreach(version IN ITEMS 3.2.10 3.3.0 5.0.1)
  write_eigen(${folder}/${version} ${version})
  set(accepted ON)
  if(version VERSION_LESS 3.3)
    set(accepted OFF)
  endif()
  foreach(project IN ITEMS ${source} ${folder}/user)
    set(build ${folder}/build)
    file(REMOVE_RECURSE ${build})
    execute_process(
      COMMAND ${CMAKE_COMMAND} -S ${project} -B ${build} -G ${generator}
              -DCMAKE_CXX_COMPILER=${compiler} "-DCMAKE_PREFIX_PATH=${prefix};${prefix_path}"
              -DEigen3_DIR=${folder}/${version}
              -DRIPRAP_BUILD_TESTS=OFF -DRIPRAP_BUILD_EXAMPLES=OFF -DRIPRAP_BUILD_BENCHMARKS=OFF
      RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
    expect(${project} "riprap needs Eigen 3.3 or later; ${folder}/${version} has ${version}")
    # Instead of a package that it refuses, CMake may find another one.
    file(STRINGS ${build}/CMakeCache.txt found REGEX "^Eigen3_DIR:")
    string(REGEX REPLACE "^[^=]*=" "" found "${found}")
    if(NOT found STREQUAL "${folder}/${version}")
      message(FATAL_ERROR "${project} passes over Eigen ${version} and takes ${found}")
    endif()
  endforeach()
  if(pkg_config)
    set(ENV{PKG_CONFIG_PATH} ${folder}/${version}:${prefix}/share/pkgconfig)
    execute_process(COMMAND ${pkg_config} --print-errors --cflags riprap
                    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE said)
    expect(pkg-config "eigen3 >= 3.3")
  endif()
endforeach()
