// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_BASE64_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_BASE64_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>

// Numbers as text that a page takes for an array (RFC 4648, section 4).

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Appends bytes to a text, three as four characters.
class Base64_appender {
public:
  /// Keeps a reference.
  explicit Base64_appender(std::string& text) : text_(text) {}

  void add(unsigned char byte) {
    bits_ = bits_ << 8 | byte;
    if (++bytes_ == 3) put_group(4);
  }
  /// Fills up the last group. Nothing is added after that.
  void finish() {
    if (bytes_ == 0) return;
    const int characters = bytes_ + 1;
    bits_ <<= 8 * (3 - bytes_);
    put_group(characters);
    text_.append(static_cast<std::size_t>(4 - characters), '=');
  }

private:
  void put_group(int characters) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int i = 0; i < characters; ++i) text_ += digits[bits_ >> (18 - 6 * i) & 63U];
    bits_ = 0;
    bytes_ = 0;
  }

  std::string& text_;
  std::uint32_t bits_ = 0; // of the bytes that are not written yet
  int bytes_ = 0;          // their number
};

/// Appends `value_at(0)`, ..., `value_at(n - 1)` as numbers of a type, little-endian on any machine.
template <class Number, class Value_at>
void append_base64(std::string& text, std::size_t n, const Value_at& value_at) {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  text.reserve(text.size() + (n * sizeof(Number) + 2) / 3 * 4);
  Base64_appender out(text);
  for (std::size_t i = 0; i < n; ++i) {
    const auto value = static_cast<Number>(value_at(i));
    Bits bits;
    if constexpr (std::is_floating_point_v<Number>)
      std::memcpy(&bits, &value, sizeof bits);
    else
      bits = static_cast<Bits>(value);
    for (std::size_t byte = 0; byte < sizeof(Number); ++byte)
      out.add(static_cast<unsigned char>(bits >> (8 * byte) & 255U));
  }
  out.finish();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_PAGE_BASE64_H
