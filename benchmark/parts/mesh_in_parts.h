// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Meshes of graphs, with what parts of them would send each other.

#ifndef QUADTREE_MESH_2_BENCHMARK_MESH_IN_PARTS_H
#define QUADTREE_MESH_2_BENCHMARK_MESH_IN_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/parts/Part_ledger.h>
#include <CGAL/Quality_mesher_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

struct Mesh_in_parts {
  using Traits = CGAL::Filtered_quadtree_traits_2<>;
  using Ledger = CGAL::Quadtree_mesh_2::internal::Part_ledger;

  CGAL::Indexed_mesh_2<Traits::Point_2> mesh;
  CGAL::Quality_mesh_report_2 report;
  Ledger ledger;
};

/// The mesh that `Quality_mesher_2` makes. \pre there is at least one part
template <class ConcurrencyTag>
Mesh_in_parts mesh_in_parts(const CGAL::Pslg_2<Mesh_in_parts::Traits::Point_2>& pslg,
                            const CGAL::Quality_mesh_options_2& options, std::size_t parts) {
  namespace internal = CGAL::Quadtree_mesh_2::internal;
  using Pipeline = internal::Mesh_pipeline<Mesh_in_parts::Traits, internal::Inner_tag<ConcurrencyTag>,
                                           internal::Part_ledger>;
  const internal::Concurrency_scope scope{ConcurrencyTag()};
  const Mesh_in_parts::Traits traits;
  CGAL::Quality_mesh_report_2 report;
  Pipeline pipeline(pslg, options, traits, nullptr, report, internal::Part_ledger(parts));
  auto mesh = pipeline.run();
  return {std::move(mesh), report, pipeline.watch()};
}

/// What the ledger of a run comes to.
struct Part_counts {
  std::size_t rounds = 0;
  double mean_messages = 0, mean_bytes = 0; ///< sent by a part
  std::size_t most_messages = 0, most_bytes = 0;
  std::size_t most_triangles = 0, most_vertices = 0; ///< that a part holds at any time
  double share_worked_on_again = 0; ///< triangles in blocks after round 1, of those at the end
};

inline Part_counts counts_of(const Mesh_in_parts::Ledger& ledger) {
  Part_counts counts;
  const auto sent = ledger.exchange().sent();
  const double parts = static_cast<double>(sent.size());
  for (const auto& traffic : sent) {
    counts.mean_messages += static_cast<double>(traffic.messages) / parts;
    counts.mean_bytes += static_cast<double>(traffic.bytes) / parts;
    counts.most_messages = std::max(counts.most_messages, traffic.messages);
    counts.most_bytes = std::max(counts.most_bytes, traffic.bytes);
  }
  counts.rounds = ledger.rounds().size();
  std::size_t again = 0, triangles = 0;
  for (const auto& round : ledger.rounds()) {
    if (&round != &ledger.rounds().front()) again += round.triangles_worked_on;
    for (const auto* holdings : {&round.before_work, &round.after})
      for (const auto& held : *holdings) {
        counts.most_triangles = std::max(counts.most_triangles, held.triangles);
        counts.most_vertices = std::max(counts.most_vertices, held.vertices);
      }
  }
  if (counts.rounds == 0) return counts;
  for (const auto& held : ledger.rounds().back().after) triangles += held.triangles;
  counts.share_worked_on_again = static_cast<double>(again) / static_cast<double>(triangles);
  return counts;
}

#endif // QUADTREE_MESH_2_BENCHMARK_MESH_IN_PARTS_H
