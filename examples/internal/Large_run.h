#ifndef QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H
#define QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H

// What quality_mesh does for meshes that are larger than memory, or take long: arrays in a scratch folder, and a state
// to go on from.

#include "command_line.h"

#include <CGAL/Pslg_2.h>
#include <CGAL/Scratch_memory.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

class Large_run {
public:
  /// Begins what the command line asks for: a scratch memory, and checkpoints in the options.
  /// \throws std::system_error naming the scratch folder if it cannot be used
  explicit Large_run(Command_line& line) : folder_(line.scratch_folder) {
    if (folder_.empty()) return;
    const bool is_new = std::filesystem::create_directories(folder_);
    is_ours_ = is_new || line.is_scratch_folder_ours;
    if (line.memory > 0) memory_.emplace(line.scratch_folder, line.memory);
    if (!has_checkpoints(line)) return;
    state_ = folder_ / "state";
    if (!line.is_resumed) std::filesystem::remove(state_);
    line.options.checkpoints(line.scratch_folder);
  }

  /// Says on the screen how large the folder may get, and where the work begins.
  void announce(std::size_t vertices) const {
    if (folder_.empty()) return;
    if (memory_)
      std::printf(
          "scratch folder %s: about %.2g GB, more if bounds of size ask for more than 4 triangles for each "
          "vertex of the input\n",
          folder_.string().c_str(), bytes_per_vertex * static_cast<double>(vertices) / 1e9);
    if (!state_.empty() && std::filesystem::exists(state_))
      std::printf("going on from %s\n", state_.string().c_str());
    std::fflush(stdout);
  }

  /// Removes what is needed no more when the mesh is written.
  void clean_up() const {
    std::error_code ignored;
    if (!state_.empty()) std::filesystem::remove(state_, ignored);
    if (is_ours_) std::filesystem::remove(folder_, ignored); // if nothing else is in it
  }

private:
  /// Of scratch file and state: measured on maps.
  static constexpr double bytes_per_vertex = 1500;

  std::filesystem::path folder_, state_; // empty: none
  bool is_ours_ = false;
  std::optional<CGAL::Scratch_memory> memory_;

  static bool has_checkpoints(const Command_line& line) {
    return line.mode == Command_line::Mode::PSLG && line.kernel != Command_line::Kernel::EXACT;
  }
};

#endif // QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H
