# SPDX-License-Identifier: BSL-1.0
# cmake --install: the headers, what find_package and pkg-config need to find them, the licence; on
# request the library riprap::compiled.
# Nothing installed holds an absolute path, so the tree may be moved.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/riprap)
set(pkgconfig_dir ${CMAKE_INSTALL_DATADIR}/pkgconfig)
set(generated ${PROJECT_BINARY_DIR}/package)

install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/riprap DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN *.hpp PATTERN *.ipp)
# Not CMAKE_INSTALL_DOCDIR, which bears the name of the project at the top.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/doc/riprap)

install(TARGETS riprap EXPORT riprapTargets INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
if(RIPRAP_INSTALL_COMPILED)
  set_target_properties(riprap_compiled PROPERTIES EXCLUDE_FROM_ALL OFF)
  install(TARGETS riprap_compiled EXPORT riprapTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
else()
  set(arch_independent ARCH_INDEPENDENT)
endif()
install(EXPORT riprapTargets NAMESPACE riprap:: DESTINATION ${package_dir})
configure_file(cmake/riprapConfig.cmake.in ${generated}/riprapConfig.cmake @ONLY)
# Before 1.0 a new minor version may break what used the last one.
write_basic_package_version_file(${generated}/riprapConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion ${arch_independent})
install(FILES ${generated}/riprapConfig.cmake ${generated}/riprapConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/cmake/riprap_hdf5.cmake
        DESTINATION ${package_dir})

# The way back from riprap.pc to the prefix. A directory given as an absolute path stays as it is.
set(pc_prefix ${CMAKE_INSTALL_PREFIX})
if(NOT IS_ABSOLUTE ${pkgconfig_dir})
  set(way_back /prefix)
  cmake_path(RELATIVE_PATH way_back BASE_DIRECTORY /prefix/${pkgconfig_dir})
  set(pc_prefix "\${pcfiledir}/${way_back}")
endif()
set(pc_include "\${prefix}")
cmake_path(APPEND pc_include ${CMAKE_INSTALL_INCLUDEDIR})
configure_file(cmake/riprap.pc.in ${generated}/riprap.pc @ONLY)
install(FILES ${generated}/riprap.pc DESTINATION ${pkgconfig_dir})
