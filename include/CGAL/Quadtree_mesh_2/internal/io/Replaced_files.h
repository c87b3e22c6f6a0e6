// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_REPLACED_FILES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_REPLACED_FILES_H

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Files that appear under their names only when all of them are written.
///
/// `add()` writes beside the file that it will replace, and `commit()` renames. If any of that fails, or an
/// exception passes, the written files are removed and older files stay as they were. If a file is not
/// regular (a pipe, `/dev/stdout`), `commit()` writes it before it renames.
class Replaced_files {
public:
  Replaced_files() = default;
  Replaced_files(const Replaced_files&) = delete;
  Replaced_files& operator=(const Replaced_files&) = delete;
  ~Replaced_files() {
    if (is_in_place_) take_back(written_.size());
    for (const Written& w : written_) remove(w.temporary);
  }

  /// What is added under this name goes to an open file from now on, which stays open.
  /// \param called what errors call that file
  void direct(const std::string& name, std::FILE* file, const std::string& called) {
    directed_.push_back({name, called, file});
  }

  /// \throws std::system_error that tells the file and why it cannot be written.
  void add(const std::string& file_name, std::string text) {
    if (const Directed* const to = directed(file_name))
      streams_.push_back({to->called, std::move(text), to->file});
    else if (is_stream(file_name))
      streams_.push_back({file_name, std::move(text), nullptr});
    else
      write(open_for(file_name), file_name, text);
  }

  /// The same for a file that a library writes. \returns the name of an empty file
  std::string add_empty(const std::string& file_name) {
    if (is_stream(file_name)) fail(file_name, std::make_error_code(std::errc::invalid_seek));
    write(open_for(file_name), file_name, std::string());
    return written_.back().temporary.string();
  }
  /// \param write_to called with the name of an empty file; what it throws is passed on
  template <class Write_to>
  void add_by(const std::string& file_name, const Write_to& write_to) {
    write_to(add_empty(file_name));
  }

  /// \throws std::system_error as `add()` does; then no file is replaced, if the file system knows hard links.
  void commit() {
    put_in_place();
    keep();
  }

  /// The first half of `commit()`. Without the second one, older files come back at the end.
  void put_in_place() {
    for (const Stream& s : streams_)
      if (s.file != nullptr)
        write_on(s.file, s.name, s.text);
      else
        write(std::fopen(s.name.c_str(), "wb"), s.name, s.text);
    streams_.clear();
    for (Written& w : written_) keep_target(w);
    for (std::size_t i = 0; i < written_.size(); ++i) {
      std::error_code error;
      std::filesystem::rename(written_[i].temporary, written_[i].target, error);
      if (!error) continue;
      take_back(i);
      fail(written_[i].target.string(), error);
    }
    is_in_place_ = true;
  }
  void keep() {
    for (const Written& w : written_) remove(w.kept);
    written_.clear();
    is_in_place_ = false;
  }

private:
  struct Written {
    std::filesystem::path temporary, target;
    std::filesystem::path kept = {}; ///< a second name of what is replaced; empty if there is none
    bool is_new = true;              ///< nothing is replaced
  };
  struct Stream {
    std::string name, text;
    std::FILE* file; ///< null: to be opened by its name
  };
  struct Directed {
    std::string name, called;
    std::FILE* file;
  };

  [[noreturn]] static void fail(const std::string& file_name, std::error_code error) {
    throw std::system_error(error, file_name + ": cannot be written");
  }

  const Directed* directed(const std::string& name) const {
    for (const Directed& d : directed_)
      if (d.name == name) return &d;
    return nullptr;
  }

  static bool is_stream(const std::string& file_name) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::file_status status = fs::status(file_name, ignored);
    if (fs::is_directory(status)) fail(file_name, std::make_error_code(std::errc::is_a_directory));
    // A redirected /dev/stdout looks like the file it leads to, which others write, too.
    const bool is_device = file_name.compare(0, 5, "/dev/") == 0;
    return is_device || (fs::exists(status) && !fs::is_regular_file(status));
  }

  static void remove(const std::filesystem::path& file) {
    std::error_code ignored;
    if (!file.empty()) std::filesystem::remove(file, ignored);
  }

  /// A temporary file for a target that is no stream.
  std::FILE* open_for(const std::string& file_name) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(file_name, error);
    // Through a symbolic link it is its target that changes, not the link.
    fs::path target =
        fs::is_symlink(fs::symlink_status(file_name, error)) ? fs::canonical(file_name, error) : fs::path();
    if (target.empty()) target = file_name;
    std::FILE* file = open_beside(target, file_name);
    if (fs::exists(status)) fs::permissions(written_.back().temporary, status.permissions(), error);
    return file;
  }

  std::FILE* open_beside(const std::filesystem::path& target, const std::string& file_name) {
    constexpr int tries = 1000; // leftovers of so many runs that were killed
    for (int i = 0; i < tries; ++i) {
      std::filesystem::path temporary = target;
      temporary += ".part" + std::to_string(i);
      if (std::FILE* file = std::fopen(temporary.string().c_str(), "wbx")) {
        written_.push_back({std::move(temporary), target});
        return file;
      }
      if (errno != EEXIST) break;
    }
    fail(file_name, std::error_code(errno, std::generic_category()));
  }

  /// A second name for what is at the target, where the file system has such.
  static void keep_target(Written& w) {
    std::filesystem::path kept = w.temporary;
    kept += ".old";
    std::error_code error;
    w.is_new = !std::filesystem::exists(w.target, error);
    std::filesystem::create_hard_link(w.target, kept, error);
    if (!error) w.kept = std::move(kept);
  }
  /// After the first `n` files were renamed.
  void take_back(std::size_t n) {
    std::error_code ignored;
    for (std::size_t i = 0; i < written_.size(); ++i)
      if (i >= n)
        remove(written_[i].kept);
      else if (written_[i].is_new)
        remove(written_[i].target);
      else if (!written_[i].kept.empty())
        std::filesystem::rename(written_[i].kept, written_[i].target, ignored);
  }

  static void write(std::FILE* file, const std::string& file_name, const std::string& text) {
    if (!file) fail(file_name, std::error_code(errno, std::generic_category()));
    errno = 0;
    const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    int error = errno;
    const bool is_closed = std::fclose(file) == 0; // a full disk may be noticed only now
    if (is_written && is_closed) return;
    if (is_written) error = errno;
    fail(file_name, std::error_code(error ? error : EIO, std::generic_category()));
  }

  /// Leaves the file open.
  static void write_on(std::FILE* file, const std::string& name, const std::string& text) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0) return;
    fail(name, std::error_code(errno ? errno : EIO, std::generic_category()));
  }

  std::vector<Written> written_;
  bool is_in_place_ = false; // what is written, but older files are kept
  std::vector<Stream> streams_;
  std::vector<Directed> directed_;
};

/// Writes `text` to a file that keeps its old content if that fails.
/// \throws std::system_error
inline void replace_file(const std::string& file_name, std::string text) {
  Replaced_files files;
  files.add(file_name, std::move(text));
  files.commit();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_REPLACED_FILES_H
