# SPDX-License-Identifier: BSL-1.0
# Defines riprap::hdf5, for the headers of include/riprap/checkpoint that need HDF5, where the C
# library is found. Here and in the installed package. Not CMake's FindHDF5, which asks for a C
# compiler.
find_path(RIPRAP_HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(RIPRAP_HDF5_LIBRARY NAMES hdf5_serial hdf5 PATH_SUFFIXES hdf5/serial)
mark_as_advanced(RIPRAP_HDF5_INCLUDE_DIR RIPRAP_HDF5_LIBRARY)
if(RIPRAP_HDF5_INCLUDE_DIR AND RIPRAP_HDF5_LIBRARY AND NOT TARGET riprap::hdf5)
  add_library(riprap::hdf5 INTERFACE IMPORTED GLOBAL)
  target_include_directories(riprap::hdf5 INTERFACE ${RIPRAP_HDF5_INCLUDE_DIR})
  target_link_libraries(riprap::hdf5 INTERFACE riprap::riprap ${RIPRAP_HDF5_LIBRARY})
endif()
