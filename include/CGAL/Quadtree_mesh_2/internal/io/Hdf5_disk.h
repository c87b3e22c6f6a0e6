// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_DISK_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_DISK_H

#include <hdf5.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// By which HDF5 writes new files: a driver that tells it of no error but remembers the first one.
///
/// HDF5 keeps what it cannot write until it closes a file. If that fails, too, because the disk is full, it crashes at
/// the end of the program. With this driver files can always be closed, and whoever writes asks for the error then. The
/// bytes are those of HDF5's own driver (https://docs.hdfgroup.org/hdf5/v1_10/, "Virtual File Layer").
class Hdf5_disk {
public:
  Hdf5_disk() : driver_(register_driver()), access_(H5Pcreate(H5P_FILE_ACCESS)) {
    const Info info{&error_};
    if (driver_ < 0 || access_ < 0 || H5Pset_driver(access_, driver_, &info) < 0)
      throw std::runtime_error("HDF5 takes no driver");
  }
  Hdf5_disk(const Hdf5_disk&) = delete;
  Hdf5_disk& operator=(const Hdf5_disk&) = delete;
  ~Hdf5_disk() {
    H5Pclose(access_);
    H5FDunregister(driver_);
  }

  /// To open files with.
  hid_t access() const { return access_; }
  /// The system's number of the first error; 0 if there is none.
  int error() const { return error_; }

private:
  struct Info {
    int* error;
  };
  /// What HDF5 knows as a file.
  struct File {
    H5FD_t known; ///< first, as HDF5 wants it
    std::string name;
    std::filebuf disk;
    haddr_t end_of_room, end;
    int* error;

    void remember(int other) const {
      if (*error == 0) *error = other != 0 ? other : EIO;
    }
    bool go_to(haddr_t at) {
      errno = 0;
      return disk.pubseekpos(std::streampos(static_cast<std::streamoff>(at))) != std::streampos(-1);
    }
  };
  static File& file_of(H5FD_t* file) { return *reinterpret_cast<File*>(file); }
  static const File& file_of(const H5FD_t* file) { return *reinterpret_cast<const File*>(file); }

  static hid_t register_driver() {
    H5FD_class_t driver{};
#if H5_VERSION_GE(1, 13, 0)
    driver.version = H5FD_CLASS_VERSION, driver.value = 511;
#endif
    driver.name = "quadtree_mesh_disk";
    driver.maxaddr = (haddr_t(1) << 62) - 1;
    driver.fc_degree = H5F_CLOSE_WEAK;
    driver.fapl_size = sizeof(Info);
    driver.open = &open, driver.close = &close, driver.query = &query;
    driver.get_eoa = [](const H5FD_t* file, H5FD_mem_t) { return file_of(file).end_of_room; };
    driver.set_eoa = [](H5FD_t* file, H5FD_mem_t, haddr_t end) -> herr_t {
      file_of(file).end_of_room = end;
      return 0;
    };
    driver.get_eof = [](const H5FD_t* file, H5FD_mem_t) { return file_of(file).end; };
    driver.read = &read, driver.write = &write, driver.truncate = &truncate;
    constexpr H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(map), std::end(map), driver.fl_map);
    return H5FDregister(&driver);
  }

  /// This one error HDF5 is told, as it does not matter to it.
  static H5FD_t* open(const char* name, unsigned, hid_t access, haddr_t) {
    const Info* const info = static_cast<const Info*>(H5Pget_driver_info(access));
    auto file = std::make_unique<File>();
    std::memset(&file->known, 0, sizeof file->known);
    file->name = name, file->error = info->error;
    file->end_of_room = file->end = 0;
    errno = 0;
    if (file->disk.open(name, std::ios::in | std::ios::out | std::ios::trunc | std::ios::binary) == nullptr) {
      file->remember(errno);
      return nullptr;
    }
    return &file.release()->known;
  }
  static herr_t close(H5FD_t* known) {
    const std::unique_ptr<File> file(&file_of(known));
    errno = 0;
    if (file->disk.close() == nullptr) file->remember(errno);
    return 0;
  }
  /// As HDF5's own driver, so that it makes the same files.
  static herr_t query(const H5FD_t*, unsigned long* flags) {
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE |
             H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
    return 0;
  }
  /// What is not there is 0.
  static herr_t read(H5FD_t* known, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* bytes) {
    File& file = file_of(known);
    std::memset(bytes, 0, size);
    if (!file.go_to(at)) return 0;
    file.disk.sgetn(static_cast<char*>(bytes), static_cast<std::streamsize>(size));
    return 0;
  }
  static herr_t write(H5FD_t* known, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, const void* bytes) {
    File& file = file_of(known);
    const auto n = static_cast<std::streamsize>(size);
    if (*file.error != 0) return 0; // all is lost
    if (!file.go_to(at) || file.disk.sputn(static_cast<const char*>(bytes), n) != n) file.remember(errno);
    file.end = std::max(file.end, at + size);
    return 0;
  }
  static herr_t truncate(H5FD_t* known, hid_t, hbool_t) {
    File& file = file_of(known);
    if (file.end == file.end_of_room || *file.error != 0) return 0;
    std::error_code error;
    errno = 0;
    if (file.disk.pubsync() != 0) file.remember(errno);
    std::filesystem::resize_file(file.name, file.end_of_room, error);
    if (error) file.remember(error.value());
    file.end = file.end_of_room;
    return 0;
  }

  int error_ = 0;
  hid_t driver_, access_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_DISK_H
