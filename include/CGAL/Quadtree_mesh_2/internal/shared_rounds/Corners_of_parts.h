// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Where acute corners lie in a mesh that parts hold, and in which block: what Corner_places.h says of a mesh in one
// memory.
//
// All parts look at the same corners at once. Each reads what it holds, and then publishes what it has read of its own,
// until nobody publishes anything. Then all have read shared triangles alone, and have found the same. For whoever
// comes to a triangle that another part has for itself, that part has come to it as well, and publishes it.
// As many exchanges as the most parts in turn that the triangles of a corner lie in, and one more.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_CORNERS_OF_PARTS_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_CORNERS_OF_PARTS_H

#include <CGAL/Quadtree_mesh_2/internal/base/sort_and_drop_equal.h>
#include <CGAL/Quadtree_mesh_2/internal/distributed/tell_all.h>
#include <CGAL/Quadtree_mesh_2/internal/refinement/Meshing_state.h>
#include <CGAL/Quadtree_mesh_2/internal/rounds/Corner_places.h>
#include <CGAL/Quadtree_mesh_2/internal/shared_rounds/Held_mesh.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

template <class Exchange, class Geometry>
class Corners_of_parts {
public:
  using Held = Held_mesh<Exchange, Geometry>;
  using Corners = Acute_corners<Geometry>;

  Corners_of_parts(Exchange& exchange, Held& held, Meshing_state<Geometry>& whole)
      : exchange_(exchange), held_(held), whole_(whole) {}

  /// All vertices that corners know by name.
  std::vector<Vertex_id> vertices() const {
    std::vector<Vertex_id> found;
    for (const auto& leg : whole_.corners.legs) {
      for (const Vertex_id v : {leg.apex_vertex, leg.ring})
        if (v.is_valid()) found.push_back(v);
      for (const auto& [radius, v] : leg.shells) {
        static_cast<void>(radius);
        if (v.is_valid()) found.push_back(v);
      }
    }
    sort_and_drop_equal(found);
    return found;
  }

  // ---- what all parts call together, with the same arguments

  /// The triangles of the corners, as far as their legs are cut; some more than once.
  std::vector<Triangle_id> triangles_of(const std::vector<Corner_id>& corners) {
    std::vector<Triangle_id> found;
    look([&](const Look_up& look_up) {
      found.clear();
      for (const Corner_id c : corners)
        visit(c, look_up, [&](Triangle_id t) {
          found.push_back(t);
          return true;
        });
    });
    return found;
  }

  /// The block that has all of a corner, or none, for each of the corners, of which the others are not in any.
  /// \param block_of the block of a triangle that may not be held
  template <class Block_of>
  std::vector<Block_id> owners(const std::vector<Corner_id>& corners, const Block_of& block_of) {
    std::vector<Block_id> owner;
    look([&](const Look_up& look_up) {
      owner.clear();
      for (const Corner_id c : corners) owner.push_back(owner_of(c, look_up, block_of));
    });
    return owner;
  }

  /// The sides between pairs of vertices, from either of its triangles; the border for those without one. All triangles
  /// that a search of one memory reads are shared then, if it finds the side in the fans at its ends.
  std::vector<Side> sides_between(const std::vector<std::array<Vertex_id, 2>>& pairs) {
    std::vector<Side> sides;
    look([&](const Look_up& look_up) {
      sides.clear();
      for (const auto& [x, y] : pairs) sides.push_back(look_up.side_in_fans(x, y).found);
    });
    return sides;
  }

  /// Tells all what has become of the corners, in the handles of the whole mesh. Each part has others.
  void tell(const std::vector<Corner_id>& corners) {
    Archive_writer archive;
    for (const Corner_id c : corners) transfer(Each<Archive_writer, false>{archive}, c);
    for (const Parcel& parcel : tell_all_bytes(exchange_, archive.bytes)) {
      if (parcel.part == exchange_.rank()) continue;
      Archive_reader reader(parcel.bytes);
      while (!reader.is_at_end()) transfer(Each<Archive_reader, true>{reader}, Corner_id());
    }
  }

private:
  Exchange& exchange_;
  Held& held_;
  Meshing_state<Geometry>& whole_;

  /// Looks things up in what is held, as far as one gets, and notes what it reads.
  struct Look_up {
    const Held& held;
    const Meshing_state<Geometry>& whole;
    std::vector<Triangle_id>& read;

    bool may_read(Triangle_id t) const {
      if (held.is_private(t)) read.push_back(t);
      return held.is_held(t);
    }

    Side side_between(Vertex_id x, Vertex_id y) const {
      const Search search = side_in_fans(x, y);
      const bool may_have_other_fans = whole.mesh.is_input(x) && whole.mesh.is_input(y);
      const bool is_elsewhere = search.is_all_read && search.found.is_border() && may_have_other_fans;
      return is_elsewhere ? find_side_everywhere(x, y) : search.found;
    }

    /// The border if it is not found, and whether that is for sure.
    struct Search {
      Side found;
      bool is_all_read;
    };
    Search side_in_fans(Vertex_id x, Vertex_id y) const {
      const Triangle_id at_x = whole.mesh.incident_triangle(x), at_y = whole.mesh.incident_triangle(y);
      const bool may_begin = may_read(at_x);
      if (!may_read(at_y) || !may_begin) return {Side::border(), false};
      Fan_walk<Kernel_mesh<Geometry>> walk(whole.mesh, x, at_x), other(whole.mesh, y, at_y);
      for (;;) {
        const Side found = walk.side_to(y), of_other = other.side_to(x);
        if (!found.is_border() || !of_other.is_border()) return {found.is_border() ? of_other : found, true};
        const bool has_more = walk.advance(), other_has_more = other.advance();
        if (walk.is_closed() || other.is_closed() || (!has_more && !other_has_more)) break;
        const bool may_go_on = may_read(walk.triangle());
        if (!may_read(other.triangle()) || !may_go_on) return {Side::border(), false};
      }
      return {Side::border(), true};
    }

    template <class Function>
    void for_each_triangle_at(Vertex_id v, const Function& f) const {
      const Triangle_id start = whole.mesh.incident_triangle(v);
      if (!may_read(start)) return;
      Fan_walk<Kernel_mesh<Geometry>> walk(whole.mesh, v, start);
      do f(walk.triangle());
      while (walk.advance() && may_read(walk.triangle()));
    }

    Side find_side_everywhere(Vertex_id x, Vertex_id y) const {
      const auto& mesh = whole.mesh;
      for (const Triangle_id t : mesh.triangles.ids()) {
        if (!held.is_held(t)) continue;
        for (int k = 0; k < 3; ++k) {
          const Side s(t, k);
          if ((mesh.source(s) == x && mesh.target(s) == y) || (mesh.source(s) == y && mesh.target(s) == x)) {
            may_read(t);
            return s;
          }
        }
      }
      return Side::border();
    }
  };

  /// Looks until all have read shared triangles alone.
  template <class Function>
  void look(const Function& f) {
    std::vector<Triangle_id> read;
    do {
      read.clear();
      f(Look_up{held_, whole_, read});
    } while (held_.publish(held_.private_around(read, 1)) > 0);
  }

  template <class Function>
  bool visit(Corner_id c, const Look_up& look_up, const Function& f) const {
    return Corner_visit<Geometry, Look_up>{whole_, look_up}.run(whole_.corners.corner(c), f);
  }

  template <class Block_of>
  Block_id owner_of(Corner_id c, const Look_up& look_up, const Block_of& block_of) const {
    Block_id owner;
    const bool is_all = visit(c, look_up, [&](Triangle_id t) {
      const Block_id b = block_of(t);
      if (!owner.is_valid()) owner = b;
      return b.is_valid() && b == owner;
    });
    return is_all ? owner : Block_id();
  }

  /// An archive of several values at once.
  template <class Archive, bool is_reading_it>
  struct Each {
    static constexpr bool is_reading = is_reading_it;
    Archive& archive;

    template <class... Values>
    void operator()(Values&... values) {
      (archive(values), ...);
    }
  };

  /// What blocks change of a corner.
  template <class Archive>
  void transfer(Archive archive, Corner_id c) {
    archive(c);
    const auto& corner = whole_.corners.corner(c);
    for (const Leg_id l : corner.legs) {
      auto& leg = whole_.corners.leg(l);
      archive(leg.apex_vertex, leg.ring);
      leg.shells.transfer(archive);
    }
    for (const Sector_id s : corner.sectors) archive(whole_.corners.sector(s).lock_radius);
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_SHARED_ROUNDS_CORNERS_OF_PARTS_H
