// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads fields from a file or group of HDF5. Needs that library.

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/checkpoint/hdf5_handle.hpp>

namespace riprap::internal {

/// Reads what Hdf5Writer has written. Throws SimulationError if HDF5 fails.
class Hdf5Reader {
 public:
  /// The attributes and fields of an open group.
  // As deep as types are nested. NOLINTNEXTLINE(misc-no-recursion)
  static void read_group(hid_t group, FieldNode& node) {
    read_attributes(group, node);
    H5G_info_t info;
    hdf5_require(H5Gget_info(group, &info) >= 0, "read " + node.path);
    for (hsize_t k = 0; k < info.nlinks; ++k) {
      FieldNode& child = node.child_at(node.children.size(), link_name(group, k));
      child.is_sequence = false;  // its own attributes say
      const Hdf5Id object(H5Oopen(group, std::string(child.name()).c_str(), H5P_DEFAULT), H5Oclose,
                          "read " + child.path);
      if (H5Iget_type(object) == H5I_GROUP)
        read_group(object, child);
      else
        read_array(object, child);
    }
  }

 private:
  [[nodiscard]] static std::string link_name(hid_t group, hsize_t k) {
    const auto name_of = [&](char* name, std::size_t size) {
      const ssize_t length = H5Lget_name_by_idx(group, ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, k,
                                                name, size, H5P_DEFAULT);
      hdf5_require(length >= 0, "read a name");
      return static_cast<std::size_t>(length);
    };
    std::string name(name_of(nullptr, 0), '\0');
    (void)name_of(name.data(), name.size() + 1);
    return name;
  }

  static void read_attributes(hid_t object, FieldNode& node) {
    if (H5Aexists(object, "rows") > 0) {
      node.is_sequence = true;
      std::uint64_t rows = 0;
      const Hdf5Id attribute(H5Aopen(object, "rows", H5P_DEFAULT), H5Aclose, "read " + node.path);
      hdf5_require(H5Aread(attribute, H5T_NATIVE_UINT64, &rows) >= 0, "read " + node.path);
      node.rows = rows;
    } else {
      node.rows = 1;
    }
    if (H5Aexists(object, "type") <= 0) return;
    const Hdf5Id attribute(H5Aopen(object, "type", H5P_DEFAULT), H5Aclose, "read " + node.path);
    const Hdf5Id type(H5Aget_type(attribute), H5Tclose, "read " + node.path);
    node.type.resize(H5Tget_size(type));
    hdf5_require(H5Aread(attribute, type, node.type.data()) >= 0, "read " + node.path);
  }

  static void read_array(hid_t set, FieldNode& node) {
    read_attributes(set, node);
    const Hdf5Id in_file(H5Dget_type(set), H5Tclose, "read " + node.path);
    const Hdf5Id space(H5Dget_space(set), H5Sclose, "read " + node.path);
    const auto numbers = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
    hid_t type = in_file;
    if (H5Tget_class(in_file) == H5T_STRING) {
      node.kind = FieldNode::Kind::text;
      // HDF5 has no strings of length zero: one with a zero in it stands for them.
      node.bytes.resize(H5Tget_size(in_file));
    } else {
      node.kind = FieldNode::Kind::numbers;
      node.number = number_type_of(in_file, node.path);
      node.columns = node.rows > 0 ? numbers / node.rows : columns_of(space);
      node.bytes.resize(numbers * size_of(node.number));
      type = hdf5_native_type(node.number);
    }
    if (!node.bytes.empty())
      hdf5_require(H5Dread(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, node.bytes.data()) >= 0,
                   "read " + node.path);
    if (node.kind == FieldNode::Kind::text && node.text() == std::string(1, '\0'))
      node.bytes.clear();
  }

  // Of an array without rows.
  [[nodiscard]] static std::size_t columns_of(hid_t space) {
    std::vector<hsize_t> extents(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    (void)H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return extents.size() == 2 ? static_cast<std::size_t>(extents[1]) : 1;
  }

  [[nodiscard]] static NumberType number_type_of(hid_t in_file, const std::string& path) {
    for (int k = 0; k < 10; ++k) {
      const auto type = static_cast<NumberType>(k);
      if (H5Tequal(in_file, hdf5_type(type)) > 0) return type;
    }
    throw SimulationError("HDF5: " + path + " has numbers of an unknown type");
  }
};

}  // namespace riprap::internal
