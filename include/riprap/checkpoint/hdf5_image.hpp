// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Fields as an HDF5 file in memory, and back. Needs the library HDF5 (target riprap::hdf5).

#include <hdf5.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <riprap/checkpoint/field_node.hpp>
#include <riprap/checkpoint/hdf5_handle.hpp>
#include <riprap/checkpoint/hdf5_reader.hpp>
#include <riprap/checkpoint/hdf5_writer.hpp>

namespace riprap {

/// Bytes at the beginning of a file that are not HDF5's: it finds its own after 512.
inline constexpr std::size_t hdf5_user_block = 512;

/// A file, with zeros in the user block, in which a group is a group, an array a dataset of (rows)
/// or (rows, columns) with a Fletcher32 checksum on its chunks, and a text a string. Attributes are
/// `rows` of what is a sequence, and `type` of a group where the name of its class is known; of the
/// top group `schema`, `riprap` and `hdf5`, which wrote it. The same fields give the same bytes. In
/// memory, so that HDF5 never meets a full disk. Throws SimulationError if HDF5 fails.
[[nodiscard]] inline std::vector<std::byte> to_hdf5_image(const FieldNode& top) {
  using namespace internal;
  const Hdf5Quiet quiet;
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  constexpr std::size_t increment = std::size_t{1} << 20;
  hdf5_require(H5Pset_fapl_core(access, increment, false) >= 0, "write in memory");
  const Hdf5Id creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose, "make a property list");
  H5Pset_link_creation_order(creation, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_obj_track_times(creation, false);
  const Hdf5Id file(H5Fcreate("checkpoint", H5F_ACC_TRUNC, creation, access), H5Fclose,
                    "make a file in memory");
  {
    const Hdf5Id root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "open the top group");
    Hdf5Writer::write_versions(root);
    Hdf5Writer::write_attributes(root, top);
    Hdf5Writer::write_children(root, top);
  }
  hdf5_require(H5Fflush(file, H5F_SCOPE_LOCAL) >= 0, "complete a file in memory");
  const ssize_t size = H5Fget_file_image(file, nullptr, 0);
  hdf5_require(size > 0, "read a file in memory");
  std::vector<std::byte> image(hdf5_user_block + static_cast<std::size_t>(size));
  hdf5_require(H5Fget_file_image(file, image.data() + hdf5_user_block,
                                 static_cast<std::size_t>(size)) == size,
               "read a file in memory");
  return image;
}

/// The fields of such a file; its top group gets the path `name`. Throws SimulationError if HDF5
/// cannot read it.
[[nodiscard]] inline FieldNode from_hdf5_image(std::span<const std::byte> image,
                                               const std::string& name) {
  using namespace internal;
  const Hdf5Quiet quiet;
  const Hdf5Id access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "make a property list");
  hdf5_require(H5Pset_fapl_core(access, std::size_t{1} << 20, false) >= 0, "read from memory");
  std::vector<std::byte> own(image.begin() + hdf5_user_block, image.end());  // HDF5 takes no const
  hdf5_require(H5Pset_file_image(access, own.data(), own.size()) >= 0, "read from memory");
  const Hdf5Id file(H5Fopen("checkpoint", H5F_ACC_RDONLY, access), H5Fclose,
                    "open a file in memory");
  const Hdf5Id root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose, "open the top group");
  FieldNode top;
  top.path = name;
  Hdf5Reader::read_group(root, top);
  return top;
}

}  // namespace riprap
