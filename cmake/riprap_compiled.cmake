# SPDX-License-Identifier: BSL-1.0
# riprap::compiled, a static library of what depends on no policy: programs that link it compile in
# less time and memory, with the same results. Built only where it is linked or installed.

# A source for each layer, of all its .ipp files.
file(GLOB_RECURSE definitions RELATIVE ${PROJECT_SOURCE_DIR}/include CONFIGURE_DEPENDS
     ${PROJECT_SOURCE_DIR}/include/riprap/*.ipp)
set(layers "")
foreach(file IN LISTS definitions)
  string(REGEX REPLACE "^riprap/([^/]+)/.*" "\\1" layer ${file})
  list(APPEND layers ${layer})
  string(APPEND includes_of_${layer} "#include <${file}>\n")
endforeach()
list(REMOVE_DUPLICATES layers)
set(sources "")
foreach(layer IN LISTS layers)
  set(source ${PROJECT_BINARY_DIR}/compiled/${layer}.cpp)
  set(more "")
  if(layer STREQUAL core)
    set(more "\nvoid riprap::internal::RIPRAP_INSTRUCTION_SET() {}\n")
  endif()
  file(CONFIGURE OUTPUT ${source} CONTENT "${includes_of_${layer}}${more}" @ONLY)
  list(APPEND sources ${source})
endforeach()

add_library(riprap_compiled STATIC EXCLUDE_FROM_ALL ${sources})
add_library(riprap::compiled ALIAS riprap_compiled)
set_target_properties(riprap_compiled PROPERTIES EXPORT_NAME compiled CXX_EXTENSIONS OFF
                                                 POSITION_INDEPENDENT_CODE ON)
target_link_libraries(riprap_compiled PUBLIC riprap)
target_compile_definitions(riprap_compiled PUBLIC RIPRAP_COMPILED)
# The same bytes as in a header-only program, whatever the processor.
target_compile_options(riprap_compiled PRIVATE -ffp-contract=off)
