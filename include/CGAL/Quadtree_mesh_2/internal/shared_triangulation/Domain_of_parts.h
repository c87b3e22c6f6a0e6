// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Restricts a first triangulation in parts (Triangulation_of_parts.h) to the domain, as Domain_rule.h does in one
// memory.
//
// Computes: the triangles that are kept, with the handles of Kept_triangles.h; their regions; and the triangles outside
//           along the border, once flat ones are flipped.
// Bound:    O(t) for the t triangles of a part, and messages for triangles at seams. Part 0 gets some words for each
//           piece of a component in a part, and for each pair of pieces next to each other; and flat triangles
//           (Flat_triangles_of_parts.h).
// Method:   Each part floods its pieces of the components. Part 0 decides (Component_levels.h), and tells each part.
// Source:   ours.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_DOMAIN_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_DOMAIN_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Mesh_archive.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/Parcel.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Component_levels.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Flat_triangles_of_parts.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Part_triangles.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_triangulation/Seed_finder.h>
#include <CGAL/Quadtree_mesh_2/internal/triangulation/Domain_rule.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Exchange, class Geometry>
class Domain_of_parts {
public:
  using Part = Part_triangles<Geometry>;
  using Rule = Quality_mesh_options_2::Domain;

  /// \param part whose triangles become those that are kept
  /// \param first_auxiliary vertices from it on are outside whatever the rule
  Domain_of_parts(Exchange& exchange, Part& part, Vertex_id first_auxiliary)
      : exchange_(exchange), part_(part), first_auxiliary_(first_auxiliary) {}

  /// All parts call it.
  /// \param holes, regions what this part's triangles hold
  /// \param point_of gives the places of vertices
  /// \returns false, at all parts, if no part knows a triangle that holds one of the points
  template <class Point_of>
  bool run(Rule rule, const Seeds_found& holes, const Seeds_found& regions, const Point_of& point_of) {
    Seam_sides<Geometry> seams(part_);
    find_pieces();
    const auto labels = labels_of_pieces(rule, holes, regions, seams);
    if (!labels) return false;
    label_.resize(part_.size()), is_kept_.resize(part_.size());
    for (std::size_t i = 0; i < part_.size(); ++i)
      label_[i] = (*labels)[piece_[i]], is_kept_[i] = label_[i] != PIECE_NOT_KEPT;
    piece_ = {};
    name_kept();
    seams.tell(exchange_, [this](std::size_t i) { return new_name_[i]; });
    find_outer(seams, Flat_triangles_of_parts<Exchange, Geometry>(exchange_, part_, is_kept_)
                          .run(point_of, first_auxiliary_));
    keep(seams);
    return true;
  }

  /// Of this part's triangles; that of none is invalid.
  const std::vector<Region_id>& regions() const { return regions_; }
  /// The triangles outside along the border, at part 0.
  std::vector<Outer_triangle> take_outer() { return std::move(outer_); }

private:
  static constexpr std::uint32_t none_ = 0xffffffffu;

  Exchange& exchange_;
  Part& part_;
  Vertex_id first_auxiliary_;
  std::vector<std::uint32_t> piece_; // of each triangle
  std::size_t number_of_pieces_ = 0;
  std::vector<std::uint32_t> label_;
  std::vector<char> is_kept_;
  std::vector<std::uint32_t> new_name_; // of all parts; none of those that are not kept
  std::vector<Region_id> regions_;
  std::vector<Outer_triangle> outer_;

  // ---- components

  /// Floods the pieces of components in this part.
  void find_pieces() {
    piece_.assign(part_.size(), none_);
    std::vector<std::size_t> stack;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      if (piece_[i] != none_) continue;
      const auto piece = static_cast<std::uint32_t>(number_of_pieces_++);
      piece_[i] = piece;
      for (stack.push_back(i); !stack.empty();) {
        const std::size_t t = stack.back();
        stack.pop_back();
        for (const Side o : part_.triangles[t].side) {
          if (o.is_constrained() || !part_.has(o.triangle())) continue; // the border, too, is constrained
          std::uint32_t& other = piece_[part_.place(o.triangle())];
          if (other == none_) other = piece, stack.push_back(part_.place(o.triangle()));
        }
      }
    }
  }

  /// What becomes of this part's pieces, as part 0 decides.
  std::optional<std::vector<std::uint32_t>> labels_of_pieces(Rule rule, const Seeds_found& holes,
                                                             const Seeds_found& regions,
                                                             Seam_sides<Geometry>& seams) {
    const auto number = static_cast<std::int64_t>(number_of_pieces_);
    const auto first = static_cast<std::uint32_t>(exchange_.exclusive_scan(number));
    const Numbers numbers = exchange_.gather(number);
    seams.tell(exchange_, [&](std::size_t i) { return first + piece_[i]; });
    Archive_writer archive;
    transfer(archive, graph_of_pieces(first, holes.held, regions.held, seams));
    Parcels outbox;
    outbox.push_back({0, std::move(archive.bytes)});
    Component_graph all;
    for (const Parcel& parcel : exchange_.exchange(std::move(outbox))) add(parcel.bytes, all);
    const bool is_known =
        exchange_.rank() != 0 || (are_all_held(all.holes, holes) && are_all_held(all.regions, regions));
    if (exchange_.min(is_known ? 1 : 0) == 0) return std::nullopt;
    return share_out(labels_of_all(rule, std::move(all), numbers), numbers);
  }

  Component_graph graph_of_pieces(std::uint32_t first, const std::vector<Seed_holder>& holes,
                                  const std::vector<Seed_holder>& regions,
                                  const Seam_sides<Geometry>& seams) const {
    Component_graph graph;
    Pairs joined(graph.joined), beside(graph.beside);
    for (const auto& [i, k, other] : seams.sides())
      (part_.triangles[i].side[k].is_constrained() ? beside : joined).add(first + piece_[i], other);
    for (std::size_t i = 0; i < part_.size(); ++i) {
      const auto& r = part_.triangles[i];
      for (const Side o : r.side)
        if (!o.is_border() && o.is_constrained() && part_.has(o.triangle()))
          beside.add(first + piece_[i], first + piece_[part_.place(o.triangle())]);
      if (std::any_of(r.v, r.v + 3, [this](Vertex_id v) { return !(v < first_auxiliary_); }))
        graph.outside.push_back(first + piece_[i]);
    }
    sort_and_drop_equal(graph.joined), sort_and_drop_equal(graph.beside), sort_and_drop_equal(graph.outside);
    for (const auto& [number, place] : holes) graph.holes.push_back({number, first + piece_[place]});
    for (const auto& [number, place] : regions) graph.regions.push_back({number, first + piece_[place]});
    return graph;
  }

  static bool are_all_held(const std::vector<Component_graph::Seed>& seeds, const Seeds_found& found) {
    std::vector<char> is_open(found.is_beyond.size());
    for (std::size_t i = 0; i < is_open.size(); ++i) is_open[i] = found.is_beyond[i] == 0 ? 1 : 0;
    for (const auto& seed : seeds) is_open[seed.number] = 0;
    return std::count(is_open.begin(), is_open.end(), 1) == 0;
  }

  /// Pairs of pieces, each once in the end. Along a segment the same ones come again and again.
  class Pairs {
  public:
    explicit Pairs(std::vector<Component_graph::Pair>& pairs) : pairs_(pairs) {}

    void add(std::uint32_t a, std::uint32_t b) {
      const Component_graph::Pair pair(std::min(a, b), std::max(a, b));
      if (a == b || (!pairs_.empty() && pairs_.back() == pair)) return;
      pairs_.push_back(pair);
      if (pairs_.size() < most_) return;
      sort_and_drop_equal(pairs_);
      most_ = std::max(most_, 2 * pairs_.size());
    }

  private:
    std::vector<Component_graph::Pair>& pairs_;
    std::size_t most_ = std::size_t(1) << 16; // before they are sorted again
  };

  template <class Archive, class Graph>
  static void transfer(Archive& archive, Graph&& graph) {
    archive(graph.joined), archive(graph.beside), archive(graph.outside);
    archive(graph.holes), archive(graph.regions);
  }
  static void add(const Bytes& bytes, Component_graph& all) {
    Archive_reader archive(bytes);
    Component_graph graph;
    transfer(archive, graph);
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(all.joined, graph.joined), append(all.beside, graph.beside), append(all.outside, graph.outside);
    append(all.holes, graph.holes), append(all.regions, graph.regions);
  }

  /// At part 0; nothing elsewhere.
  std::vector<std::uint32_t> labels_of_all(Rule rule, Component_graph all, const Numbers& numbers) const {
    if (exchange_.rank() != 0) return {};
    std::int64_t sum = 0;
    for (const std::int64_t number : numbers) sum += number;
    return Component_levels(static_cast<std::size_t>(sum), std::move(all)).labels(rule);
  }

  std::vector<std::uint32_t> share_out(const std::vector<std::uint32_t>& labels, const Numbers& numbers) {
    Records_of_parts<std::uint32_t> outbox;
    auto begin = labels.begin();
    for (std::size_t part = 0; part < numbers.size() && !labels.empty(); ++part) {
      const auto end = begin + static_cast<std::ptrdiff_t>(numbers[part]);
      outbox[static_cast<int>(part)].assign(begin, end);
      begin = end;
    }
    return exchange_and_join(exchange_, std::move(outbox));
  }

  // ---- what is kept

  /// Names the triangles that are kept, in the order of all parts.
  void name_kept() {
    const auto number = static_cast<std::int64_t>(std::count(is_kept_.begin(), is_kept_.end(), 1));
    auto next = static_cast<std::uint32_t>(exchange_.exclusive_scan(number));
    new_name_.resize(part_.size());
    for (std::size_t i = 0; i < part_.size(); ++i) new_name_[i] = is_kept_[i] != 0 ? next++ : none_;
  }

  /// Where what is across a side goes; none if it is not kept, or if nothing is there.
  std::uint32_t new_name(const Seam_sides<Geometry>& seams, std::size_t& next_seam, std::size_t i,
                         int k) const {
    const Side o = part_.triangles[i].side[k];
    if (o.is_border()) return none_;
    if (part_.has(o.triangle())) return new_name_[part_.place(o.triangle())];
    return seams.sides()[next_seam++].told; // in the same order
  }

  /// Part 0 gets the triangles outside along the border of all parts.
  /// \param seen what sees sides after flips, by their ends in order
  void find_outer(const Seam_sides<Geometry>& seams, const std::vector<Outer_triangle>& seen) {
    std::vector<Outer_triangle> own;
    std::size_t next_seam = 0;
    for (std::size_t i = 0; i < part_.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const bool is_other_kept = new_name(seams, next_seam, i, k) != none_;
        const auto& v = part_.triangles[i].v;
        if (is_kept_[i] == 0 && is_other_kept) own.push_back({v[next_slot[k]], v[previous_slot[k]], v[k]});
      }
    Records_of_parts<Outer_triangle> outbox;
    outbox[0] = std::move(own);
    outer_ = exchange_and_join(exchange_, std::move(outbox));
    const auto is_before = Chosen_triangles<Geometry>::is_before;
    for (Outer_triangle& o : outer_) {
      const auto found = std::lower_bound(seen.begin(), seen.end(), o, is_before);
      if (found != seen.end() && !is_before(o, *found)) o.apex = found->apex;
    }
    outer_.erase(std::remove_if(outer_.begin(), outer_.end(),
                                [this](const Outer_triangle& o) { return !(o.apex < first_auxiliary_); }),
                 outer_.end());
  }

  /// Drops all other triangles.
  void keep(const Seam_sides<Geometry>& seams) {
    std::size_t next_seam = 0, size = 0;
    for (std::size_t i = 0; i < part_.size(); ++i) {
      auto triangle = part_.triangles[i];
      for (int k = 0; k < 3; ++k) {
        const std::uint32_t name = new_name(seams, next_seam, i, k);
        triangle.side[k] = name == none_ ? Side::border() : triangle.side[k].renamed(Triangle_id(name));
      }
      if (is_kept_[i] == 0) continue;
      regions_.push_back(label_[i] == PIECE_WITHOUT_REGION ? Region_id() : Region_id(label_[i]));
      part_.triangles[size++] = triangle;
    }
    part_.triangles.resize(size);
    part_.begin = static_cast<std::size_t>(exchange_.exclusive_scan(static_cast<std::int64_t>(size)));
    part_.first = exchange_.gather(static_cast<std::int64_t>(part_.begin));
    part_.first.push_back(exchange_.sum(static_cast<std::int64_t>(size)));
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_TRIANGULATION_DOMAIN_OF_PARTS_H
