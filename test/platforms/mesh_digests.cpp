// Meshes of a graph and of points over doubles and over words, one line for each: its triangles, and a digest of its
// coordinates and triangles. test/compilers.sh compares the lines of several compilers and standard libraries. The
// exit status tells whether all angles meet their bounds.

#include <CGAL/Filtered_quadtree_traits_2.h>
#include <CGAL/Fixed_point_quadtree_traits_2.h>
#include <CGAL/Point_set_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>

#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

using Doubles = CGAL::Filtered_quadtree_traits_2<>;
using Words = CGAL::Fixed_point_quadtree_traits_2<std::uint64_t>;

/// Numbers below 2^20, the same everywhere.
class Numbers {
public:
  std::uint32_t operator()() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::uint32_t>(state_ >> 44);
  }

private:
  std::uint64_t state_ = 1;
};

Doubles::Point_2 point(Doubles, std::uint32_t x, std::uint32_t y) { return {x / 1024.0, y / 1024.0}; }
/// Long words, in the middle of their root: a mesh of points needs room around them.
Words::Point_2 point(Words, std::uint32_t x, std::uint32_t y) {
  constexpr std::uint64_t unit = 0xfffff7fd1, low = (std::uint64_t(1) << 61) - (std::uint64_t(1) << 55);
  return {low + x * unit, low + y * unit};
}

template <class Traits>
std::vector<typename Traits::Point_2> random_points(std::size_t n) {
  std::vector<typename Traits::Point_2> points;
  Numbers numbers;
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t x = numbers(), y = numbers();
    points.push_back(point(Traits(), x, y));
  }
  return points;
}

/// A comb: teeth of random lengths, with acute corners at their tips, and points between them.
template <class Traits>
CGAL::Pslg_2<typename Traits::Point_2> comb() {
  CGAL::Pslg_2<typename Traits::Point_2> graph;
  graph.vertices = random_points<Traits>(300);
  Numbers numbers;
  const auto first = graph.add_vertex(point(Traits(), 1 << 20, 3 << 20));
  auto last = first;
  for (std::uint32_t i = 1; i <= 200; ++i) {
    const std::uint32_t y = (i % 2 == 0 ? 2 << 20 : 1 << 20) + numbers() / 2;
    const auto next = graph.add_vertex(point(Traits(), (1 << 20) + i * 8192, y));
    graph.add_segment(last, next);
    last = next;
  }
  graph.add_segment(last, first);
  const auto corner = [&](std::uint32_t x, std::uint32_t y) {
    return graph.add_vertex(point(Traits(), x, y));
  };
  const auto a = corner(0, 0), b = corner(4095 << 10, 0), c = corner(4095 << 10, 4095 << 10),
             d = corner(0, 4095 << 10);
  graph.add_segment(a, b), graph.add_segment(b, c), graph.add_segment(c, d), graph.add_segment(d, a);
  return graph;
}

template <class Mesh>
void print(const char* name, const Mesh& mesh) {
  CGAL::Quadtree_mesh_2::internal::Digest digest;
  for (const auto& p : mesh.points) digest.add(p.x()), digest.add(p.y());
  for (const auto& triangle : mesh.triangles)
    for (const auto v : triangle) digest.add(std::uint64_t(std::size_t(v)));
  std::printf("%s: %zu triangles, digest %016llx\n", name, mesh.triangles.size(),
              static_cast<unsigned long long>(digest.value()));
}

template <class Traits>
bool mesh_graph(const char* name, const CGAL::Quality_mesh_options_2& options) {
  CGAL::Quality_mesher_2<Traits> mesher(options);
  print(name, mesher(comb<Traits>()));
  return mesher.report().is_met();
}

template <class Traits>
bool mesh_points(const char* name, const CGAL::Point_set_mesh_options_2& options) {
  CGAL::Point_set_mesher_2<Traits> mesher(options);
  print(name, mesher(random_points<Traits>(2000)));
  return mesher.report().is_met();
}

} // namespace

int main() {
  using Graph_options = CGAL::Quality_mesh_options_2;
  using Point_options = CGAL::Point_set_mesh_options_2;
  const auto theorem_5 = Graph_options().separate(Graph_options::Separation::THEOREM_5);
  bool is_met = mesh_graph<Doubles>("graph of doubles", Graph_options());
  is_met &= mesh_graph<Words>("graph of words", Graph_options());
  is_met &= mesh_graph<Doubles>("graph of doubles in squares", Graph_options().max_edge(40));
  is_met &= mesh_graph<Words>("graph of words by quadtrees", theorem_5);
  is_met &= mesh_points<Words>("points of words", Point_options());
  is_met &= mesh_points<Words>("points of words, acute", Point_options().acute());
  return is_met ? 0 : 1;
}
