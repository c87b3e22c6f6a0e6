// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_GIS_GDAL_DATASET_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_GIS_GDAL_DATASET_H

// Files of geographic data by the C interface of GDAL, which stays the same from one version to the next.

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>

#include <cpl_error.h>
#include <gdal.h>

#include <string>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// While it lives, GDAL prints no errors in this thread.
class Quiet_gdal {
public:
  Quiet_gdal() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  Quiet_gdal(const Quiet_gdal&) = delete;
  Quiet_gdal& operator=(const Quiet_gdal&) = delete;
  ~Quiet_gdal() { CPLPopErrorHandler(); }

  /// What went wrong since the last reset, in GDAL's words; empty for nothing but warnings.
  static std::string error() {
    return CPLGetLastErrorType() >= CE_Failure ? printable(CPLGetLastErrorMsg(), 200) : std::string();
  }
};

/// An open file, read only.
class Gdal_dataset {
public:
  /// \param kind GDAL_OF_VECTOR or GDAL_OF_RASTER
  /// \throws Pslg_error_2 naming the file
  Gdal_dataset(const std::string& file_name, unsigned kind) : file_name_(file_name) {
    GDALAllRegister();
    handle_ = GDALOpenEx(file_name.c_str(), kind | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, nullptr, nullptr,
                         nullptr);
    if (handle_ != nullptr) return;
    const std::string error = Quiet_gdal::error();
    fail(error.empty() ? "cannot be opened" : "cannot be opened: " + error);
  }
  Gdal_dataset(const Gdal_dataset&) = delete;
  Gdal_dataset& operator=(const Gdal_dataset&) = delete;
  ~Gdal_dataset() {
    if (handle_ != nullptr) GDALClose(handle_);
  }

  GDALDatasetH handle() const { return handle_; }

  /// What messages call a part of the file.
  std::string name_of(const std::string& part) const { return file_name_ + ": " + part; }
  [[noreturn]] void fail(const std::string& what) const {
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, name_of(what));
  }
  /// \throws Pslg_error_2 if GDAL has found something wrong, as in a file that was cut off
  void check() const {
    const std::string error = Quiet_gdal::error();
    if (!error.empty()) fail(error);
  }

private:
  std::string file_name_;
  Quiet_gdal quiet_;
  GDALDatasetH handle_ = nullptr;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_GIS_GDAL_DATASET_H
