// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Writes fields into a file or group of HDF5. Needs that library.

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/checkpoint/hdf5_handle.hpp>
#include <riprap/checkpoint/sealed_image.hpp>
#include <riprap/core/version.hpp>

namespace riprap::internal {

/// Writes fields into an open file or group.
class Hdf5Writer {
 public:
  // As deep as types are nested. NOLINTNEXTLINE(misc-no-recursion)
  static void write_children(hid_t group, const FieldNode& node) {
    for (const FieldNode& child : node.children) write(group, child);
  }

  /// What wrote the file: schema of its layout, versions of riprap and of HDF5.
  static void write_versions(hid_t top) {
    write_number_attribute(top, "schema", checkpoint_schema);
    write_text_attribute(top, "riprap", std::string(version));
    unsigned number[3] = {};
    hdf5_require(H5get_libversion(number, number + 1, number + 2) >= 0, "say its version");
    write_text_attribute(top, "hdf5",
                         std::to_string(number[0]) + '.' + std::to_string(number[1]) + '.' +
                             std::to_string(number[2]));
  }

  /// Of a group or an array.
  static void write_attributes(hid_t object, const FieldNode& node) {
    if (!node.type.empty()) write_text_attribute(object, "type", node.type);
    if (node.is_sequence) write_number_attribute(object, "rows", node.rows);
  }

 private:
  // As deep as types are nested. NOLINTNEXTLINE(misc-no-recursion)
  static void write(hid_t parent, const FieldNode& node) {
    const std::string name(node.name());
    if (node.kind == FieldNode::Kind::group) {
      const Hdf5Id properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose, "make a property list");
      H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
      H5Pset_obj_track_times(properties, false);
      const Hdf5Id group(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT),
                         H5Gclose, "write " + node.path);
      write_attributes(group, node);
      write_children(group, node);
    } else if (node.kind == FieldNode::Kind::text) {
      const Hdf5Id type(text_type(node.bytes.size()), H5Tclose, "make a type");
      const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose, "make a dataspace");
      write_array(parent, name, node, type, type, space, H5P_DEFAULT);
    } else {
      write_numbers(parent, name, node);
    }
  }

  static void write_numbers(hid_t parent, const std::string& name, const FieldNode& node) {
    const Hdf5Id properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "make a property list");
    H5Pset_obj_track_times(properties, false);
    std::vector<hsize_t> extents;
    if (node.is_sequence) extents.push_back(node.rows);
    if (node.columns != 1) extents.push_back(node.columns);
    const int rank = static_cast<int>(extents.size());
    const Hdf5Id space(rank == 0 ? H5Screate(H5S_SCALAR)
                                 : H5Screate_simple(rank, extents.data(), nullptr),
                       H5Sclose, "make a dataspace");
    if (node.is_sequence && node.rows > 0) {
      // Some 100 kB each.
      std::vector<hsize_t> chunk = extents;
      chunk[0] = std::clamp<hsize_t>(100'000 / node.row_size(), 1, node.rows);
      H5Pset_chunk(properties, rank, chunk.data());
      H5Pset_fletcher32(properties);
    }
    write_array(parent, name, node, hdf5_type(node.number), hdf5_native_type(node.number), space,
                properties);
  }

  static void write_array(hid_t parent, const std::string& name, const FieldNode& node,
                          hid_t type_in_file, hid_t type, hid_t space, hid_t properties) {
    const Hdf5Id set(
        H5Dcreate2(parent, name.c_str(), type_in_file, space, H5P_DEFAULT, properties, H5P_DEFAULT),
        H5Dclose, "write " + node.path);
    write_attributes(set, node);
    if (node.bytes.empty()) return;
    hdf5_require(H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, node.bytes.data()) >= 0,
                 "write " + node.path);
  }

  [[nodiscard]] static hid_t text_type(std::size_t size) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, std::max<std::size_t>(size, 1));
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    return type;
  }
  static void write_number_attribute(hid_t object, const char* name, std::uint64_t number) {
    const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose, "make a dataspace");
    const Hdf5Id attribute(H5Acreate2(object, name, H5T_STD_U64LE, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, std::string("write the attribute ") + name);
    hdf5_require(H5Awrite(attribute, H5T_NATIVE_UINT64, &number) >= 0, "write an attribute");
  }
  static void write_text_attribute(hid_t object, const char* name, const std::string& text) {
    const Hdf5Id type(text_type(text.size()), H5Tclose, "make a type");
    const Hdf5Id space(H5Screate(H5S_SCALAR), H5Sclose, "make a dataspace");
    const Hdf5Id attribute(H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, std::string("write the attribute ") + name);
    hdf5_require(H5Awrite(attribute, type, text.data()) >= 0, "write an attribute");
  }
};

}  // namespace riprap::internal
