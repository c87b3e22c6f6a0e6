// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// A text file cut at ends of lines, into slices of about the same length, one for each part.
//
// Each part reads its own slice, and beyond it to the next end of a line. The first part reads the whole of what can
// only be read from the beginning, which is what gzip packed and what is no regular file, and sends the others theirs.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TEXT_SLICE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TEXT_SLICE_H

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/io/read_whole_file.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The cut before slice `i` of so many, in bytes.
inline std::uint64_t nominal_cut(std::uint64_t size, std::uint64_t i, std::uint64_t slices) {
  return size / slices * i + size % slices * i / slices;
}

/// Reads the slice of one part, without the others.
class Text_slice_reader {
public:
  /// \throws Pslg_error_2 if the file cannot be read
  explicit Text_slice_reader(const std::string& file_name)
      : file_name_(file_name), in_(file_name, std::ios::binary), size_(0) {
    if (!in_)
      throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                         file_name + ": cannot be opened: " + std::generic_category().message(errno));
    size_ = std::filesystem::file_size(file_name);
  }

  /// The lines that begin from the cut before slice `i` on, and before the one behind it.
  std::string slice(std::uint64_t i, std::uint64_t slices) {
    const std::uint64_t last = nominal_cut(size_, i + 1, slices);
    const std::uint64_t begin = first_line_from(nominal_cut(size_, i, slices), last);
    if (begin >= last) return std::string(); // within a long line
    std::string text = bytes(begin, first_line_from(last, size_) - begin);
    if (begin == 0) text = without_byte_order_mark(std::move(text), file_name_);
    return text;
  }

private:
  std::string bytes(std::uint64_t begin, std::uint64_t n) {
    std::string text(static_cast<std::size_t>(n), '\0');
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(begin));
    in_.read(text.data(), static_cast<std::streamsize>(n));
    if (static_cast<std::uint64_t>(in_.gcount()) != n)
      throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, file_name_ + ": cannot be read");
    return text;
  }

  /// Where the first line begins that does not begin before a place; `end` if that is not before it.
  std::uint64_t first_line_from(std::uint64_t place, std::uint64_t end) {
    if (place == 0 || place == end) return place;
    std::uint64_t begin = place - 1; // a line begins behind a line feed
    for (std::uint64_t n = 256; begin < end; begin += n, n *= 2) {
      n = std::min(n, end - begin);
      const std::size_t line_feed = bytes(begin, n).find('\n');
      if (line_feed != std::string::npos) return begin + line_feed + 1;
    }
    return end;
  }

  const std::string& file_name_;
  std::ifstream in_;
  std::uint64_t size_;
};

/// Whether a file can only be read from its beginning. What cannot be opened is said by who reads it so.
inline bool is_read_from_beginning(const std::string& file_name) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file_name, error)) return true;
  std::ifstream in(file_name, std::ios::binary);
  char mark[2] = {};
  in.read(mark, 2);
  return in.gcount() == 2 && mark[0] == '\x1f' && mark[1] == '\x8b';
}

/// Cuts a text and sends the slices. \returns that of this part
template <class Exchange>
std::string scattered(Exchange& exchange, const std::string& text) {
  Parcels outbox;
  const auto slices = static_cast<std::uint64_t>(exchange.size());
  for (std::size_t i = 0, begin = 0; i < slices && begin < text.size(); ++i) {
    const std::uint64_t cut = nominal_cut(text.size(), i + 1, slices);
    if (cut <= begin) continue;
    const std::size_t line_feed = text.find('\n', static_cast<std::size_t>(cut) - 1);
    const std::size_t end = line_feed == std::string::npos ? text.size() : line_feed + 1;
    outbox.push_back({static_cast<int>(i), Bytes(text.begin() + static_cast<std::ptrdiff_t>(begin),
                                                 text.begin() + static_cast<std::ptrdiff_t>(end))});
    begin = end;
  }
  std::string own;
  for (const Parcel& parcel : exchange.exchange(std::move(outbox)))
    own.assign(parcel.bytes.begin(), parcel.bytes.end());
  return own;
}

/// The slice of this part.
/// \throws Pslg_error_2 at all parts as `read_whole_file()` does
template <class Exchange>
std::string read_text_slice(Exchange& exchange, const std::string& file_name) {
  const bool is_first = exchange.rank() == 0;
  const bool is_whole = exchange.max(is_first && is_read_from_beginning(file_name) ? 1 : 0) == 1;
  std::string text;
  agree_on_work(exchange, [&] {
    if (!is_whole)
      text = Text_slice_reader(file_name).slice(static_cast<std::uint64_t>(exchange.rank()),
                                                static_cast<std::uint64_t>(exchange.size()));
    else if (is_first)
      text = read_whole_file(file_name);
  });
  if (is_whole) text = scattered(exchange, text);
  return text;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TEXT_SLICE_H
