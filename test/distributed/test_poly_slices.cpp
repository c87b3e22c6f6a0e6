// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Slices of .poly files, one after the other, are the graph that is read at once; and what is wrong with a file is the
// same error, with the same line, at all parts.

#include "catch.h"
#include "joined_slices.h"
#include "mutate_text.h"
#include "scratch_folder.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/In_memory_exchange.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Poly_slice_reader.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Text_slice.h>

#include <cstddef>
#include <string>
#include <vector>

namespace test_poly_slices {

namespace {

using namespace CGAL::Quadtree_mesh_2::internal;
using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
using Graph = CGAL::Pslg_2<Point_2>;
using Slice = CGAL::Pslg_slice_2<Point_2>;

const std::string data = QUADTREE_MESH_TEST_DATA_DIR "/";

/// A graph, or what is wrong with its file.
struct Outcome {
  Graph graph;
  std::string error;
};

Outcome read_at_once(const std::string& file_name) {
  Outcome outcome;
  try {
    CGAL::IO::read_triangle_poly(file_name, outcome.graph);
  } catch (const CGAL::Pslg_error_2& error) {
    outcome.error = error.what();
  }
  return outcome;
}

/// \returns how much is wrong
int compare(const std::string& file_name, const Outcome& expected, int parts) {
  std::vector<Slice> slices(static_cast<std::size_t>(parts));
  std::vector<std::string> errors(slices.size());
  In_memory_exchange::run(parts, [&](In_memory_exchange& exchange) {
    const std::size_t part = static_cast<std::size_t>(exchange.rank());
    try {
      slices[part] = Poly_slice_reader<Point_2, In_memory_exchange>(exchange, file_name).read();
    } catch (const CGAL::Pslg_error_2& error) {
      errors[part] = error.what();
    }
  });
  int wrong = 0;
  for (const std::string& error : errors)
    if (error != expected.error) {
      ++wrong;
      UNSCOPED_INFO(error << "\nnot " << expected.error);
    }
  if (!expected.error.empty()) return wrong;
  return wrong + joined_slices::wrong_numbers(slices) +
         (joined_slices::are_same(joined_slices::joined(slices), expected.graph) ? 0 : 1);
}

void check_same(const std::string& file_name) {
  const Outcome expected = read_at_once(file_name);
  for (const int parts : {1, 2, 3, 7, 40}) {
    INFO(file_name << ", " << parts << " parts");
    CHECK(compare(file_name, expected, parts) == 0);
  }
}

const char* const with_everything = "# a comment\n"
                                    "5 2 2 1\n\n"
                                    "1 0 0   1 2 7\n"
                                    "2 4 0 3 4 8 # behind\n"
                                    "   \t\n"
                                    "3 4 4 5 6 9\n"
                                    "4 0 4 7 8 10\n"
                                    "5 1.5e-3 2 9 10 11\n"
                                    "# segments\n"
                                    "4 1\n"
                                    "1 1 2 5\n"
                                    "2 2 3 6\n"
                                    "3 3 4 7\n"
                                    "4 4 1 8\n"
                                    "1\n"
                                    "1 0.5 0.5\n"
                                    "2\n"
                                    "1 2 2 17 0.25\n"
                                    "2 3 3 18 -1\n"
                                    "\n# the end\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

} // namespace

TEST_CASE("slices of .poly files are the graph", "[distributed]") {
  for (const char* const name :
       {"syn_square.poly", "syn_holes_400.poly.gz", "us_states_10m.poly.gz", "hard_box.poly",
        "star_of_72_spikes.poly", "hole_on_vertex.poly", "no such file.poly"})
    check_same(data + name);
  check_same(QUADTREE_MESH_TEST_DATA_DIR); // a folder
}

TEST_CASE("slices of .poly files: all that a file may have", "[distributed]") {
  const Scratch_folder folder;
  const std::string text = with_everything;
  check_same(folder.write("all.poly", text));
  check_same(folder.write("crlf.poly", replaced(text, "\n", "\r\n")));
  check_same(folder.write("cr.poly", replaced(text, "\n", "\r")));
  check_same(folder.write("mark.poly", "\xef\xbb\xbf" + text));
  check_same(folder.write("utf16.poly", "\xff\xfe" + text));
  check_same(folder.write("no_end.poly", text.substr(0, text.find("\n\n# the end"))));
  check_same(folder.write("more.poly", text + "7\n"));
  check_same(folder.write("empty.poly", ""));
  check_same(folder.write("newlines.poly", std::string(100, '\n')));
  check_same(folder.write("long_line.poly", "# " + std::string(100000, 'x') + "\n" + text));
  check_same(folder.write("damaged.poly", std::string("\x1f\x8b") + text));
}

TEST_CASE("slices of .poly files: the first line with an error is told, though others are read before it",
          "[distributed]") {
  const Scratch_folder folder;
  const std::string text = with_everything;
  const std::string wrong_header = replaced(text, "\n4 1\n", "\nfour 1\n"),
                    wrong_vertex = replaced(text, "3 4 4 5 6 9", "3 4 four 5 6 9"),
                    wrong_segment = replaced(text, "3 3 4 7", "3 3 4 seven");
  check_same(folder.write("header.poly", wrong_header));
  check_same(folder.write("vertex.poly", replaced(wrong_header, "3 4 4 5 6 9", "3 4 four 5 6 9")));
  check_same(folder.write("segment.poly", wrong_segment));
  check_same(folder.write("both.poly", replaced(wrong_vertex, "3 3 4 7", "3 3 4 seven")));
  check_same(folder.write("too_many.poly", replaced(text, "\n4 1\n", "\n40 1\n")));
  check_same(folder.write("too_few.poly", replaced(text, "5 2 2 1", "4 2 2 1")));
  check_same(folder.write("huge.poly", replaced(text, "5 2 2 1", "5 2 4000000000 1")));
}

TEST_CASE("slices of .poly files with the vertices in a .node file", "[distributed]") {
  const Scratch_folder folder;
  const std::string poly = "0 2 0 0\n2 0\n0 0 1\n1 1 2\n0\n";
  const std::string alone = folder.write("alone.poly", poly), both = folder.write("both.poly", poly);
  check_same(alone);
  folder.write("both.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n");
  check_same(both);
  folder.write("both.node", "3 2 0 0\n0 0 0\n1 x 0\n2 0 1\n");
  check_same(both);
  folder.write("both.node", "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3\n");
  check_same(both);
  folder.write("both.node", "2 2 0 0\n1 0 0\n2 1 0\n");
  check_same(both);
  folder.write("both.node", "0 2 0 0\n");
  check_same(both);
}

TEST_CASE("slices of .poly files that are cut off or broken", "[distributed]") {
  const Scratch_folder folder;
  const std::string text = with_everything;
  for (std::size_t n = 0; n < text.size(); n += is_full_run() ? 3 : 7) {
    const std::string name = folder.write("cut.poly", text.substr(0, n));
    const Outcome expected = read_at_once(name);
    for (const int parts : {2, 5}) CHECK(compare(name, expected, parts) == 0);
  }
  int errors = 0;
  const int seeds = is_full_run() ? 300 : 50;
  for (int seed = 0; seed < seeds; ++seed) {
    const std::string name = folder.write("mutated.poly", Text_mutator(unsigned(seed))(text));
    const Outcome expected = read_at_once(name);
    // Slices have longer numbers.
    if (expected.error.find("more than indices can name") != std::string::npos) continue;
    errors += expected.error.empty() ? 0 : 1;
    INFO(content(name));
    for (const int parts : {2, 3, 11}) CHECK(compare(name, expected, parts) == 0);
  }
  CHECK(errors > seeds / 3);
}

TEST_CASE("text is cut into slices of about the same length", "[distributed]") {
  const Scratch_folder folder;
  std::string text;
  for (int i = 0; i < 1000; ++i) text += std::to_string(i * i) + '\n';
  const std::string name = folder.write("text", text);
  for (const std::size_t slices : {1u, 2u, 10u, 99u, 5000u}) {
    std::string all;
    for (std::size_t i = 0; i < slices; ++i) {
      const std::string slice = Text_slice_reader(name).slice(i, slices);
      CHECK(slice.size() <= text.size() / slices + 8);
      all += slice;
    }
    CHECK(all == text);
  }
}

} // namespace test_poly_slices
