// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_STREAMING_QUALITY_MESHER_2_H
#define CGAL_STREAMING_QUALITY_MESHER_2_H

#include <CGAL/Filtered_quadtree_traits_2.h>
#ifdef CGAL_LINKED_WITH_HDF5
#include <CGAL/IO/HDF5.h>
#endif
#include <CGAL/IO/MSH.h>
#include <CGAL/IO/Triangle_files.h>
#include <CGAL/IO/VTU.h>
#include <CGAL/Indexed_mesh_2.h>
#include <CGAL/Pslg_2.h>
#include <CGAL/Quadtree_mesh_2/Quality_mesher_2.h>
#include <CGAL/Quadtree_mesh_2/internal/Mesh_checkpoints.h>
#include <CGAL/Quadtree_mesh_2/internal/base/Folder_lock.h>
#include <CGAL/Quality_mesh_options_2.h>
#include <CGAL/Quality_mesh_report_2.h>
#include <CGAL/Scratch_memory.h>
#include <CGAL/renumber_mesh_2.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgQuadtreeMesh2Meshers
/// Where `Streaming_quality_mesher_2` keeps what is not in memory, and how much is.
struct Streaming_options_2 {
  /// A folder, made if need be, on a disk with some 250 bytes of room for each triangle. It also gets the state
  /// from which interrupted work goes on, 50 bytes for each triangle.
  std::string scratch_folder;
  /// How many bytes of memory the process may have: `Scratch_memory`.
  std::size_t memory = std::size_t(1) << 31;
  /// Whether the mesh is put into the order of places before it is written: `renumber_by_place()`.
  bool is_renumbered = false;
  /// The number of pieces of a .pvtu file, 0 for one for each 2^20 triangles. Unless it is 0, a .msh file is written in
  /// so many parts.
  std::size_t pieces = 0;
};

/// \ingroup PkgQuadtreeMesh2Meshers
/// Meshes a graph in a file that may be larger than memory, and writes the mesh to files.
///
/// The mesh has the same bits as that of `Quality_mesher_2`. If the work is interrupted in any way, the next run with
/// the same files and options goes on from its last state, and gives the same bytes. The state is removed when the mesh
/// is written. On Linux only. The input and the mesh are out of memory, too, if one source file of the program includes
/// `CGAL/Quadtree_mesh_2/new_in_scratch_memory.h`; else the process has them in memory besides the limit.
/// \tparam Traits as of `Quality_mesher_2`, over doubles or integers
/// \tparam ConcurrencyTag `Sequential_tag` or `Parallel_tag`; the mesh is the same for any number of threads
template <class Traits = Filtered_quadtree_traits_2<>, class ConcurrencyTag = Sequential_tag>
class Streaming_quality_mesher_2 {
public:
  using Point_2 = typename Traits::Point_2; ///< of the graph and the mesh

  /// A mesher with these options.
  /// \throws std::invalid_argument if an option is out of its range, or there is no scratch folder
  Streaming_quality_mesher_2(Quality_mesh_options_2 options, Streaming_options_2 streaming,
                             const Traits& traits = Traits())
      : streaming_(std::move(streaming)), mesher_(options.checkpoints(streaming_.scratch_folder), traits) {
    if (streaming_.scratch_folder.empty()) throw std::invalid_argument("streaming needs a scratch folder");
  }

  /// Meshes the domain of a graph.
  /// \param input a .poly file of Triangle, which may be compressed (.gz); or, if the program links HDF5 and defines
  /// `CGAL_LINKED_WITH_HDF5`, a file of HDF5 that ends in .h5
  /// \param output a name that ends in .ele (which writes .node, .ele and .poly), .vtu, .pvtu (with pieces) or .msh;
  /// or, with HDF5, in .vtkhdf or .xdmf (with .h5)
  /// \throws Pslg_error_2 for input that cannot be meshed
  /// \throws Quadtree_mesh_2::Scratch_full if the disk of the scratch folder has no more room. What was done is kept.
  /// \throws std::system_error, std::runtime_error naming a file that cannot be read or written
  /// \throws std::invalid_argument for an output with another ending, in no folder, or in place of the input
  const Quality_mesh_report_2& operator()(const std::string& input, const std::string& output) {
    namespace fs = std::filesystem;
    const std::string ending = fs::path(output).extension().string();
    check_names(input, output, ending);
    fs::create_directories(streaming_.scratch_folder);
    const Quadtree_mesh_2::internal::Folder_lock lock(streaming_.scratch_folder);
    const Scratch_memory memory(streaming_.scratch_folder, streaming_.memory);
    const Pslg_2<Point_2> pslg = read(input);
    Indexed_mesh_2<Point_2> mesh = mesher_(pslg);
    report_ = mesher_.report();
    if (streaming_.is_renumbered) renumber_by_place<ConcurrencyTag>(mesh).renumber(report_);
    write(output, ending, mesh, pslg);
    if (mesher_.options().separate() == Quality_mesh_options_2::Separation::ON_DEMAND)
      Quadtree_mesh_2::internal::Mesh_checkpoints(streaming_.scratch_folder, 0).remove();
    return report_;
  }

  /// What the last run reached.
  const Quality_mesh_report_2& report() const { return report_; }

private:
  Streaming_options_2 streaming_;
  Quality_mesher_2<Traits, ConcurrencyTag> mesher_;
  Quality_mesh_report_2 report_;

  static Pslg_2<Point_2> read(const std::string& input) {
    Pslg_2<Point_2> pslg;
#ifdef CGAL_LINKED_WITH_HDF5
    if (std::filesystem::path(input).extension() == ".h5") return IO::read_HDF5(input, pslg), pslg;
#endif
    IO::read_triangle_poly(input, pslg);
    return pslg;
  }

  void write(const std::string& output, const std::string& ending, const Indexed_mesh_2<Point_2>& mesh,
             const Pslg_2<Point_2>& pslg) const {
    if (ending == ".ele") {
      IO::write_triangle_files(mesh, pslg, std::filesystem::path(output).replace_extension().string());
    } else if (ending == ".vtu") {
      IO::write_VTU(output, mesh, pslg);
    } else if (ending == ".pvtu") {
      IO::write_PVTU(output, mesh, pslg, streaming_.pieces);
#ifdef CGAL_LINKED_WITH_HDF5
    } else if (ending == ".vtkhdf") {
      IO::write_VTKHDF(output, mesh, pslg);
    } else if (ending == ".xdmf") {
      IO::write_XDMF(output, mesh, pslg);
#endif
    } else if (streaming_.pieces > 0) {
      IO::write_MSH_parts(output, mesh, pslg, streaming_.pieces);
    } else {
      IO::write_MSH(output, mesh, pslg);
    }
  }

  /// What output may end in, with the endings of the files that it consists of.
  static const std::map<std::string, std::vector<const char*>>& endings() {
    static const std::map<std::string, std::vector<const char*>> all = {{".ele", {".node", ".ele", ".poly"}},
                                                                        {".msh", {}},
                                                                        {".pvtu", {}},
#ifdef CGAL_LINKED_WITH_HDF5
                                                                        {".vtkhdf", {}},
                                                                        {".xdmf", {".h5"}},
#endif
                                                                        {".vtu", {}}};
    return all;
  }

  /// Before any work: that the output can be written, and is not the input.
  static void check_names(const std::string& input, const std::string& output, const std::string& ending) {
    namespace fs = std::filesystem;
    const auto found = endings().find(ending);
    if (found == endings().end()) {
      std::string all;
      for (const auto& [other, files] : endings()) all += ' ' + other;
      throw std::invalid_argument(output + ": the ending has to be one of" + all);
    }
    const fs::path folder = fs::absolute(output).parent_path();
    if (!fs::is_directory(folder))
      throw std::invalid_argument(output + ": there is no folder " + folder.string());
    std::error_code ignored;
    for (const char* other : found->second)
      if (fs::equivalent(input, fs::path(output).replace_extension(other), ignored))
        throw std::invalid_argument(output + ": would overwrite the input " + input);
  }
};

} // namespace CGAL

#endif // CGAL_STREAMING_QUALITY_MESHER_2_H
