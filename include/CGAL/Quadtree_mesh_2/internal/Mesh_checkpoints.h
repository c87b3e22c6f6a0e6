// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// The state of a mesh in the making, kept in a folder, so that work goes on there after it was interrupted.
//
// There is one state at a time, in a file that names the input and the options it belongs to (Checkpoint_file.h). The
// first one is saved at once, and others when they take a tenth of the time since the one before, or less.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_CHECKPOINTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_CHECKPOINTS_H

#include <CGAL/Quadtree_mesh_2/internal/base/Checkpoint_file.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// After how many times as long as it took to save a state another one is saved. Specialized by tests.
template <class ConcurrencyTag>
struct Checkpoint_pace {
  static constexpr int time_between = 10;
};

class Mesh_checkpoints {
public:
  /// \param folder empty: none are wanted
  /// \param time_between two states, in times as long as it took to save the first
  Mesh_checkpoints(std::string folder, int time_between)
      : folder_(std::move(folder)), time_between_(time_between) {}

  bool are_wanted() const { return !folder_.empty(); }
  /// Whether there is a state to go on from.
  bool has_state() const { return are_wanted() && std::filesystem::exists(file_name()); }
  std::string file_name() const {
    return (std::filesystem::path(folder_) / "quadtree_mesh_2.state").string();
  }

  /// Removes the state, and what is left of one that was not completed.
  /// \throws std::runtime_error naming a file in its place that is none
  void remove() const {
    if (!has_state()) return;
    Head head{0};
    std::ifstream in(file_name(), std::ios::binary);
    in.read(reinterpret_cast<char*>(&head), sizeof head);
    if (!in || !head.is_of_state())
      throw std::runtime_error(file_name() + ": this is not the state of a mesh, and stays");
    std::error_code ignored;
    std::filesystem::remove(file_name(), ignored);
    std::filesystem::remove(file_name() + ".part", ignored);
  }

  /// Says what the state is of. To be called before it is saved or loaded.
  void set_origin(const Digest& input_and_options) { origin_ = input_and_options.value(); }

  /// \param transfer called with an archive, for all there is to write
  /// \throws std::system_error if the file cannot be written
  template <class Transfer>
  void save_if_due(const Transfer& transfer) {
    if (!are_wanted() || Clock::now() < next_) return;
    const Clock::time_point begin = Clock::now();
    std::filesystem::create_directories(folder_);
    Checkpoint_writer file(file_name());
    Head head{origin_};
    file(head);
    transfer(file);
    file.commit();
    const Clock::time_point end = Clock::now();
    next_ = end + time_between_ * (end - begin);
  }

  /// \throws std::runtime_error if the file cannot be read, is damaged or belongs to another mesh
  template <class Transfer>
  void load(const Transfer& transfer) const {
    Checkpoint_reader file(file_name());
    Head head{0};
    file(head);
    if (!head.is_of_state()) throw std::runtime_error(file_name() + ": this is not the state of a mesh");
    if (head.version != Head(0).version)
      throw std::runtime_error(file_name() +
                               ": the state is of another version: begin anew, or go on with that");
    if (head.origin != origin_)
      throw std::runtime_error(file_name() + ": the state is of another input, or of other options");
    transfer(file);
    file.check();
  }

private:
  using Clock = std::chrono::steady_clock;

  struct Head {
    explicit Head(std::uint64_t o) : origin(o) {}
    bool is_of_state() const { return magic == Head(0).magic; }

    std::uint32_t magic = 0x516d5374;
    /// To be raised when the file has something else, or refinement goes on differently.
    std::uint32_t version = 6;
    std::uint64_t origin;
  };

  std::string folder_;
  int time_between_;
  std::uint64_t origin_ = 0;
  Clock::time_point next_{};
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_CHECKPOINTS_H
