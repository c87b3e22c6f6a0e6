#include "mesh_points.h"

#include "Word_map.h"

#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/round_mesh_2.h>
#include <CGAL/tags.h>

#include <utility>
#include <vector>

mesh_points::Mesh mesh_points::in_words(const std::vector<Point>& points, const Options& options,
                                        Report& report) {
  using namespace mesh_in_words_internal;
  const Word_map<Point> map(points, Room::EIGHTEENTH); // rows of squares are long
  std::vector<Word_point> words;
  words.reserve(points.size());
  for (const Point& p : points) words.push_back(map.to_word(p));
  check_told_apart(points, words);
  CGAL::Point_set_mesher_2<Word_traits, CGAL::Parallel_tag> mesher(options);
  auto rounded = CGAL::round_mesh_2<Point>(mesher(words), points,
                                           [&map](const Word_point& p) { return map.to_double(p); });
  report = mesher.report();
  rounded.renumber(report);
  to_doubles(report, rounded.mesh);
  return std::move(rounded.mesh);
}
