// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_REPLACED_FILES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_REPLACED_FILES_H

#include <cerrno>
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
/// `add()` writes beside the file it is about to replace, `commit()` renames. If any write fails, or an
/// exception passes, what was written is removed and files that were there stay as they were. A name that is
/// not that of a regular file (a pipe, `/dev/stdout`) is written directly.
class Replaced_files {
public:
  Replaced_files() = default;
  Replaced_files(const Replaced_files&) = delete;
  Replaced_files& operator=(const Replaced_files&) = delete;
  ~Replaced_files() {
    std::error_code ignored;
    for (const Written& w : written_) std::filesystem::remove(w.temporary, ignored);
  }

  /// \throws std::system_error that tells the file and why it cannot be written.
  void add(const std::string& file_name, const std::string& text) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(file_name, error);
    if (fs::is_directory(status)) fail(file_name, std::make_error_code(std::errc::is_a_directory));
    // A redirected /dev/stdout looks like the file it leads to, which others write, too.
    const bool is_device = file_name.compare(0, 5, "/dev/") == 0;
    if (is_device || (fs::exists(status) && !fs::is_regular_file(status))) {
      write(std::fopen(file_name.c_str(), "wb"), file_name, text);
      return;
    }
    // Through a symbolic link it is its target that changes, not the link.
    fs::path target =
        fs::is_symlink(fs::symlink_status(file_name, error)) ? fs::canonical(file_name, error) : fs::path();
    if (target.empty()) target = file_name;
    std::FILE* file = open_beside(target, file_name);
    write(file, file_name, text);
  }

  /// \throws std::system_error as `add()` does; files renamed until then stay.
  void commit() {
    for (const Written& w : written_) {
      std::error_code error;
      std::filesystem::rename(w.temporary, w.target, error);
      if (error) fail(w.target.string(), error);
    }
    written_.clear();
  }

private:
  struct Written {
    std::filesystem::path temporary, target;
  };

  [[noreturn]] static void fail(const std::string& file_name, std::error_code error) {
    throw std::system_error(error, file_name + ": cannot be written");
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

  std::vector<Written> written_;
};

/// Writes `text` to a file that keeps its old content if that fails.
/// \throws std::system_error
inline void replace_file(const std::string& file_name, const std::string& text) {
  Replaced_files files;
  files.add(file_name, text);
  files.commit();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_REPLACED_FILES_H
