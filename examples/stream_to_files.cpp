// Meshes a graph with little memory, from file to file, and goes on if it was interrupted.

#include <CGAL/Quadtree_mesh_2/new_in_scratch_memory.h> // input and mesh need no memory either
#include <CGAL/Streaming_quality_mesher_2.h>

#include <exception>
#include <iostream>
#include <string>

int main(int argc, char** argv) try {
  const std::string input = argc > 1 ? argv[1] : QUADTREE_MESH_EXAMPLE_DATA_DIR "/great_lakes.poly.gz";
  const std::string output = argc > 2 ? argv[2] : "great_lakes.vtu";

  CGAL::Streaming_options_2 streaming;
  streaming.scratch_folder = output + ".scratch"; // on a disk with 250 bytes for each triangle
  streaming.memory = 200'000'000;                 // bytes

  CGAL::Streaming_quality_mesher_2<> mesher(CGAL::Quality_mesh_options_2().min_angle(25), streaming);
  const CGAL::Quality_mesh_report_2& report = mesher(input, output);

  std::cout << report.triangles << " triangles in " << output << ", " << report.unmet_triangles.size()
            << " below the bound\n";
  return report.is_met() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << " (start again to go on)\n";
  return 2;
}
