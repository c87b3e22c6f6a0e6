// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "catch.h"
#include "scratch_folder.h"
#include "triangle_files_tools.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/validate_pslg_2.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test_triangle_files {

using namespace triangle_files_test;

TEST_CASE("a .poly file with everything is read", "[triangle_files]") {
  const Pslg pslg = parse(full_example);
  CHECK(pslg.vertices == std::vector<Point>{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {1, 0.5}});
  CHECK(pslg.vertex_markers == std::vector<int>{7, 8, 9, -10, 0});
  CHECK(pslg.number_of_vertex_attributes == 2);
  CHECK(pslg.vertex_attributes == std::vector<double>{0.5, 100, 1.5, 200, 2.5, 300, 3.5, -400, 4.5, 0.05});
  const Pslg expected = make_pslg<double>({}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  CHECK(pslg.segments == expected.segments);
  CHECK(pslg.segment_markers == std::vector<int>{11, 12, 13, 0});
  CHECK(pslg.holes == std::vector<Point>{{1, 1}, {2.5, 2.5}});
  REQUIRE(pslg.regions.size() == 2);
  CHECK(pslg.regions[0].point == Point(3, 3));
  CHECK(pslg.regions[0].attribute == 17);
  CHECK(pslg.regions[0].max_area == 0.25);
  CHECK(pslg.regions[1].attribute == -18);
  CHECK(pslg.regions[1].max_area == 0);
}

TEST_CASE("line ends, numbering and missing columns do not matter", "[triangle_files]") {
  const Pslg expected = make_pslg<double>({{0, 0}, {1, 0}, {0, 1}}, {{0, 1}, {1, 2}});
  CHECK(have_same_bits(parse("3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n2 0\n0 0 1\n1 1 2\n0\n"), expected));
  CHECK(have_same_bits(parse("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n2 0\n0 1 2\n1 2 3\n0"), expected));
  CHECK(have_same_bits(parse("3 2 0 0\r\n1 0 0\r\n2 1 0\r\n3 0 1\r\n2 0\r\n1 1 2\r\n2 2 3\r\n0\r\n\r\n"),
                       expected));
  CHECK(have_same_bits(parse("\xef\xbb\xbf"
                             "3 2 0 0\r1 0 0\r2 1 0\r3 0 1\r2 0\r1 1 2\r2 2 3\r0"),
                       expected));
  CHECK(have_same_bits(parse("3 2 0 0\n0 0 0\n1\t1\f0\n2\v0 1\n2 0\n0 0 1\n1 1 2\n0"), expected));
  CHECK(have_same_bits(parse("3\n1 0 0#\n2 1 0#x\n3 0 1 99\n2\n1 1 2 5\n2 2 3 6\n0\n0\n"), expected));
  CHECK(parse("3\n0 0 0\n1 1 0\n2 0 1\n0\n0\n1\n1 0.1 0.1 5 -1\n").regions[0].max_area == 0);
}

TEST_CASE("coordinates of other kernels and of words are read", "[triangle_files]") {
  std::istringstream in("3\n0 0 0\n1 1 0.5\n2 0 1\n0\n0\n");
  CGAL::Pslg_2<CGAL::Exact_predicates_exact_constructions_kernel::Point_2> exact;
  CGAL::IO::read_triangle_poly(in, exact);
  CHECK(exact.vertices[1].y() == 0.5);

  CGAL::Pslg_2<Word_point<std::uint64_t>> words;
  std::istringstream word_in("3\n0 0 0\n1 18446744073709551615 0\n2 0 +1\n0\n0\n");
  CGAL::IO::read_triangle_poly(word_in, words);
  CHECK(words.vertices[1].x() == (std::numeric_limits<std::uint64_t>::max)());

  CGAL::Pslg_2<Word_point<std::uint32_t>> narrow;
  for (const std::string number : {"-1", "0.5", "4294967296"}) {
    std::istringstream bad("1\n0 3 " + number + "\n0\n0\n");
    CHECK(has_text(error_of([&] { CGAL::IO::read_triangle_poly(bad, narrow); }),
                   "input:2: y of vertex 0: '" + number + "' is "));
  }
}

TEST_CASE("a .poly file without vertices takes them from its .node file", "[triangle_files]") {
  const Scratch_folder folder;
  const std::string poly = folder.write("box.1.poly", "0 2 0 0\n3 0\n0 1 2\n1 2 3\n2 3 1\n0\n");
  Pslg pslg;
  CHECK(has_text(error_of([&] { CGAL::IO::read_triangle_poly(poly, pslg); }),
                 "box.1.poly:1: no vertices here"));

  folder.write("box.1.node", "3 2 1 1\n1 0 0 0.5 4\n2 1 0 0.25 5\n3 0 1 0.125 6\n");
  CGAL::IO::read_triangle_poly(poly, pslg);
  CHECK(pslg.vertices == std::vector<Point>{{0, 0}, {1, 0}, {0, 1}});
  CHECK(pslg.vertex_markers == std::vector<int>{4, 5, 6});
  CHECK(pslg.vertex_attributes == std::vector<double>{0.5, 0.25, 0.125});
  CHECK(pslg.segments == make_pslg<double>({}, {{0, 1}, {1, 2}, {2, 0}}).segments);

  folder.write("box.1.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 what\n");
  CHECK(has_text(error_of([&] { CGAL::IO::read_triangle_poly(poly, pslg); }),
                 "box.1.node:4: y of vertex 3: 'what'"));
  CHECK(pslg.vertex_markers.size() == 3);
}

TEST_CASE("messages about a graph have the numbers of its file", "[triangle_files]") {
  const auto message = [](const std::string& first, const std::string& second, const std::string& ends) {
    std::istringstream in("4 2 0 0\n" + first + " 0 0\n" + second + " 1 0\n" + ends + "0\n0\n");
    Pslg pslg;
    return error_of([&] {
      CGAL::IO::read_triangle_poly(in, pslg);
      CGAL::validate_pslg_2(pslg);
    });
  };
  CHECK(message("0", "1", "2 0 1\n3 1 1\n2\n0 0 1\n1 3 3\n") ==
        "segment 1 from vertex 3 (1, 1) to vertex 3 (1, 1) has length zero");
  CHECK(message("1", "2", "3 0 1\n4 1 1\n2\n1 1 2\n2 4 4\n") ==
        "segment 2 from vertex 4 (1, 1) to vertex 4 (1, 1) has length zero");
  CHECK(message("1", "2", "3 0 1\n4 1 1\n2\n1 1 2\n2 4\n") ==
        "input:8: the line ends where an end of segment 2 is expected");
}

TEST_CASE("what is wrong with a malformed file is told with its line", "[triangle_files]") {
  const std::string triangle = "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", ":1: the file ends where the number of vertices is expected"},
      {"# nothing\n\n", ":2: the file ends where the number of vertices is expected"},
      {"lake\n", ":1: the number of vertices: 'lake' is not an integer"},
      {"-3 2 0 0\n", ":1: the number of vertices is negative"},
      {"2.5 2 0 0\n", ":1: the number of vertices: '2.5' is not an integer"},
      {"99999999999999999999 2\n", ":1: the number of vertices: '99999999999999999999' is too large"},
      {"1000000000000 2 0 0\n0 0 0\n",
       ":1: the number of vertices, 1000000000000, is more than indices can name"},
      {std::string("3 2 0 0\n0 0 \0\n", 14), ":2: y of vertex 0: '\\x00' is not a number"},
      {"3 2 0 0\n0 0 " + std::string(1 << 20, '7') + "x\n",
       ":2: y of vertex 0: '7777777777777777777777777777777777777777...' is not a number"},
      {"3 2 0 0\n1 0 0\n1 1 0\n", ":3: vertex 1 stands where vertex 2 is expected"},
      {triangle + "-1\n", ":5: the number of segments is negative"},
      {triangle + "0\n-1\n", ":6: the number of holes is negative"},
      {triangle + "0\n0\n1000000000000\n", ":7: the number of regions, 1000000000000, is more than"},
      {"5000000000 2 0 0\n", ":1: the number of vertices, 5000000000, is more than indices can name"},
      {"4000000000 2 0 0\n0 0 0\n", ":2: the file ends where vertex 1 is expected"},
      {"4000000000 2 4000000000 1\n0 0 0\n", ":2: the line ends where an attribute of vertex 0 is expected"},
      {"3 3 0 0\n0 0 0 0\n", ":1: the dimension is 3 instead of 2"},
      {"3 2 0 2\n0 0 0 0\n", ":1: the number of markers is 2 instead of 0 or 1"},
      {"3 2 0 0 x\n", ":1: a column behind the header: 'x' is not a number"},
      {"3 2 0 0\n2 0 0\n", ":2: the first vertex has the number 2 instead of 0 or 1"},
      {"3 2 0 0\n1 0 0\n3 1 0\n", ":3: vertex 3 stands where vertex 2 is expected"},
      {"3 2 0 0\n0 0 0\n1 1 zero\n", ":3: y of vertex 1: 'zero' is not a number"},
      {"3 2 0 0\n0 0 0\n1 1.5x 0\n", ":3: x of vertex 1: '1.5x' is not a number"},
      {"3 2 0 0\n0 0 0\n1 1,5 0\n", ":3: x of vertex 1: '1,5' is not a number"},
      {"3 2 0 0\n0 0 0\n1 0x10 0\n", ":3: x of vertex 1: '0x10' is not a number"},
      {"3 2 0 0\n0 0 0\n1 ++1 0\n", ":3: x of vertex 1: '++1' is not a number"},
      {"3 2 0 0\n0 0 0\n1 +-1 0\n", ":3: x of vertex 1: '+-1' is not a number"},
      {"3 2 0 0\n0 0 0\n1 + 0\n", ":3: x of vertex 1: '+' is not a number"},
      {"3 2 0 0\n0 0 0\n1 nan 0\n", ":3: x of vertex 1: 'nan' is not finite"},
      {"3 2 0 0\n0 0 0\n1 0 -inf\n", ":3: y of vertex 1: '-inf' is not finite"},
      {"3 2 0 0\n0 0 0\n1 0 Infinity\n", ":3: y of vertex 1: 'Infinity' is not finite"},
      {"3 2 0 0\n0 0 0\n1 0 1e400\n", ":3: y of vertex 1: '1e400' is too large or too small"},
      {"3 2 0 0\n0 0 0\n1 0\n", ":3: the line ends where y of vertex 1 is expected"},
      {"3 2 0 0\n0 0 0\n1 0 # 1\n", ":3: the line ends where y of vertex 1 is expected"},
      {"3 2 1 0\n0 0 0\n", ":2: the line ends where an attribute of vertex 0 is expected"},
      {"3 2 0 1\n0 0 0\n", ":2: the line ends where the marker of vertex 0 is expected"},
      {"3 2 0 1\n0 0 0 1.5\n", ":2: the marker of vertex 0: '1.5' is not an integer"},
      {"3 2 0 0\n0 0 0 north\n", ":2: a column behind vertex 0: 'north' is not a number"},
      {"3 2 0 0\n0 0 0\n", ":2: the file ends where vertex 1 is expected"},
      {triangle, ":4: the file ends where the number of segments is expected"},
      {triangle + "x\n", ":5: the number of segments: 'x' is not an integer"},
      {triangle + "2 0\n0 0 1\n", ":6: the file ends where segment 1 is expected"},
      {triangle + "1 0\n0 0 3\n0\n",
       ":6: an end of segment 0: there is no vertex 3, the vertices are 0 to 2"},
      {triangle + "1 0\n0 -1 1\n0\n",
       ":6: an end of segment 0: there is no vertex -1, the vertices are 0 to 2"},
      {triangle + "1 0\n0 0\n0\n", ":6: the line ends where an end of segment 0 is expected"},
      {triangle + "1 1\n0 0 1\n0\n", ":6: the line ends where the marker of segment 0 is expected"},
      {triangle + "1 1\n0 0 1 3000000000\n0\n", ":6: the marker of segment 0: '3000000000' is too large"},
      {triangle + "4000000000 1\n0 0 1 3\n0\n", ":7: the line ends where an end of segment 1 is expected"},
      {triangle + "1 0\n0 0 1\n", ":6: the file ends where the number of holes is expected"},
      {triangle + "0\n4000000000\n", ":6: the file ends where hole 0 is expected"},
      {triangle + "0\n1\n0 0.5\n", ":7: the line ends where y of hole 0 is expected"},
      {triangle + "0\n1\n0 0.5 nan\n", ":7: y of hole 0: 'nan' is not finite"},
      {triangle + "0\n0\n2\n0 0 0 1\n", ":8: the file ends where region 1 is expected"},
      {triangle + "0\n0\n1\n0 0.25 0.25\n", ":8: the line ends where the attribute of region 0 is expected"},
      {triangle + "0\n0\n1\n0 0.25 0.25 1 big\n", ":8: the maximum area of region 0: 'big' is not a number"},
      {triangle + "0\n0\n0\n17\n", ":8: nothing more is expected"},
      {"0 2 0 0\n1 0\n0 0 1\n0\n", ":1: no vertices here"},
  };
  for (const auto& [text, expected] : cases) {
    CAPTURE(text, expected, parse_error(text));
    CHECK(has_text(parse_error(text), "test.poly" + expected));
  }
}

TEST_CASE("a vertex is named by the number it has in the file", "[triangle_files]") {
  CHECK(has_text(parse_error("2 2 0 0\n1 0 0\n2 0 no\n"), "y of vertex 2"));
  CHECK(has_text(parse_error("2 2 0 0\n1 0 0\n2 0 1\n1 0\n1 0 1\n"), "no vertex 0, the vertices are 1 to 2"));
}

TEST_CASE("what a header claims is not allocated", "[triangle_files]") {
  const auto begin = std::chrono::steady_clock::now();
  CHECK(!parse_error("4294967294 2 4294967294 1\n0 0 0 1\n").empty());
  CHECK(!parse_error("1 2 0 0\n0 0 0\n4294967294 1\n0 0 0 1\n").empty());
  CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(1));
}

TEST_CASE("a failed read leaves its arguments alone", "[triangle_files]") {
  const Scratch_folder folder;
  const Pslg before = parse(full_example);
  Pslg pslg = before;
  std::istringstream in("3 2 0 0\n0 0 0\n");
  CHECK_THROWS_AS(CGAL::IO::read_triangle_poly(in, pslg), CGAL::Pslg_error_2);
  CHECK_THROWS_AS(CGAL::IO::read_triangle_node(folder.write("x.node", "3 2 0 0\n0 0 0\n"), pslg),
                  CGAL::Pslg_error_2);
  CHECK(have_same_bits(pslg, before));
}

TEST_CASE("files that cannot be read are named", "[triangle_files]") {
  const Scratch_folder folder;
  Pslg pslg;
  const auto error = [&](const std::string& name) {
    return error_of([&] { CGAL::IO::read_triangle_poly(name, pslg); });
  };
  CHECK(error(folder.file("none.poly")) ==
        folder.file("none.poly") + ": cannot be opened: No such file or directory");
  CHECK(has_text(error(folder.file("")), ": is a folder"));
  CHECK(has_text(error("/dev/null"), "/dev/null:1: the file ends"));
  CHECK(
      has_text(error_of([&] { CGAL::IO::read_triangle_node(folder.file("none.node"), pslg); }), "none.node"));
}

TEST_CASE("files compressed by gzip are read", "[triangle_files]") {
  Pslg pslg;
  CGAL::IO::read_triangle_poly(data_file("us_states_10m.poly.gz"), pslg);
  CHECK(pslg.number_of_vertices() == 11308);
  CHECK(pslg.number_of_segments() == 11362);

  const Scratch_folder folder;
  const std::string packed = content(data_file("us_states_10m.poly.gz"));
  const std::string half = folder.write("half.poly.gz", packed.substr(0, packed.size() / 2));
  CHECK(error_of([&] { CGAL::IO::read_triangle_poly(half, pslg); }) ==
        half + ": the gzip data are damaged or truncated");
  CHECK_THROWS_AS(CGAL::IO::read_triangle_poly(folder.write("tail.poly.gz", packed + "more"), pslg),
                  CGAL::Pslg_error_2);
  CHECK_THROWS_AS(CGAL::IO::read_triangle_poly(
                      folder.write("no_footer.poly.gz", packed.substr(0, packed.size() - 1)), pslg),
                  CGAL::Pslg_error_2);
  std::string damaged = packed;
  damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 0x55);
  CHECK_THROWS_AS(CGAL::IO::read_triangle_poly(folder.write("damaged.poly.gz", damaged), pslg),
                  CGAL::Pslg_error_2);
}

TEST_CASE("all test inputs are read", "[triangle_files]") {
  struct Input {
    const char* name;
    std::size_t vertices, segments, holes;
  };
  const Input inputs[] = {
      {"gshhg_aegean_h.poly.gz", 21093, 21088, 0},
      {"gshhg_norway_f.poly.gz", 103064, 103050, 0},
      {"syn_comb.poly", 1003, 1003, 0},
      {"syn_fan_1deg.poly", 365, 364, 0},
      {"syn_holes_400.poly.gz", 2404, 2404, 400},
      {"syn_near_1e-06.poly", 8, 6, 0},
      {"syn_near_1e-12.poly", 8, 6, 0},
      {"syn_parallel_0.001.poly", 8, 6, 0},
      {"syn_sliver_1deg.poly", 3, 3, 0},
      {"syn_square.poly", 4, 4, 0},
      {"syn_wedge_0.01deg.poly", 7, 6, 0},
      {"syn_wedge_10deg.poly", 7, 6, 0},
      {"syn_wedge_1deg.poly", 7, 6, 0},
      {"us_states_10m.poly.gz", 11308, 11362, 0},
  };
  for (const Input& input : inputs) {
    CAPTURE(input.name);
    Pslg pslg;
    REQUIRE_NOTHROW(CGAL::IO::read_triangle_poly(data_file(input.name), pslg));
    CHECK(pslg.number_of_vertices() == input.vertices);
    CHECK(pslg.number_of_segments() == input.segments);
    CHECK(pslg.holes.size() == input.holes);
  }
}

TEST_CASE("a truncated file is an error or ends in a shorter number", "[triangle_files]") {
  const std::string text = full_example;
  for (std::size_t size = 0; size < text.size(); ++size) {
    const std::string error = parse_error(text.substr(0, size)); // nothing but Pslg_error_2 may come out
    // The last column that has to be there, and the sections behind it that may be left out.
    const bool may_pass = size >= text.find("+2.5") + 2;
    CAPTURE(size);
    CHECK((may_pass || !error.empty()));
  }
}

TEST_CASE("damaged files never do worse than an error", "[triangle_files]") {
  std::mt19937 random(7);
  const std::string alphabet = "0123456789+-.eE# \n\tnaif\0xyz";
  for (int i = 0; i < 3000; ++i) {
    std::string text = full_example;
    for (int k = 0; k < 1 + i % 4; ++k) text[random() % text.size()] = alphabet[random() % alphabet.size()];
    const std::string error = parse_error(text);
    if (!error.empty()) REQUIRE(has_text(error, "test.poly:"));
  }
}

} // namespace test_triangle_files
