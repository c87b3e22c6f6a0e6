// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_READ_WHOLE_FILE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_READ_WHOLE_FILE_H

#include <CGAL/Pslg_error_2.h>

// gzip needs the compiled part of Boost.Iostreams, so it is there only for programs that link it: through
// CGAL's target (the first macro) or through Boost's own.
#if defined(CGAL_LINKED_WITH_BOOST_IOSTREAMS) || defined(BOOST_IOSTREAMS_DYN_LINK) ||                        \
    defined(BOOST_IOSTREAMS_STATIC_LINK)
#define CGAL_QUADTREE_MESH_2_HAS_GZIP 1
#endif

#ifdef CGAL_QUADTREE_MESH_2_HAS_GZIP
#include <boost/iostreams/copy.hpp>
#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/gzip.hpp>
#include <boost/iostreams/filtering_streambuf.hpp>
#endif

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <system_error>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// All that is left in `in`.
/// \throws Pslg_error_2 with `name` in its message when the stream breaks.
inline std::string read_bytes(std::istream& in, const std::string& name) {
  // The size is not asked for: pipes have none, and a file may grow while it is read.
  std::string text;
  for (std::size_t chunk = std::size_t(1) << 16; in; chunk = (std::min)(2 * chunk, std::size_t(1) << 26)) {
    const std::size_t size = text.size();
    text.resize(size + chunk);
    in.read(&text[size], static_cast<std::streamsize>(chunk));
    text.resize(size + static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad() || !in.eof())
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, name + ": cannot be read");
  return text;
}

/// Unpacks what gzip packed; text that is not gzip's comes back as it is.
/// \throws Pslg_error_2 if the packed data are damaged, or if the program was built without Boost.Iostreams.
inline std::string unpack_gzip(std::string text, const std::string& name) {
  if (text.compare(0, 2, "\x1f\x8b") != 0) return text;
#ifdef CGAL_QUADTREE_MESH_2_HAS_GZIP
  namespace io = boost::iostreams;
  std::string unpacked;
  try {
    io::filtering_streambuf<io::input> in;
    in.push(io::gzip_decompressor());
    in.push(io::array_source(text.data(), text.size()));
    io::copy(in, io::back_inserter(unpacked));
  } catch (const std::ios_base::failure&) { // gzip_error is one
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                       name + ": the gzip data are damaged or truncated");
  }
  return unpacked;
#else
  throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                     name + ": is compressed by gzip, and this program is built without Boost.Iostreams");
#endif
}

/// Text without the mark of UTF-8 that editors put before it.
/// \throws Pslg_error_2 for text of 16 bits a character
inline std::string without_byte_order_mark(std::string text, const std::string& name) {
  for (const char* const mark : {"\xff\xfe", "\xfe\xff"})
    if (text.compare(0, 2, mark) == 0)
      throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                         name + ":1: is text in UTF-16; UTF-8 is expected");
  if (text.compare(0, 3, "\xef\xbb\xbf") == 0) text.erase(0, 3);
  return text;
}

/// All text that is left in `in`, unpacked.
/// \throws Pslg_error_2 with `name` in its message
inline std::string read_whole_stream(std::istream& in, const std::string& name) {
  return without_byte_order_mark(unpack_gzip(read_bytes(in, name), name), name);
}

/// \throws Pslg_error_2 if the file does not exist or cannot be read; it says why.
inline std::string read_whole_file(const std::string& file_name) {
  errno = 0;
  std::ifstream in(file_name, std::ios::binary);
  if (!in)
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE,
                       file_name + ": cannot be opened: " + std::generic_category().message(errno));
  std::error_code ignored;
  if (std::filesystem::is_directory(file_name, ignored))
    throw Pslg_error_2(Pslg_error_2::Kind::UNREADABLE_FILE, file_name + ": is a folder");
  return read_whole_stream(in, file_name);
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_READ_WHOLE_FILE_H
