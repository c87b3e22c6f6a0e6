// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_ROWS_WRITER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_ROWS_WRITER_H

#include <CGAL/Quadtree_mesh_2/internal/io/Mesh_numbers.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Writes rows of arrays into a file of HDF5 in which another process has made room for them.
///
/// Arrays lie in such a file as in memory, so this needs no HDF5, and no other process. In parallel HDF5 processes wait
/// for each other while they write and close, and if one of them fails there, the others wait for ever. Has the
/// functions of `Hdf5_writer`, to be called in the same order; what the other process has written is left out.
class Hdf5_rows_writer {
public:
  /// \param shown the name that errors tell; they are std::system_error, here and below
  /// \param places those of the writer that has made room
  Hdf5_rows_writer(const std::string& file_name, std::string shown, std::vector<std::uint64_t> places)
      : shown_(std::move(shown)), places_(std::move(places)) {
    errno = 0;
    if (file_.open(file_name, std::ios::in | std::ios::out | std::ios::binary) == nullptr) fail();
  }

  void add_group(const std::string&) {}
  template <class Values>
  void add_attribute(const std::string&, const char*, const Values&) {}

  /// \param value_at called as `value_at(index, column)`, in the order of `rows`
  template <class Value_at>
  void add_array(const std::string&, const Array_rows& rows, std::size_t columns, const Value_at& value_at) {
    using Number = std::decay_t<decltype(value_at(columns, columns))>;
    const std::size_t width = std::max<std::size_t>(columns, 1);
    const std::uint64_t place = places_[next_++];
    std::vector<Number> values;
    for (const Array_rows::Run& run : rows.runs) {
      seek(place + run.row * width * sizeof(Number));
      for (std::size_t begin = 0; begin < run.length; begin += rows_in_memory_) {
        values.clear();
        for (std::size_t i = begin; i < std::min(run.length, begin + rows_in_memory_); ++i)
          for (std::size_t column = 0; column < width; ++column)
            values.push_back(value_at(run.index + i, column));
        write(values.data(), values.size() * sizeof(Number));
      }
    }
  }

  /// What is not closed may be incomplete.
  void close() {
    errno = 0;
    if (file_.close() == nullptr) fail();
  }

private:
  static constexpr std::size_t rows_in_memory_ = std::size_t(1) << 16;

  [[noreturn]] void fail() const {
    throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(),
                            shown_ + ": cannot be written");
  }
  /// Also writes what is in the buffer.
  void seek(std::uint64_t place) {
    errno = 0;
    const auto at = static_cast<std::streamoff>(place);
    if (file_.pubseekoff(at, std::ios::beg, std::ios::out) != std::streampos(at)) fail();
  }
  void write(const void* bytes, std::size_t n) {
    errno = 0;
    const auto size = static_cast<std::streamsize>(n);
    if (file_.sputn(static_cast<const char*>(bytes), size) != size) fail();
  }

  std::string shown_;
  std::vector<std::uint64_t> places_;
  std::size_t next_ = 0; // array
  std::filebuf file_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_ROWS_WRITER_H
