// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A file with the state of long work, from which the work can go on.
//
// The same function names what there is to write and what there is to read: `archive(a, b, ...)`. It takes what can be
// copied as bytes, vectors, and what has a function `transfer(archive)` that does the same with its members. A file is
// complete or not there: it is written beside the one before, whose place it takes at the end. Files are read on
// machines like the one that wrote them, by the same version.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_BASE_CHECKPOINT_FILE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_BASE_CHECKPOINT_FILE_H

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>

#if defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#endif

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A number that two sequences of bytes share only by chance, or if they are the same. A gigabyte takes a second or
/// less.
class Digest {
public:
  void add(const void* bytes, std::size_t size) {
    const auto* next = static_cast<const unsigned char*>(bytes);
    for (; size >= sizeof(std::uint64_t); size -= sizeof(std::uint64_t), next += sizeof(std::uint64_t)) {
      std::uint64_t word;
      std::memcpy(&word, next, sizeof word);
      mix(word);
    }
    std::uint64_t rest = 0;
    if (size > 0) std::memcpy(&rest, next, size);
    mix(rest + size);
  }
  template <class T>
  void add(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>, "its bytes are its value");
    add(&value, sizeof value);
  }
  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0x243f6a8885a308d3u;

  void mix(std::uint64_t word) {
    value_ = (value_ ^ word) * 0x9e3779b97f4a7c15u;
    value_ ^= value_ >> 32;
  }
};

/// What writing and reading have in common: the bytes of everything, one after the other.
template <class Derived>
class Checkpoint_archive {
public:
  template <class... T>
  void operator()(T&... values) {
    (transfer(values), ...);
  }

private:
  template <class T, class = void>
  struct Has_transfer : std::false_type {};
  template <class T>
  struct Has_transfer<T, std::void_t<decltype(std::declval<T&>().transfer(std::declval<Derived&>()))>>
      : std::true_type {};

  Derived& derived() { return static_cast<Derived&>(*this); }

  template <class T>
  void transfer(T& value) {
    if constexpr (Has_transfer<T>::value)
      value.transfer(derived());
    else if constexpr (std::is_trivially_copyable_v<T>)
      derived().transfer_bytes(&value, sizeof value);
    else
      transfer_values(value);
  }

  template <class Vector>
  void transfer_values(Vector& values) {
    using Value = typename Vector::value_type;
    std::uint64_t size = values.size();
    transfer(size);
    derived().make_room(values, static_cast<std::size_t>(size));
    if constexpr (std::is_trivially_copyable_v<Value>)
      derived().transfer_bytes(values.data(), values.size() * sizeof(Value));
    else
      for (Value& value : values) transfer(value);
  }
};

/// An open file that is closed in the end.
using Open_file = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

class Checkpoint_writer : public Checkpoint_archive<Checkpoint_writer> {
public:
  static constexpr bool is_reading = false;

  /// \throws std::system_error naming the file, as all functions do
  explicit Checkpoint_writer(std::string file_name)
      : name_(std::move(file_name)), part_(name_ + ".part"),
        file_(std::fopen(part_.c_str(), "wb"), &std::fclose) {
    if (!file_) fail();
  }
  Checkpoint_writer(const Checkpoint_writer&) = delete;
  Checkpoint_writer& operator=(const Checkpoint_writer&) = delete;
  ~Checkpoint_writer() {
    if (file_) std::remove(part_.c_str());
  }

  /// Puts the file in place, when its bytes are on the disk.
  void commit() {
    const std::uint64_t digest = digest_.value();
    write(&digest, sizeof digest);
    if (std::fflush(file_.get()) != 0) fail();
#if defined(__unix__) || defined(__APPLE__)
    if (fsync(fileno(file_.get())) != 0) fail();
#endif
    if (std::fclose(file_.release()) != 0 || std::rename(part_.c_str(), name_.c_str()) != 0) {
      const int error = errno;
      std::remove(part_.c_str());
      errno = error;
      fail();
    }
  }

  // For the archive.
  void transfer_bytes(const void* bytes, std::size_t size) {
    digest_.add(bytes, size);
    write(bytes, size);
  }
  template <class Vector>
  static void make_room(const Vector&, std::size_t) {}

private:
  std::string name_, part_;
  Open_file file_;
  Digest digest_;

  void write(const void* bytes, std::size_t size) {
    if (size > 0 && std::fwrite(bytes, 1, size, file_.get()) != size) fail();
  }

  [[noreturn]] void fail() const {
    throw std::system_error(errno, std::generic_category(), name_ + ": cannot be written");
  }
};

class Checkpoint_reader : public Checkpoint_archive<Checkpoint_reader> {
public:
  static constexpr bool is_reading = true;

  /// \throws std::runtime_error naming the file if it cannot be read or is damaged, as all functions do
  explicit Checkpoint_reader(std::string file_name)
      : name_(std::move(file_name)), file_(std::fopen(name_.c_str(), "rb"), &std::fclose) {
    std::error_code error;
    left_ = std::filesystem::file_size(name_, error);
    if (!file_ || error) throw std::runtime_error(name_ + ": cannot be read");
  }

  /// To be called at last. What has been read is of no use if it throws.
  void check() {
    const std::uint64_t read = digest_.value();
    std::uint64_t written = 0;
    transfer_bytes(&written, sizeof written);
    if (read != written || left_ > 0) fail();
  }

  // For the archive.
  void transfer_bytes(void* bytes, std::size_t size) {
    if (size > left_ || (size > 0 && std::fread(bytes, 1, size, file_.get()) != size)) fail();
    left_ -= size;
    digest_.add(bytes, size);
  }
  template <class Vector>
  void make_room(Vector& values, std::size_t size) {
    using Value = typename Vector::value_type;
    if (size > left_ / (std::is_trivially_copyable_v<Value> ? sizeof(Value) : 1)) fail();
    values.resize(size);
  }

private:
  std::string name_;
  Open_file file_;
  Digest digest_;
  std::uintmax_t left_ = 0; // bytes

  [[noreturn]] void fail() const {
    throw std::runtime_error(name_ + ": damaged, so work cannot go on from it");
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_BASE_CHECKPOINT_FILE_H
