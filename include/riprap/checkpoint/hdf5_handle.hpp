// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Identifiers, errors and types of the C interface of HDF5. Needs that library.

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <utility>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/core/errors.hpp>

namespace riprap::internal {

/// An identifier of HDF5, closed at the end. Throws SimulationError for one that is not valid.
class Hdf5Id {
 public:
  Hdf5Id(hid_t id, herr_t (*close_with)(hid_t), const std::string& what)
      : id_(id), close_(close_with) {
    if (id < 0) throw SimulationError("HDF5: cannot " + what);
  }
  ~Hdf5Id() { close(); }
  Hdf5Id(const Hdf5Id&) = delete;
  Hdf5Id& operator=(const Hdf5Id&) = delete;

  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor): a handle
  void close() {
    if (id_ >= 0) (void)close_(std::exchange(id_, -1));
  }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

inline void hdf5_require(bool succeeded, const std::string& what) {
  if (!succeeded) throw SimulationError("HDF5: cannot " + what);
}

/// HDF5 prints no messages of its own while one of these lives: they go into exceptions.
class Hdf5Quiet {
 public:
  Hdf5Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Hdf5Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Hdf5Quiet(const Hdf5Quiet&) = delete;
  Hdf5Quiet& operator=(const Hdf5Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Little-endian types in files, in the order of NumberType.
[[nodiscard]] inline hid_t hdf5_type(NumberType type) {
  const hid_t types[] = {H5T_STD_I8LE,   H5T_STD_I16LE, H5T_STD_I32LE, H5T_STD_I64LE,
                         H5T_STD_U8LE,   H5T_STD_U16LE, H5T_STD_U32LE, H5T_STD_U64LE,
                         H5T_IEEE_F32LE, H5T_IEEE_F64LE};
  return types[static_cast<std::size_t>(type)];
}
/// Types in memory.
[[nodiscard]] inline hid_t hdf5_native_type(NumberType type) {
  const hid_t types[] = {H5T_NATIVE_INT8,  H5T_NATIVE_INT16,  H5T_NATIVE_INT32,  H5T_NATIVE_INT64,
                         H5T_NATIVE_UINT8, H5T_NATIVE_UINT16, H5T_NATIVE_UINT32, H5T_NATIVE_UINT64,
                         H5T_NATIVE_FLOAT, H5T_NATIVE_DOUBLE};
  return types[static_cast<std::size_t>(type)];
}

}  // namespace riprap::internal
