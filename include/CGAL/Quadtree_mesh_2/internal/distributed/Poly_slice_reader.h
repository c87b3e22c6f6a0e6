// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Graphs from .poly files, of which each part reads a slice.
//
// Computes: at each part the vertices, segments, holes and regions whose lines are in its slice of the text. What is
//           wrong with the file is the same error as one part would tell, with the same line.
// Bound:    O(k) time for k characters of a part; some twenty sums over all parts.
// Method:   Lines with something in them are records, and are numbered by a scan. The header of a section tells how
//           many records it has, so it tells who has the next header. That of the segments is read ahead, so that
//           nobody waits for the vertices of others. Parts agree on errors section by section; in each, the first part
//           with an error has that of the first line.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_POLY_SLICE_READER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_POLY_SLICE_READER_H

#include <CGAL/IO/read_triangle_files.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Pslg_error_2.h>
#include <CGAL/Pslg_slice_2.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Text_slice.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/take_all_but_segments.h>
#include <CGAL/Quadtree_mesh_2/internal/io/Line_scanner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The records of a text that is cut into slices, to be read in order.
template <class Exchange>
class Record_slices {
public:
  Record_slices(Exchange& exchange, const std::string& file_name)
      : exchange_(exchange), text_(read_text_slice(exchange, file_name)) {
    Line_scanner counter(text_, file_name);
    std::int64_t records = 0;
    do {
      if (records % records_for_mark_ == 0) marks_.push_back(counter);
    } while (counter.try_next_line() && ++records != 0);
    const auto lines = static_cast<std::int64_t>(counter.lines_begun());
    first_ = exchange_.exclusive_scan(records);
    behind_ = first_ + records;
    all_ = exchange_.sum(records);
    const auto lines_before = static_cast<std::size_t>(exchange_.exclusive_scan(lines));
    for (Line_scanner& mark : marks_) mark.add_lines_before(lines_before);
    scanner_ = marks_.front();
  }
  Record_slices(const Record_slices&) = delete;
  Record_slices& operator=(const Record_slices&) = delete;

  Line_scanner& scanner() { return scanner_; }

  /// Whether there are more records, at any part.
  bool has_more() const { return next_ < all_; }

  /// How many of the next `n` records are here.
  std::size_t number_here(std::int64_t n) const {
    return static_cast<std::size_t>(std::max<std::int64_t>(0, end_here(n) - begin_here()));
  }

  /// Calls `read(i)` for those of the next `n` records that are here, counted from the first one of them. It moves the
  /// scanner to the record. If there are too few, the last part finds out.
  /// \param prepare called first
  /// \throws at all parts what `read` throws for the first record, or what `prepare` throws
  template <class Read, class Prepare>
  void for_each(std::int64_t n, const Read& read, const Prepare& prepare) {
    const std::int64_t end = end_of(n);
    agree_on_work(exchange_, [&] {
      prepare();
      for (std::int64_t i = begin_here(); i < end_here(n); ++i) read(static_cast<std::size_t>(i - next_));
      if (end - next_ < n && is_last()) read(static_cast<std::size_t>(end - next_));
    });
    next_ = end;
  }
  template <class Read>
  void for_each(std::int64_t n, const Read& read) {
    for_each(n, read, [] {});
  }

  /// Reads one record, where it is, which tells numbers to all parts.
  template <class Read>
  Numbers read_one(std::size_t number_of_numbers, const Read& read) {
    Numbers numbers(number_of_numbers, 0);
    for_each(1, [&](std::size_t) { read(numbers); });
    exchange_.sum(numbers);
    return numbers;
  }

  /// Reads the record that follows on the next `n` ones, before its turn: `read(scanner, numbers)`.
  /// \returns nothing, at all parts, if it cannot be read. In its turn it will be known why.
  template <class Read>
  std::optional<Numbers> read_ahead(std::int64_t n, std::size_t number_of_numbers, const Read& read) const {
    if (n >= all_ - next_) return std::nullopt;
    const std::int64_t record = next_ + n;
    Numbers numbers(number_of_numbers, 0), failures{0};
    if (record >= first_ && record < behind_) {
      try {
        Line_scanner scanner = scanner_at(record);
        read(scanner, numbers);
      } catch (const Pslg_error_2&) {
        ++failures[0];
      }
    }
    exchange_.sum(numbers), exchange_.sum(failures);
    return failures[0] == 0 ? std::optional<Numbers>(std::move(numbers)) : std::nullopt;
  }

private:
  static constexpr std::int64_t records_for_mark_ = 4096;

  bool is_last() const { return exchange_.rank() + 1 == exchange_.size(); }
  std::int64_t end_of(std::int64_t n) const { return next_ + std::min(n, all_ - next_); }
  std::int64_t begin_here() const { return std::max(next_, first_); }
  std::int64_t end_here(std::int64_t n) const { return std::min(end_of(n), behind_); }

  /// \pre the record is here
  Line_scanner scanner_at(std::int64_t record) const {
    const std::int64_t place = record - first_;
    Line_scanner scanner = marks_[static_cast<std::size_t>(place / records_for_mark_)];
    for (std::int64_t i = place % records_for_mark_; i > 0; --i) scanner.try_next_line();
    return scanner;
  }

  Exchange& exchange_;
  std::string text_;
  Line_scanner scanner_{std::string_view(), std::string()};
  std::vector<Line_scanner> marks_;     // before every 4096th of this part's records
  std::int64_t first_ = 0, behind_ = 0; // the records of this part
  std::int64_t all_ = 0, next_ = 0;
};

/// Reads a graph, see the head of this file.
template <class Point, class Exchange>
class Poly_slice_reader {
public:
  Poly_slice_reader(Exchange& exchange, const std::string& file_name)
      : exchange_(exchange), file_name_(file_name) {}

  Pslg_slice_2<Point> read() {
    Record_slices<Exchange> records(exchange_, file_name_);
    const std::string node_name = name_of_node_file();
    const Triangle_section vertices = read_vertex_header(records, [&](Line_scanner& scanner) {
      if (node_name.empty()) scanner.fail("no vertices here, and no .node file beside it that has them");
    });
    if (vertices.n > 0) {
      read_first_vertex(records, vertices);
      read_vertices_and_segments(records, vertices);
    } else {
      Record_slices<Exchange> nodes(exchange_, node_name);
      read_vertices(nodes);
      read_end(nodes);
      read_segments(records);
    }
    read_holes(records);
    read_regions(records);
    read_end(records);
    return result();
  }

private:
  using Parser = Triangle_parser<Point>;
  static constexpr std::size_t limit = static_cast<std::size_t>(std::numeric_limits<std::int64_t>::max() / 4);

  /// Only one part looks for it, so that all have the same.
  std::string name_of_node_file() {
    Bytes name;
    if (exchange_.rank() == 0) {
      const std::string found = find_node_file(file_name_);
      name.assign(found.begin(), found.end());
    }
    exchange_.broadcast(name, 0);
    return std::string(name.begin(), name.end());
  }

  static Triangle_section section_of(const Numbers& numbers) {
    return {static_cast<std::size_t>(numbers[0]), static_cast<std::size_t>(numbers[1]), numbers[2] != 0};
  }
  static void tell(const Triangle_section& section, Numbers& numbers) {
    numbers = {static_cast<std::int64_t>(section.n), static_cast<std::int64_t>(section.attributes),
               section.has_markers ? 1 : 0};
  }

  /// \param check_none called for the header if there are no vertices
  template <class Check_none>
  Triangle_section read_vertex_header(Record_slices<Exchange>& records, const Check_none& check_none) {
    Parser parser(records.scanner(), graph_, limit);
    const Triangle_section section = section_of(records.read_one(3, [&](Numbers& numbers) {
      const Triangle_section read = parser.read_vertex_header();
      if (read.n == 0) check_none(records.scanner());
      tell(read, numbers);
    }));
    graph_.number_of_vertex_attributes = section.attributes;
    slice_.number_of_vertices = static_cast<std::int64_t>(section.n);
    return section;
  }

  /// It tells from where the file counts.
  void read_first_vertex(Record_slices<Exchange>& records, const Triangle_section& section) {
    Parser parser(records.scanner(), graph_, limit);
    const Numbers first = records.read_one(1, [&](Numbers& numbers) {
      parser.read_vertex(0, section);
      numbers[0] = static_cast<std::int64_t>(graph_.first_number);
    });
    graph_.first_number = static_cast<std::size_t>(first[0]);
  }

  /// \pre the first vertex has been read
  void read_other_vertices(Record_slices<Exchange>& records, const Triangle_section& section) {
    Parser parser(records.scanner(), graph_, limit);
    records.for_each(
        slice_.number_of_vertices - 1, [&](std::size_t i) { parser.read_vertex(i + 1, section); },
        [&] { parser.make_room_for_vertices(records.number_here(slice_.number_of_vertices - 1), section); });
  }

  void read_vertices(Record_slices<Exchange>& records) {
    const Triangle_section section = read_vertex_header(records, [](Line_scanner&) {});
    if (section.n == 0) return;
    read_first_vertex(records, section);
    read_other_vertices(records, section);
  }

  Triangle_section read_segment_header(Record_slices<Exchange>& records) {
    Parser parser(records.scanner(), graph_, limit);
    const Triangle_section section = section_of(
        records.read_one(3, [&](Numbers& numbers) { tell(parser.read_segment_header(), numbers); }));
    slice_.number_of_segments = static_cast<std::int64_t>(section.n);
    return section;
  }

  void read_segment(Parser& parser, std::size_t i, const Triangle_section& section) {
    const std::array<std::size_t, 2> ends = parser.read_segment(i, section);
    slice_.segments.push_back({{static_cast<std::int64_t>(ends[0]), static_cast<std::int64_t>(ends[1])}});
  }

  void read_segments(Record_slices<Exchange>& records) {
    const Triangle_section section = read_segment_header(records);
    Parser parser(records.scanner(), graph_, limit);
    parser.set_number_of_vertices(static_cast<std::size_t>(slice_.number_of_vertices));
    records.for_each(slice_.number_of_segments, [&](std::size_t i) { read_segment(parser, i, section); });
  }

  /// Each part reads its vertices and then its segments, whatever others have. If the header between them is wrong, it
  /// is read in its turn instead, so that an error of a vertex is told first.
  /// \pre the first vertex has been read
  void read_vertices_and_segments(Record_slices<Exchange>& records, const Triangle_section& vertices) {
    const std::int64_t others = slice_.number_of_vertices - 1;
    const auto header = records.read_ahead(others, 3, [](Line_scanner& scanner, Numbers& numbers) {
      Pslg_2<Point> nothing;
      tell(Parser(scanner, nothing, limit).read_segment_header(), numbers);
    });
    if (!header) {
      read_other_vertices(records, vertices);
      return read_segments(records);
    }
    const Triangle_section segments = section_of(*header);
    slice_.number_of_segments = static_cast<std::int64_t>(segments.n);
    Parser parser(records.scanner(), graph_, limit);
    parser.set_number_of_vertices(static_cast<std::size_t>(slice_.number_of_vertices));
    const std::size_t first_segment = vertices.n; // behind the other vertices and the header
    const auto read = [&](std::size_t i) {
      if (i + 1 < first_segment)
        parser.read_vertex(i + 1, vertices);
      else if (i + 1 == first_segment)
        parser.read_segment_header();
      else
        read_segment(parser, i - first_segment, segments);
    };
    records.for_each(others + 1 + slice_.number_of_segments, read,
                     [&] { parser.make_room_for_vertices(records.number_here(others), vertices); });
  }

  void read_holes(Record_slices<Exchange>& records) {
    Parser parser(records.scanner(), graph_, limit);
    const Numbers n = records.read_one(
        1, [&](Numbers& numbers) { numbers[0] = static_cast<std::int64_t>(parser.read_hole_header()); });
    records.for_each(n[0], [&](std::size_t i) { parser.read_hole(i); });
  }

  void read_regions(Record_slices<Exchange>& records) {
    if (!records.has_more()) return;
    Parser parser(records.scanner(), graph_, limit);
    const Numbers n = records.read_one(
        1, [&](Numbers& numbers) { numbers[0] = static_cast<std::int64_t>(parser.read_region_header()); });
    records.for_each(n[0], [&](std::size_t i) { parser.read_region(i); });
  }

  void read_end(Record_slices<Exchange>& records) {
    if (!records.has_more()) return;
    Parser parser(records.scanner(), graph_, limit);
    records.for_each(1, [&](std::size_t) { parser.read_end(); });
  }

  Pslg_slice_2<Point> result() {
    slice_.first_vertex = exchange_.exclusive_scan(static_cast<std::int64_t>(graph_.vertices.size()));
    slice_.first_segment = exchange_.exclusive_scan(static_cast<std::int64_t>(slice_.segments.size()));
    take_all_but_segments(graph_, slice_);
    return std::move(slice_);
  }

  Exchange& exchange_;
  std::string file_name_;
  Pslg_2<Point> graph_; // all but the segments of this part
  Pslg_slice_2<Point> slice_;
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_POLY_SLICE_READER_H
