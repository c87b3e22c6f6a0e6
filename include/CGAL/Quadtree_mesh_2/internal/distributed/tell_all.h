// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// What each part tells all others. O(P) messages of each part, and as many bytes as it has to tell times P.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TELL_ALL_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TELL_ALL_H

#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Tells all parts some bytes. \returns what all have told, this part too, in the order of parts; nothing of those that
/// had nothing to tell
template <class Exchange>
Parcels tell_all_bytes(Exchange& exchange, const Bytes& bytes) {
  Parcels outbox;
  if (!bytes.empty())
    for (int part = 0; part < exchange.size(); ++part) outbox.push_back({part, bytes});
  return exchange.exchange(std::move(outbox));
}

/// The same for records. \returns those of all parts, one after the other
template <class Record, class Exchange>
std::vector<Record> tell_all(Exchange& exchange, const std::vector<Record>& records) {
  std::vector<Record> all;
  for (const Parcel& parcel : tell_all_bytes(exchange, bytes_of(records))) {
    const std::vector<Record> of_part = records_of<Record>(parcel.bytes);
    all.insert(all.end(), of_part.begin(), of_part.end());
  }
  return all;
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_TELL_ALL_H
