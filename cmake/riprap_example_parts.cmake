# SPDX-License-Identifier: BSL-1.0
# Parts of the examples that tests are made of as well, compiled once for both. Static libraries, of
# which a program takes what it uses.
find_package(Threads REQUIRED)
find_package(nlohmann_json QUIET)
find_package(CLI11 QUIET)

# riprap_example_part(NAME LIBRARIES... SOURCES SOURCE...), sources relative to examples/.
function(riprap_example_part name)
  cmake_parse_arguments(part "" "" "LIBRARIES;SOURCES" ${ARGN})
  list(TRANSFORM part_SOURCES PREPEND ${PROJECT_SOURCE_DIR}/examples/)
  add_library(${name} STATIC EXCLUDE_FROM_ALL ${part_SOURCES})
  target_include_directories(${name} PUBLIC ${PROJECT_SOURCE_DIR}/examples)
  target_link_libraries(${name} PUBLIC ${part_LIBRARIES})
  riprap_developer_target(${name} COMPILED)
  # Compiling takes longer than running.
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# Runs one after the other on several threads, and what they leave.
file(GLOB sources RELATIVE ${PROJECT_SOURCE_DIR}/examples CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/examples/run_table/*.cpp)
riprap_example_part(riprap_run_table LIBRARIES Threads::Threads SOURCES ${sources})
# The strength of particles of bonded cells.
riprap_example_part(riprap_bonded_disc SOURCES bonded_disc/disc_strength.cpp)
# What the tests along loading paths measure.
riprap_example_part(riprap_paths SOURCES paths/measures.cpp)
# What the study of convergence computes.
riprap_example_part(riprap_convergence SOURCES convergence/closed_forms.cpp
  convergence/graded_mesh.cpp convergence/loaded_particle.cpp convergence/strength.cpp)

if(TARGET nlohmann_json::nlohmann_json)
  # All of the study but its program and its runs.
  file(GLOB sources RELATIVE ${PROJECT_SOURCE_DIR}/examples CONFIGURE_DEPENDS
       ${PROJECT_SOURCE_DIR}/examples/paper/*/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/runs/run_[a-z_]+\\.cpp$")
  riprap_example_part(riprap_paper LIBRARIES riprap_run_table nlohmann_json::nlohmann_json SOURCES ${sources})
  # What makes the page of a replay.
  riprap_example_part(riprap_replay LIBRARIES nlohmann_json::nlohmann_json
    SOURCES replay/recorded_run.cpp replay/frame_measures.cpp replay/pack.cpp
            replay/page.cpp)
  include(${PROJECT_SOURCE_DIR}/examples/replay/page_parts.cmake)
  target_sources(riprap_replay PRIVATE ${page_parts})
endif()

if(TARGET nlohmann_json::nlohmann_json AND TARGET CLI11::CLI11)
  # What reads the command lines.
  file(GLOB sources RELATIVE ${PROJECT_SOURCE_DIR}/examples CONFIGURE_DEPENDS
       ${PROJECT_SOURCE_DIR}/examples/command_line/*.cpp)
  riprap_example_part(riprap_command_line
    LIBRARIES CLI11::CLI11 nlohmann_json::nlohmann_json SOURCES ${sources})
  file(GLOB sources RELATIVE ${PROJECT_SOURCE_DIR}/examples CONFIGURE_DEPENDS
       ${PROJECT_SOURCE_DIR}/examples/biaxial/*options.cpp)
  riprap_example_part(riprap_biaxial_options
    LIBRARIES riprap_command_line SOURCES ${sources} biaxial/policies.cpp)
  # The options refuse several threads where there is no OpenMP.
  if(TARGET riprap::threads)
    target_link_libraries(riprap_biaxial_options PRIVATE riprap::threads)
  endif()
  # All of the study of a table but its program.
  file(GLOB sources RELATIVE ${PROJECT_SOURCE_DIR}/examples CONFIGURE_DEPENDS
       ${PROJECT_SOURCE_DIR}/examples/study/*.cpp)
  list(REMOVE_ITEM sources study/study.cpp)
  riprap_example_part(riprap_study LIBRARIES riprap_biaxial_options riprap_run_table
                      SOURCES ${sources})
  target_compile_definitions(riprap_study PUBLIC
    RIPRAP_STUDY_TABLES="${PROJECT_SOURCE_DIR}/examples/study/tables")
  riprap_example_part(riprap_single_particle
    LIBRARIES riprap_command_line SOURCES single_particle/options.cpp single_particle/analysis.cpp)
  # What the examples of shear tests have in common, and what tests check of each.
  riprap_example_part(riprap_shear_tests LIBRARIES riprap_command_line riprap_run_table
    SOURCES shear_tests/options.cpp shear_tests/results.cpp
            shear_tests/cell_results.cpp study/statistics.cpp direct_shear/shear_box.cpp direct_shear/features.cpp)
endif()
