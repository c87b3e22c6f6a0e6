// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_PRINTABLE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_PRINTABLE_H

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Text of a file for a message: only the beginning of long text, and no character that a terminal obeys.
inline std::string printable(std::string_view text, std::size_t longest) {
  constexpr char digits[] = "0123456789abcdef";
  std::string result;
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte != 0x7f)
      result += c;
    else
      result.append("\\x").append(1, digits[byte / 16]).append(1, digits[byte % 16]);
  }
  return text.size() > longest ? result + "..." : result;
}

/// A word of a file in quotes.
inline std::string in_quotes(std::string_view word) { return '\'' + printable(word, 40) + '\''; }

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_PRINTABLE_H
