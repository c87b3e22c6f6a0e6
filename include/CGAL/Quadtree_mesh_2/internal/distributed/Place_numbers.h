// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Numbers of the vertices of all parts in the order of places.
//
// Computes: of each vertex of each part the number that `renumber_by_place()` gives it in a mesh with the vertices of
//           all parts. The parts sort what they have, cut it so that each part gets a run of the places of all, merge
//           what they get, and send its numbers back.
// Bound:    O(k + m log(P c)) time for k vertices that a part has, and m that it numbers, which come in c pieces from
//           each part, and comparisons of those that share a square of 2^-62 times the whole. m is not much more
//           than n / P + n / 64 of n vertices (agree_on_order.h). With doubles a vertex takes 24 bytes to the part
//           that numbers it, and 8 back. Memory beside what is given, in bytes: 4 k + 24 m while vertices are sent,
//           some at a time, 4 k + 32 m while they are merged, and before that 22 k for the sort, or 44 k where most
//           agree in their first digits.
// Source:   Shi, Schaeffer, "Parallel sorting by regular sampling", JPDC 1992; the shuffle order of Bern, Eppstein,
//           Teng (grid/morton.h).
// Deviates: each part sorts by digits. Runs are merged without being stored: as each is in order, so are the numbers
//           that go back. Vertices that share a square go to one part, however many they are.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PLACE_NUMBERS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PLACE_NUMBERS_H

#include <CGAL/Quadtree_mesh_2/Grid_point_2.h>
#include <CGAL/Quadtree_mesh_2/internal/base/free_memory.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_error.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/agree_on_order.h>
#include <CGAL/Quadtree_mesh_2/internal/geometry/triangle_angles.h>
#include <CGAL/Quadtree_mesh_2/internal/grid/Place_grid.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A vertex whose number is wanted.
template <class Point>
struct Placed_vertex {
  Sent_coordinates<Point> place;
  std::int64_t input_index; ///< -1 for none
  std::uint64_t handle;     ///< tells vertices apart that have no input index; less than 2^63
};

/// What vertices are compared by, as it is sent.
template <class Point>
struct Ranked_place {
  Sent_coordinates<Point> place;
  std::uint64_t rank; ///< the vertices of the input, then the others

  explicit Ranked_place(const Placed_vertex<Point>& v)
      : place(v.place), rank(v.input_index >= 0 ? static_cast<std::uint64_t>(v.input_index)
                                                : std::uint64_t(1) << 63 | v.handle) {}
  /// From bytes.
  explicit Ranked_place(const char* bytes) {
    static_assert(std::is_trivially_copyable_v<Ranked_place>);
    std::memcpy(static_cast<void*>(this), bytes, sizeof *this);
  }

  Grid_point_2<std::uint64_t> square(const Place_grid& grid) const {
    return grid(as_double(place[0]), as_double(place[1]));
  }
  /// The order of those that share a square.
  bool is_before_in_square(const Ranked_place& other) const {
    if (place[0] != other.place[0]) return place[0] < other.place[0];
    if (place[1] != other.place[1]) return place[1] < other.place[1];
    return rank < other.rank;
  }
};

/// Merges runs of vertices, each of which is in order.
template <class Point>
class Place_merger {
public:
  Place_merger(const Place_grid& grid, const Parcels& runs) : grid_(grid), runs_(runs) {}

  /// Calls `f(run)` for each vertex of all runs in order, with the place of its run in the array of runs.
  template <class F>
  void for_each(const F& f) {
    for (std::size_t run = 0; run < runs_.size(); ++run)
      if (!runs_[run].bytes.empty()) push(Head(run, 0, *this));
    while (!heap_.empty()) {
      Head head = pop();
      bool is_in_run = true;
      do { // the vertices of a part are near each other, so that there is seldom another's between them
        f(head.run);
        const std::size_t next = head.at + sizeof(Ranked_place<Point>);
        is_in_run = next < runs_[head.run].bytes.size();
        if (is_in_run) head = Head(head.run, next, *this);
      } while (is_in_run && (heap_.empty() || head.is_before(heap_.front())));
      if (is_in_run) push(head);
    }
  }

private:
  /// The first vertex of a run that has not been reached.
  struct Head {
    std::size_t run, at;
    Ranked_place<Point> vertex;
    Grid_point_2<std::uint64_t> square;

    Head(std::size_t run_, std::size_t at_, const Place_merger& merger)
        : run(run_), at(at_), vertex(merger.runs_[run].bytes.data() + at),
          square(vertex.square(merger.grid_)) {}
    bool is_before(const Head& other) const {
      return square != other.square ? less_shuffle(square, other.square)
                                    : vertex.is_before_in_square(other.vertex);
    }
  };

  static bool is_behind(const Head& a, const Head& b) { return b.is_before(a); }
  void push(const Head& head) {
    heap_.push_back(head);
    std::push_heap(heap_.begin(), heap_.end(), is_behind);
  }
  Head pop() {
    std::pop_heap(heap_.begin(), heap_.end(), is_behind);
    const Head head = heap_.back();
    heap_.pop_back();
    return head;
  }

  const Place_grid& grid_;
  const Parcels& runs_;
  std::vector<Head> heap_; // the least one in front
};

/// See the head of this file.
template <class Exchange, class Point, class Vertex_at>
class Place_numberer {
public:
  /// \param vertex_at the vertices of this part, by index
  /// \param at_a_time how many vertices of a part are on their way at once
  Place_numberer(Exchange& exchange, std::size_t size, const Vertex_at& vertex_at, std::size_t at_a_time)
      : exchange_(exchange), size_(size), vertex_at_(vertex_at), at_a_time_(at_a_time),
        grid_(agree_on_box(exchange, box_of_own())) {}

  std::vector<std::int64_t> numbers() {
    Parcels runs = exchanged_runs(cuts_of_sorted());
    std::size_t bytes = 0;
    for (const Parcel& run : runs) bytes += run.bytes.size();
    const std::int64_t first =
        exchange_.exclusive_scan(static_cast<std::int64_t>(bytes / sizeof(Ranked_place<Point>)));
    Parcels outbox;
    agree_on_work(exchange_, [&] { outbox = numbers_to_send(std::move(runs), first); });
    const Parcels inbox = exchange_.exchange(std::move(outbox));
    std::vector<std::int64_t> result;
    agree_on_work(exchange_, [&] { result = in_order_given(inbox); });
    return result;
  }

private:
  Double_box box_of_own() const {
    Double_box box;
    for (std::size_t i = 0; i < size_; ++i) {
      const Sent_coordinates<Point> place = vertex_at_(i).place;
      box.add(as_double(place[0]), as_double(place[1]));
    }
    return box;
  }

  /// Sorts the vertices. \returns where the run of each part ends
  std::vector<std::size_t> cuts_of_sorted() {
    const auto square_at = [this](std::size_t i) { return vertex(i).square(grid_); };
    const auto less = [this](std::size_t i, std::size_t j) {
      return vertex(i).is_before_in_square(vertex(j));
    };
    Sorted_keys<Grid_point_2<std::uint64_t>> sorted;
    agree_on_work(exchange_, [&] { sorted = sorted_by_place<Sequential_tag>(size_, square_at, less); });
    const std::vector<std::size_t> cuts =
        sampled_cuts(exchange_, size_, [&sorted](std::size_t i) { return sorted.keys[i]; });
    order_ = std::move(sorted.order);
    return cuts;
  }

  /// Sends each part its run, piece by piece. \returns the pieces that this part gets, those of a sender in its order
  Parcels exchanged_runs(const std::vector<std::size_t>& cuts) {
    const auto longest = static_cast<std::size_t>(exchange_.max(static_cast<std::int64_t>(size_)));
    const std::size_t pieces = (longest + at_a_time_ - 1) / at_a_time_;
    Parcels runs;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      Parcels outbox;
      agree_on_work(exchange_, [&] {
        for (std::size_t part = 0, begin = 0; part < cuts.size(); begin = cuts[part++]) {
          const std::size_t length = cuts[part] - begin;
          const std::size_t from = begin + length * piece / pieces,
                            to = begin + length * (piece + 1) / pieces;
          if (from < to) outbox.push_back({static_cast<int>(part), bytes_of_run(from, to)});
        }
      });
      Parcels inbox = exchange_.exchange(std::move(outbox));
      std::move(inbox.begin(), inbox.end(), std::back_inserter(runs));
    }
    return runs;
  }

  Ranked_place<Point> vertex(std::size_t i) const { return Ranked_place<Point>(vertex_at_(i)); }

  Bytes bytes_of_run(std::size_t begin, std::size_t end) const {
    Bytes bytes((end - begin) * sizeof(Ranked_place<Point>));
    for (std::size_t k = begin; k < end; ++k) {
      const Ranked_place<Point> v = vertex(order_[k]);
      std::memcpy(bytes.data() + (k - begin) * sizeof v, &v, sizeof v);
    }
    return bytes;
  }

  /// The numbers of the vertices of each sender, in the order in which it sent them.
  Parcels numbers_to_send(Parcels runs, std::int64_t first) const {
    std::vector<Bytes> numbers(runs.size());
    std::map<int, std::size_t> size_for_sender;
    for (std::size_t run = 0; run < runs.size(); ++run) {
      const std::size_t size = runs[run].bytes.size() / sizeof(Ranked_place<Point>) * sizeof first;
      numbers[run].reserve(size), size_for_sender[runs[run].part] += size;
    }
    Place_merger<Point>(grid_, runs).for_each([&](std::size_t run) {
      append_bytes(numbers[run], &first, sizeof first);
      ++first;
    });
    for (Parcel& run : runs) free_arrays(run.bytes);
    Parcels outbox;
    for (const auto& [part, size] : size_for_sender) {
      outbox.push_back({part, Bytes()});
      Bytes& all = outbox.back().bytes;
      all.reserve(size);
      for (std::size_t run = 0; run < runs.size(); ++run) {
        if (runs[run].part != part) continue;
        append_bytes(all, numbers[run].data(), numbers[run].size());
        free_arrays(numbers[run]);
      }
    }
    return outbox;
  }

  /// \param numbers of the vertices as they were sent: those of lower parts come before in the order of places
  std::vector<std::int64_t> in_order_given(const Parcels& numbers) const {
    std::vector<std::int64_t> result(order_.size());
    auto i = order_.begin();
    for (const Parcel& of_part : numbers)
      for (std::size_t at = 0; at < of_part.bytes.size(); at += sizeof(std::int64_t))
        std::memcpy(&result[*i++], of_part.bytes.data() + at, sizeof(std::int64_t));
    return result;
  }

  Exchange& exchange_;
  std::size_t size_; // how many vertices this part has
  const Vertex_at& vertex_at_;
  const std::size_t at_a_time_;
  const Place_grid grid_;
  Order order_; // of own vertices by places
};

/// Computes, for the vertices that all parts have, numbers in the order of places: of each of this part's, in the order
/// given. Numbers begin at 0 and are those that `renumber_by_place()` gives to a mesh with all of these vertices, of
/// which those with no input index are in the order of their handles. All parts call it.
/// \param size how many vertices this part gives
/// \param vertex_at the `Placed_vertex<Point>` of an index below that; called more than once
/// \param at_a_time how many vertices of a part are on their way at once
/// \pre each vertex is given by one part only, and this part gives less than 2^32
template <class Point, class Exchange, class Vertex_at>
std::vector<std::int64_t> numbers_by_place(Exchange& exchange, std::size_t size, const Vertex_at& vertex_at,
                                           std::size_t at_a_time = std::size_t(1) << 16) {
  return Place_numberer<Exchange, Point, Vertex_at>(exchange, size, vertex_at, at_a_time).numbers();
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_DISTRIBUTED_PLACE_NUMBERS_H
