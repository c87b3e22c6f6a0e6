// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_FILE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_FILE_H

#include <CGAL/Quadtree_mesh_2/internal/io/Hdf5_disk.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Mesh_numbers.h>

#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

// Files of HDF5 by its C interface, https://docs.hdfgroup.org/hdf5/v1_10/: arrays of numbers, written and read in slabs
// of some rows, so that no array has to be in memory as the file has it.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Something of HDF5's, closed at the end.
class Hdf5_handle {
public:
  using Close = herr_t (*)(hid_t);
  Hdf5_handle() = default;
  Hdf5_handle(hid_t id, Close close_by) : id_(id), close_(close_by) {}
  Hdf5_handle(Hdf5_handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5_handle& operator=(Hdf5_handle&& other) noexcept {
    std::swap(id_, other.id_), std::swap(close_, other.close_);
    return *this;
  }
  ~Hdf5_handle() {
    if (id_ >= 0) close_(id_);
  }

  hid_t get() const { return id_; }
  bool is_open() const { return id_ >= 0; }
  /// \returns whether that went well
  bool close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// While it lives, HDF5 prints nothing about errors: exceptions tell them.
class Quiet_hdf5 {
public:
  Quiet_hdf5() {
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  Quiet_hdf5(const Quiet_hdf5&) = delete;
  Quiet_hdf5& operator=(const Quiet_hdf5&) = delete;
  ~Quiet_hdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

/// Why the last call failed: the number of the system's error, 0 if it was none, and HDF5's own words.
struct Hdf5_reason {
  int system_error = 0;
  std::string words;

  static Hdf5_reason of_last_call() {
    Hdf5_reason reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, &add, &reason);
    return reason;
  }

private:
  /// The first description is that of what went wrong, the others that of who called it.
  static herr_t add(unsigned, const H5E_error2_t* error, void* data) {
    Hdf5_reason& reason = *static_cast<Hdf5_reason*>(data);
    const std::string words = error->desc ? error->desc : "";
    if (reason.words.empty()) reason.words = words;
    const std::size_t at = words.find("errno = ");
    if (at != std::string::npos && reason.system_error == 0)
      reason.system_error = std::atoi(words.c_str() + at + 8);
    return 0;
  }
};

template <class Number>
hid_t hdf5_type() {
  if constexpr (std::is_same_v<Number, double>)
    return H5T_NATIVE_DOUBLE;
  else if constexpr (std::is_same_v<Number, std::int64_t>)
    return H5T_NATIVE_INT64;
  else if constexpr (std::is_same_v<Number, std::int32_t>)
    return H5T_NATIVE_INT32;
  else {
    static_assert(std::is_same_v<Number, std::uint8_t>, "add the type");
    return H5T_NATIVE_UINT8;
  }
}

/// So many rows are in memory at a time.
constexpr std::size_t rows_of_slab = std::size_t(1) << 16;

class Hdf5_writer {
public:
  /// Whether values are written, or only their room is made, so that others can write them: see `Hdf5_rows_writer`. The
  /// bytes of the file are the same in the end.
  enum class Values { WRITTEN, BY_OTHERS };

  /// Truncates the file.
  /// \param shown the name that errors tell; they are std::system_error, here and below
  Hdf5_writer(const std::string& file_name, std::string shown, Values values = Values::WRITTEN)
      : shown_(std::move(shown)), values_(values) {
    file_ = checked(H5Fcreate(file_name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, disk_.access()), H5Fclose);
  }

  void add_group(const std::string& path) {
    checked(H5Gcreate2(file_.get(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  }

  /// See below.
  /// \pre values are by others, or all rows are here, in one run
  template <class Value_at>
  void add_array(const std::string& path, const Array_rows& rows, std::size_t columns,
                 const Value_at& value_at) {
    const std::size_t first = rows.runs.empty() ? 0 : rows.runs.front().index;
    add_array(path, rows.all, columns,
              [&](std::size_t row, std::size_t column) { return value_at(first + row, column); });
  }
  /// An array with `n` rows.
  /// \param columns 0 for an array of one dimension
  /// \param value_at called as `value_at(row, column)`, in the order of the array
  template <class Value_at>
  void add_array(const std::string& path, std::size_t n, std::size_t columns, const Value_at& value_at) {
    using Number = std::decay_t<decltype(value_at(n, n))>;
    const int rank = columns == 0 ? 1 : 2;
    const std::size_t width = std::max<std::size_t>(columns, 1);
    const hsize_t sizes[] = {n, columns};
    const Hdf5_handle space = checked(H5Screate_simple(rank, sizes, nullptr), H5Sclose);
    const Hdf5_handle array = checked(H5Dcreate2(file_.get(), path.c_str(), hdf5_type<Number>(), space.get(),
                                                 H5P_DEFAULT, properties().get(), H5P_DEFAULT),
                                      H5Dclose);
    if (values_ == Values::BY_OTHERS) {
      places_.push_back(H5Dget_offset(array.get())); // of nothing, if the array is empty
      return;
    }
    std::vector<Number> slab;
    for (std::size_t begin = 0; begin < n; begin += rows_of_slab) {
      const std::size_t end = std::min(n, begin + rows_of_slab);
      slab.clear();
      for (std::size_t row = begin; row < end; ++row)
        for (std::size_t column = 0; column < width; ++column) slab.push_back(value_at(row, column));
      const hsize_t offsets[] = {begin, 0}, lengths[] = {end - begin, columns};
      const Hdf5_handle in_memory = checked(H5Screate_simple(rank, lengths, nullptr), H5Sclose);
      check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, offsets, nullptr, lengths, nullptr));
      check(
          H5Dwrite(array.get(), hdf5_type<Number>(), in_memory.get(), space.get(), H5P_DEFAULT, slab.data()));
    }
  }

  void add_attribute(const std::string& path, const char* name, const std::vector<std::int64_t>& values) {
    const hsize_t size = values.size();
    const Hdf5_handle space = checked(H5Screate_simple(1, &size, nullptr), H5Sclose);
    add_attribute(path, name, H5T_NATIVE_INT64, space, values.data());
  }
  /// Text of a fixed length, as VTK wants it.
  void add_attribute(const std::string& path, const char* name, const std::string& text) {
    const Hdf5_handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_size(type.get(), text.size()));
    check(H5Tset_strpad(type.get(), H5T_STR_NULLPAD));
    add_attribute(path, name, type.get(), checked(H5Screate(H5S_SCALAR), H5Sclose), text.data());
  }

  /// Where in the file the values of each array are to be, in the order of arrays.
  const std::vector<std::uint64_t>& places() const { return places_; }

  /// What is not closed may be incomplete.
  void close() { check(file_.close() ? 0 : -1); }

private:
  void add_attribute(const std::string& path, const char* name, hid_t type, const Hdf5_handle& space,
                     const void* values) {
    const Hdf5_handle object = checked(H5Oopen(file_.get(), path.c_str(), H5P_DEFAULT), H5Oclose);
    const Hdf5_handle attribute =
        checked(H5Acreate2(object.get(), name, type, space.get(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(attribute.get(), type, values));
  }

  /// The same mesh is the same bytes, whenever it is written. Arrays have their room from the beginning.
  Hdf5_handle properties() const {
    Hdf5_handle properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    check(H5Pset_obj_track_times(properties.get(), false));
    check(H5Pset_alloc_time(properties.get(), H5D_ALLOC_TIME_EARLY));
    check(H5Pset_fill_time(properties.get(), H5D_FILL_TIME_NEVER));
    return properties;
  }

  [[noreturn]] void fail() const {
    const Hdf5_reason reason = Hdf5_reason::of_last_call();
    int error = disk_.error();
    if (error == 0) error = reason.system_error != 0 ? reason.system_error : EIO;
    throw std::system_error(error, std::generic_category(), shown_ + ": cannot be written");
  }
  void check(herr_t status) const {
    if (status < 0 || disk_.error() != 0) fail();
  }
  Hdf5_handle checked(hid_t id, Hdf5_handle::Close close_by) const {
    if (id < 0) fail();
    return Hdf5_handle(id, close_by);
  }

  Quiet_hdf5 quiet_; // outlives the file
  std::string shown_;
  Values values_;
  std::vector<std::uint64_t> places_;
  Hdf5_disk disk_;
  Hdf5_handle file_;
};

/// What is wrong with a file that is read, without its name.
class Hdf5_read_error : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

class Hdf5_reader {
public:
  /// \throws Hdf5_read_error if it is no file of HDF5, here and below for what else is wrong
  explicit Hdf5_reader(const std::string& file_name)
      : file_(H5Fopen(file_name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose) {
    if (!file_.is_open()) {
      const Hdf5_reason reason = Hdf5_reason::of_last_call();
      throw Hdf5_read_error(reason.system_error != 0
                                ? std::generic_category().message(reason.system_error)
                                : "is no file of HDF5, or a damaged one: " + reason.words);
    }
  }

  bool has(const std::string& path) const {
    for (std::size_t end = path.find('/', 1);;
         end = path.find('/', end + 1)) { // each part of the path has to be there
      if (H5Lexists(file_.get(), path.substr(0, end).c_str(), H5P_DEFAULT) <= 0) return false;
      if (end == std::string::npos) return true;
    }
  }

  /// An array of numbers.
  class Array {
  public:
    std::size_t rows() const { return rows_; }
    /// 0 if the array has one dimension.
    std::size_t columns() const { return columns_; }
    bool has_whole_numbers() const { return has_whole_numbers_; }

    /// Calls `f(row, values)` for each row from `first` to `last`, with a pointer to its numbers.
    template <class Number, class F>
    void for_each_row(std::size_t first, std::size_t last, const F& f) const {
      const std::size_t width = std::max<std::size_t>(columns_, 1);
      std::vector<Number> slab(std::min(last - first, rows_of_slab) * width);
      const Hdf5_handle space(H5Dget_space(array_.get()), H5Sclose);
      for (std::size_t begin = first; begin < last; begin += rows_of_slab) {
        const std::size_t end = std::min(last, begin + rows_of_slab);
        const hsize_t offsets[] = {begin, 0}, lengths[] = {end - begin, columns_};
        const Hdf5_handle in_memory(H5Screate_simple(columns_ == 0 ? 1 : 2, lengths, nullptr), H5Sclose);
        H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, offsets, nullptr, lengths, nullptr);
        if (H5Dread(array_.get(), hdf5_type<Number>(), in_memory.get(), space.get(), H5P_DEFAULT,
                    slab.data()) < 0)
          throw Hdf5_read_error(path_ + " cannot be read: " + Hdf5_reason::of_last_call().words);
        for (std::size_t row = begin; row < end; ++row) f(row, slab.data() + (row - begin) * width);
      }
    }

  private:
    friend Hdf5_reader;
    std::string path_;
    Hdf5_handle array_;
    std::size_t rows_ = 0, columns_ = 0;
    bool has_whole_numbers_ = false;
  };

  Array array(const std::string& path) const {
    Array result;
    result.path_ = path;
    if (!has(path)) throw Hdf5_read_error("there is no " + path);
    result.array_ = Hdf5_handle(H5Dopen2(file_.get(), path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!result.array_.is_open()) throw Hdf5_read_error(path + " is no array");
    const Hdf5_handle type(H5Dget_type(result.array_.get()), H5Tclose);
    const H5T_class_t kind = H5Tget_class(type.get());
    if (kind != H5T_FLOAT && kind != H5T_INTEGER) throw Hdf5_read_error(path + " has no numbers");
    result.has_whole_numbers_ = kind == H5T_INTEGER;
    const Hdf5_handle space(H5Dget_space(result.array_.get()), H5Sclose);
    const int rank = H5Sget_simple_extent_ndims(space.get());
    if (rank != 1 && rank != 2)
      throw Hdf5_read_error(path + " has " + std::to_string(std::max(rank, 0)) + " dimensions, not 1 or 2");
    hsize_t sizes[2] = {0, 0};
    H5Sget_simple_extent_dims(space.get(), sizes, nullptr);
    result.rows_ = static_cast<std::size_t>(sizes[0]), result.columns_ = static_cast<std::size_t>(sizes[1]);
    if (rank == 2 && sizes[1] == 0) throw Hdf5_read_error(path + " has no columns");
    check_size(result, type);
    return result;
  }

private:
  /// Nobody shall look for memory for what a damaged file claims to have.
  void check_size(const Array& array, const Hdf5_handle& type) const {
    const Hdf5_handle properties(H5Dget_create_plist(array.array_.get()), H5Pclose);
    if (H5Pget_layout(properties.get()) == H5D_CHUNKED) return; // which may be compressed
    hsize_t size = 0;
    H5Fget_filesize(file_.get(), &size);
    const double numbers =
        static_cast<double>(array.rows_) * static_cast<double>(std::max<std::size_t>(array.columns_, 1));
    if (numbers * static_cast<double>(H5Tget_size(type.get())) > static_cast<double>(size))
      throw Hdf5_read_error(array.path_ + " would be longer than the file");
  }

  Quiet_hdf5 quiet_;
  Hdf5_handle file_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_HDF5_FILE_H
