#ifndef QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H
#define QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H

// What quality_mesh does for meshes that are larger than memory, or take long: arrays in a scratch folder, and a state
// to go on from.

#include "command_line.h"

#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_checkpoints.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Folder_lock.h>
#include <CGAL/Scratch_memory.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

class Large_run {
public:
  /// Begins what the command line asks for: a scratch memory, and checkpoints in the options.
  /// \throws std::exception naming the scratch folder if it cannot be used
  explicit Large_run(Command_line& line) : folder_(line.scratch_folder) {
    if (folder_.empty()) return;
    make_folder();
    is_ours_ |= line.is_scratch_folder_ours;
    lock_.emplace(folder_);
    if (line.memory > 0) memory_.emplace(folder_, line.memory);
    if (!has_checkpoints(line)) return;
    line.options.checkpoints(folder_, digest_of(line.size_points_file));
    checkpoints_.emplace(folder_, 0);
    is_resumed_ = line.is_resumed;
  }
  Large_run(const Large_run&) = delete;
  Large_run& operator=(const Large_run&) = delete;
  ~Large_run() {
    memory_.reset();
    std::error_code ignored;
    if (is_ours_) std::filesystem::remove(folder_, ignored); // if nothing is in it
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
          folder_.c_str(), bytes_per_vertex * static_cast<double>(vertices) / 1e9);
    if (checkpoints_ && checkpoints_->has_state())
      std::printf("going on from %s\n", checkpoints_->file_name().c_str());
    else if (is_resumed_)
      std::printf("no state in %s: beginning at the start\n", folder_.c_str());
    std::fflush(stdout);
  }

  /// Removes what is needed no more when the mesh is written.
  void clean_up() const {
    if (checkpoints_) checkpoints_->remove();
  }

private:
  /// Of scratch file and state: measured on maps.
  static constexpr double bytes_per_vertex = 1000;

  std::string folder_;   // empty: none
  bool is_ours_ = false; // nobody else has use for it
  bool is_resumed_ = false;
  std::optional<CGAL::Quadtree_mesh_2::internal::Folder_lock> lock_;
  std::optional<CGAL::Scratch_memory> memory_;
  std::optional<CGAL::Quadtree_mesh_2::internal::Mesh_checkpoints> checkpoints_;

  void make_folder() {
    std::error_code error;
    is_ours_ = std::filesystem::create_directories(folder_, error);
    if (error || !std::filesystem::is_directory(folder_))
      throw std::runtime_error("the scratch folder '" + folder_ +
                               "' cannot be made: name another one by --scratch");
  }

  static bool has_checkpoints(const Command_line& line) {
    return line.mode == Command_line::Mode::PSLG && line.kernel != Command_line::Kernel::EXACT &&
           line.options.separate() == CGAL::Quality_mesh_options_2::Separation::ON_DEMAND;
  }

  /// What is in a file, as a number; 0 if there is none.
  static std::uint64_t digest_of(const std::string& file_name) {
    if (file_name.empty()) return 0;
    std::ifstream in(file_name, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(in), {});
    CGAL::Quadtree_mesh_2::internal::Digest digest;
    digest.add(text.data(), text.size());
    return digest.value();
  }
};

#endif // QUADTREE_MESH_2_EXAMPLES_LARGE_RUN_H
