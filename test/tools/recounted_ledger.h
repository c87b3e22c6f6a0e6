// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_RECOUNTED_LEDGER_H
#define QUADTREE_MESH_2_TEST_RECOUNTED_LEDGER_H

#include "catch.h"

#include <CGAL/Quadtree_mesh_2/internal/parts/Part_ledger.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

/// A ledger that checks itself by brute force: it keeps owners in a map, and counts each message from the side of who
/// receives it.
class Recounted_ledger : public CGAL::Quadtree_mesh_2::internal::Part_ledger {
  using Base = CGAL::Quadtree_mesh_2::internal::Part_ledger;
  using Triangle_id = CGAL::Quadtree_mesh_2::internal::Triangle_id;
  using Vertex_id = CGAL::Quadtree_mesh_2::internal::Vertex_id;
  using Corner_id = CGAL::Quadtree_mesh_2::internal::Corner_id;
  using Part_id = CGAL::Quadtree_mesh_2::internal::Part_id;
  using Side = CGAL::Quadtree_mesh_2::internal::Side;
  using Kind = CGAL::Quadtree_mesh_2::internal::Superstep_kind;

  static constexpr std::size_t triangle_bytes = 56, vertex_bytes = 32;

  /// Bytes by who sends them and who gets them.
  struct Mail {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> bytes;
    void add(std::size_t from, std::size_t to, std::size_t n) {
      if (from != to && n > 0) bytes[{from, to}] += n;
    }
  };

  std::map<std::uint32_t, std::size_t> owner_;
  std::map<std::uint32_t, std::size_t> holder_; // of corners
  Mail seams_, flips_;                          // known before they are due
  std::size_t next_ = 0;                        // superstep that has not been looked at
  std::size_t recounted_ = 0;

public:
  using Base::Base;

  std::size_t number_recounted() const { return recounted_; }

  template <class State, class Zone>
  void zone_is_found(const State& whole, const Zone& zone, const std::vector<Triangle_id>& waiting) {
    Base::zone_is_found(whole, zone, waiting);
    if (is_next(Kind::CORNER_REQUESTS)) ++next_;
    if (is_next(Kind::CORNER_MARKS)) ++next_;
    std::map<std::uint32_t, std::size_t> ring;
    std::set<std::uint32_t> last, found;
    for (const Triangle_id t : zone.ring(0)) last.insert(t.value());
    for (std::size_t r = 0; r < zone.number_of_rings(); ++r) {
      for (const std::uint32_t t : last) ring.emplace(t, r);
      found.clear();
      Mail mail;
      for (const Triangle_id u : whole.mesh.triangles.ids()) {
        if (!whole.mesh.is_alive(u)) continue;
        const auto at = ring.find(u.value());
        if (at != ring.end() && at->second < r) continue;
        for (const Side o : whole.mesh.triangle(u).side) {
          if (o.is_border() || last.count(o.triangle().value()) == 0) continue;
          mail.add(owner_.at(o.triangle().value()), owner_.at(u.value()), 8);
          if (at == ring.end()) found.insert(u.value());
        }
      }
      expect(Kind::MARKS, mail);
      last = found;
    }
    CHECK(ring.size() == zone.triangles().size());
  }

  template <class State, class Blocks>
  void blocks_are_cut(const State& whole, const Blocks& blocks, int round) {
    Base::blocks_are_cut(whole, blocks, round);
    if (round == 1) begin(whole, blocks);
    // Who works where.
    std::vector<std::size_t> worker(blocks.size());
    Mail counts, answers;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      if (blocks.cut()[b].size() == 0) continue;
      std::map<std::size_t, std::size_t> members;
      for (const Triangle_id t : blocks.cut()[b]) ++members[owner_.at(t.value())];
      std::vector<std::pair<std::size_t, std::size_t>> by_size; // the most first, of equals the lowest part
      for (const auto& [p, n] : members) by_size.emplace_back(blocks.cut()[b].size() - n, p);
      worker[b] = std::min_element(by_size.begin(), by_size.end())->second;
      for (const auto& [p, n] : members) {
        counts.add(p, members.begin()->first, 24);
        answers.add(members.begin()->first, p, 24);
      }
    }
    const auto in_the_end = [&](Triangle_id t) {
      const auto b = blocks.block_of(t);
      return b.is_valid() ? worker[b.value()] : owner_.at(t.value());
    };
    Mail owners, triangles;
    std::set<std::tuple<std::size_t, std::size_t, std::uint32_t>> vertices; // block, sender, vertex
    seams_ = {};
    for (const Triangle_id u : whole.mesh.triangles.ids()) {
      if (!whole.mesh.is_alive(u)) continue;
      const auto b = blocks.block_of(u);
      const std::size_t p = owner_.at(u.value());
      if (b.is_valid() && worker[b.value()] != p) {
        triangles.add(p, worker[b.value()], triangle_bytes + (whole.mesh.region_of.empty() ? 0 : 8));
        for (const Vertex_id v : whole.mesh.triangle(u).v)
          if (vertices.insert({b.value(), p, v.value()}).second)
            triangles.add(p, worker[b.value()], vertex_bytes);
      }
      for (const Side o : whole.mesh.triangle(u).side) {
        if (o.is_border()) continue;
        const Triangle_id t = o.triangle(); // tells u, or is told of it
        const auto block_of_t = blocks.block_of(t);
        if (in_the_end(t) != owner_.at(t.value())) owners.add(owner_.at(t.value()), p, 16);
        if (b.is_valid() && worker[b.value()] != p && !(block_of_t == b) && in_the_end(t) != p &&
            in_the_end(t) != worker[b.value()])
          triangles.add(p, worker[b.value()], 16);
        const bool is_seam = !(b == block_of_t);
        if (is_seam) seams_.add(in_the_end(t), in_the_end(u), 32); // one of the two is worked on
      }
    }
    if (round > 1) {
      if (is_next(Kind::SUM_OF_SQUARES)) ++next_;
      expect(Kind::SQUARE_COUNTS, counts);
      expect(Kind::SQUARE_WORKERS, answers);
      expect(Kind::FUTURE_OWNERS, owners);
      move_corners(whole, in_the_end, triangles);
      expect(Kind::TRIANGLES, triangles);
    }
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (const Triangle_id t : blocks.cut()[b]) owner_[t.value()] = worker[b];
    worker_ = worker;
    flips_ = {};
  }

  template <class Block>
  void is_written(const Block& block) {
    Base::is_written(block);
    for (const Triangle_id t : block.mesh.triangles.ids())
      if (block.whole_triangle(t).is_valid())
        owner_[block.whole_triangle(t).value()] = worker_[block.id().value()];
  }

  template <class State, class Blocks>
  void are_written(const State& whole, const Blocks& blocks) {
    Base::are_written(whole, blocks);
    expect(Kind::SEAMS, seams_);
  }

  template <class State>
  void is_flipped(const State& whole, Triangle_id t, Triangle_id u) {
    Base::is_flipped(whole, t, u);
    std::size_t &p = owner_.at(t.value()), &q = owner_.at(u.value());
    const std::size_t flips = std::min(p, q);
    flips_.add(std::max(p, q), flips, triangle_bytes + vertex_bytes + (whole.mesh.region_of.empty() ? 0 : 8));
    p = q = flips;
    for (const Triangle_id x : {t, u})
      for (const Side o : whole.mesh.triangle(x).side)
        if (!o.is_border()) flips_.add(flips, owner_.at(o.triangle().value()), 16);
  }

  template <class State>
  void round_is_over(const State& whole) {
    Base::round_is_over(whole);
    move_corners(
        whole, [&](Triangle_id t) { return owner_.at(t.value()); }, flips_);
    expect(Kind::FLIPS, flips_);
    if (is_next(Kind::NAMES)) ++next_;
    CHECK(next_ == exchange().supersteps().size());
    check_holdings(whole);
  }

private:
  std::vector<std::size_t> worker_;

  bool is_next(Kind kind) const {
    return next_ < exchange().supersteps().size() && exchange().supersteps()[next_].kind == kind;
  }

  /// Parts are runs of blocks, and take what is in no block as is said.
  template <class State, class Blocks>
  void begin(const State& whole, const Blocks& blocks) {
    Part_id last(0);
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (const Triangle_id t : blocks.cut()[b]) {
        CHECK_FALSE(owners()[t] < last);
        if (t != blocks.cut()[b][0]) CHECK(owners()[t] == last);
        last = owners()[t];
      }
    for (const Triangle_id t : whole.mesh.triangles.ids())
      if (whole.mesh.is_alive(t)) {
        CHECK(owners()[t].value() < exchange().number_of_parts());
        owner_[t.value()] = owners()[t].value();
      }
    for (const Corner_id c : whole.corners.corners.ids()) {
      const Triangle_id t = whole.mesh.incident_triangle(whole.corners.corner(c).apex);
      holder_[c.value()] = t.is_valid() ? owner_.at(t.value()) : 0;
    }
  }

  template <class State, class Part_of>
  void move_corners(const State& whole, const Part_of& part_of, Mail& mail) {
    for (auto& [c, holder] : holder_) {
      const auto& corner = whole.corners.corner(Corner_id(c));
      const Triangle_id t = whole.mesh.incident_triangle(corner.apex);
      if (!t.is_valid()) continue;
      std::size_t bytes = 40 + 72 * corner.legs.size() + 32 * corner.sectors.size();
      for (const auto l : corner.legs)
        for (const auto& shell : whole.corners.leg(l).shells) static_cast<void>(shell), bytes += 16;
      mail.add(holder, part_of(t), bytes);
      holder = part_of(t);
    }
  }

  /// Checks the next superstep, which there is if there is mail.
  void expect(Kind kind, const Mail& mail) {
    if (mail.bytes.empty()) {
      CHECK_FALSE((is_next(kind) && kind != Kind::MARKS));
      return;
    }
    REQUIRE(is_next(kind));
    const auto& step = exchange().supersteps()[next_++];
    std::vector<std::size_t> messages(exchange().number_of_parts()), bytes(messages.size()),
        got(messages.size());
    for (const auto& [pair, n] : mail.bytes)
      ++messages[pair.first], bytes[pair.first] += n, got[pair.second] += n;
    for (const Part_id p : step.sent.ids()) {
      CHECK(step.sent[p].messages == messages[p.value()]);
      CHECK(step.sent[p].bytes == bytes[p.value()]);
      CHECK(step.received[p].bytes == got[p.value()]);
    }
    ++recounted_;
  }

  /// Each triangle has the owner that is said, and sums are those of the mesh.
  template <class State>
  void check_holdings(const State& whole) {
    std::vector<std::size_t> triangles(exchange().number_of_parts());
    std::set<std::uint32_t> used;
    std::set<std::pair<std::size_t, std::uint32_t>> held;
    bool have_owners = true;
    for (const Triangle_id t : whole.mesh.triangles.ids()) {
      if (!whole.mesh.is_alive(t)) continue;
      const std::size_t p = owner_.at(t.value());
      have_owners = have_owners && owners()[t].value() == p;
      ++triangles[p];
      for (const Vertex_id v : whole.mesh.triangle(t).v) used.insert(v.value()), held.insert({p, v.value()});
    }
    CHECK(have_owners);
    std::size_t sum = 0, vertices = 0, own_vertices = 0;
    const auto& after = rounds().back().after;
    for (const Part_id p : after.ids()) {
      CHECK(after[p].triangles == triangles[p.value()]);
      sum += after[p].triangles, vertices += after[p].vertices, own_vertices += after[p].own_vertices;
    }
    CHECK(sum == whole.mesh.number_of_triangles());
    CHECK(own_vertices == used.size());
    CHECK(vertices == held.size());
  }
};

#endif // QUADTREE_MESH_2_TEST_RECOUNTED_LEDGER_H
