#ifndef QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H
#define QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H

// What quality_mesh does for meshes that are larger than memory, or take long: arrays in a scratch folder, and a state
// to go on from.

#include "Resume_hint.h"
#include "Scratch_folder.h"
#include "command_line.h"

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_checkpoints.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Folder_lock.h>
#include <CGAL/Scratch_memory.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>

class Large_run {
public:
  /// Begins what the command line asks for: a scratch memory, and checkpoints in the options.
  /// \throws std::exception naming the scratch folder if it cannot be used
  explicit Large_run(Command_line& line) : folder_(line) {
    if (folder_.name().empty()) return;
    lock_.emplace(folder_.name());
    if (line.memory > 0) memory_.emplace(folder_.name(), line.memory);
    if (!has_checkpoints(line)) return;
    line.options.checkpoints(folder_.name(), digest_of_sizes(line));
    checkpoints_.emplace(folder_.name(), 0);
    hint_.emplace(checkpoints_->file_name());
    is_resumed_ = line.is_resumed;
  }

  /// Once the input is read: forgets a state from which the work is not to go on, and says on the screen where it
  /// begins, and how large the folder may get.
  void begin(std::size_t vertices, bool is_quiet) const {
    if (checkpoints_ && !is_resumed_) checkpoints_->remove();
    if (is_quiet) return;
    if (memory_)
      std::printf(
          "scratch folder %s: about %.2g GB, more if bounds of size ask for more than 4 triangles for each "
          "vertex of the input\n",
          folder_.name().c_str(), bytes_per_vertex * static_cast<double>(vertices) / 1e9);
    if (checkpoints_ && checkpoints_->has_state())
      std::printf("going on from %s, if it is of this mesh\n", checkpoints_->file_name().c_str());
    else if (is_resumed_)
      std::printf("no state in %s: beginning at the start\n", folder_.name().c_str());
    std::fflush(stdout);
  }

  /// Removes what is needed no more when the mesh is written.
  void clean_up() const {
    if (checkpoints_) checkpoints_->remove();
  }

private:
  /// Of scratch file and state: measured on maps.
  static constexpr double bytes_per_vertex = 1000;

  Scratch_folder folder_; // the first member: it goes last
  bool is_resumed_ = false;
  std::optional<CGAL::Quadtree_mesh_2::internal::Folder_lock> lock_;
  std::optional<CGAL::Scratch_memory> memory_;
  std::optional<CGAL::Quadtree_mesh_2::internal::Mesh_checkpoints> checkpoints_;
  std::optional<Resume_hint> hint_;

  static bool has_checkpoints(const Command_line& line) {
    return line.mode == Command_line::Mode::PSLG && line.kernel != Command_line::Kernel::EXACT &&
           line.options.separate() == CGAL::Quality_mesh_options_2::Separation::ON_DEMAND;
  }

  /// What sizes come from, as a number.
  static std::uint64_t digest_of_sizes(const Command_line& line) {
    CGAL::Quadtree_mesh_2::internal::Digest digest;
    for (const std::string& file_name : {line.size_points_file, line.size_grid_file}) {
      std::string text;
      if (!file_name.empty()) {
        std::ifstream in(file_name, std::ios::binary);
        text.assign(std::istreambuf_iterator<char>(in), {});
      }
      digest.add(text.size()), digest.add(text.data(), text.size());
    }
    digest.add(line.gradation);
    if (line.feature_sizes) digest.add(line.feature_sizes->size), digest.add(line.feature_sizes->gradation);
    return digest.value();
  }
};

#endif // QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H
