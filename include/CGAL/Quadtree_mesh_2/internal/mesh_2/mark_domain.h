// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Which faces of a constrained triangulation are in the domain, by the rules of Mesh_2.
//
// Linear in the number of faces, and a walk for each seed. Mesh_2 takes a seed on a constrained edge for one
// on some side of it, by chance. Here it is refused, unless the component is the same on all sides.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_MARK_DOMAIN_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_MARK_DOMAIN_H

#include <CGAL/Pslg_error_2.h>
#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// Calls `across(g)` for the faces g across constrained edges of the component of `first`: of the faces that are
/// reached from there without crossing a constrained edge and for which `visit(f)` returns true, as it does the
/// first time.
template <class Cdt, class Visit, class Across>
void flood_component(typename Cdt::Face_handle first, Visit visit, Across across) {
  if (!visit(first)) return;
  std::vector<typename Cdt::Face_handle> stack{first};
  while (!stack.empty()) {
    const auto f = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const auto g = f->neighbor(i);
      if (f->is_constrained(i))
        across(g);
      else if (visit(g))
        stack.push_back(g);
    }
  }
}

/// Gives all faces of a component the mark; stops at faces that have it.
template <class Cdt>
void mark_component(typename Cdt::Face_handle first, bool is_in_domain) {
  first->set_in_domain(!is_in_domain);
  flood_component<Cdt>(
      first,
      [is_in_domain](typename Cdt::Face_handle f) {
        if (f->is_in_domain() == is_in_domain) return false;
        f->set_in_domain(is_in_domain);
        return true;
      },
      [](typename Cdt::Face_handle) {});
}

template <class Cdt>
void mark_all_faces(Cdt& cdt, bool is_in_domain) {
  for (auto f = cdt.all_faces_begin(); f != cdt.all_faces_end(); ++f) f->set_in_domain(is_in_domain);
}

/// Takes what is connected to infinity out of the domain, whatever its marks. Returns these faces' addresses.
template <class Cdt>
std::unordered_set<const typename Cdt::Face*> mark_outside(Cdt& cdt) {
  std::unordered_set<const typename Cdt::Face*> outside;
  if (cdt.dimension() < 2) return outside;
  flood_component<Cdt>(
      cdt.infinite_face(),
      [&](typename Cdt::Face_handle f) {
        if (!outside.insert(&*f).second) return false;
        f->set_in_domain(false);
        return true;
      },
      [](typename Cdt::Face_handle) {});
  return outside;
}

/// Whether faces are in one component.
template <class Cdt>
bool is_one_component(const std::vector<typename Cdt::Face_handle>& faces) {
  std::unordered_set<const typename Cdt::Face*> reached;
  flood_component<Cdt>(
      faces.front(), [&](typename Cdt::Face_handle f) { return reached.insert(&*f).second; },
      [](typename Cdt::Face_handle) {});
  return std::all_of(faces.begin(), faces.end(),
                     [&](typename Cdt::Face_handle f) { return reached.count(&*f) > 0; });
}

/// A face of the component with a seed.
/// \throws Pslg_error_2 if it is in the border of several.
template <class Cdt>
typename Cdt::Face_handle locate_seed(const Cdt& cdt, const typename Cdt::Point& seed, std::size_t number) {
  typename Cdt::Locate_type type;
  int i = 0;
  const auto f = cdt.locate(seed, type, i);
  std::vector<typename Cdt::Face_handle> around{f};
  if (type == Cdt::EDGE) {
    around.push_back(f->neighbor(i));
  } else if (type == Cdt::VERTEX) {
    auto g = cdt.incident_faces(f->vertex(i));
    const auto first = g;
    do around.push_back(g);
    while (++g != first);
  }
  if (around.size() == 1 || is_one_component<Cdt>(around)) return f;
  std::ostringstream text;
  text.precision(17);
  text << "seed " << number << " (" << seed << ") lies on "
       << (type == Cdt::EDGE ? "a constrained edge" : "an end of a constrained edge")
       << ", between several components of the plane; move it into one";
  throw Pslg_error_2(Pslg_error_2::Kind::AMBIGUOUS_SEED, text.str(), Pslg_parts_2().seed(number));
}

/// The components with a seed get the mark, the others the opposite; without seeds all are in the domain. What is
/// connected to infinity never is.
template <class Cdt, class InputIterator>
void mark_by_seeds(Cdt& cdt, InputIterator begin, InputIterator end, bool are_seeds_in_domain) {
  if (cdt.dimension() < 2) return;
  mark_all_faces(cdt, begin == end || !are_seeds_in_domain);
  for (std::size_t number = 0; begin != end; ++begin, ++number)
    mark_component<Cdt>(locate_seed(cdt, *begin, number), are_seeds_in_domain);
  mark_outside(cdt);
}

/// The components that one gets into from infinity by crossing an odd number of constrained edges at least.
template <class Cdt>
void mark_by_nesting(Cdt& cdt) {
  if (cdt.dimension() < 2) return;
  using Face_handle = typename Cdt::Face_handle;
  std::unordered_set<const typename Cdt::Face*> reached;
  std::vector<Face_handle> level{cdt.infinite_face()}, next;
  for (bool is_in_domain = false; !level.empty(); is_in_domain = !is_in_domain) {
    next.clear();
    for (const Face_handle first : level)
      flood_component<Cdt>(
          first,
          [&](Face_handle f) {
            if (!reached.insert(&*f).second) return false;
            f->set_in_domain(is_in_domain);
            return true;
          },
          [&](Face_handle g) {
            if (reached.count(&*g) == 0) next.push_back(g);
          });
    std::swap(level, next);
  }
}

/// Marks faces by the rule of the options: seeds are in the domain with MARKED, in holes otherwise.
template <class Cdt, class InputIterator>
void mark_by_rule(Cdt& cdt, InputIterator begin, InputIterator end, Quality_mesh_options_2::Domain rule) {
  using Domain = Quality_mesh_options_2::Domain;
  if (rule == Domain::NESTING_PARITY && cdt.dimension() == 2) {
    mark_by_nesting(cdt);
    for (std::size_t number = 0; begin != end; ++begin, ++number) {
      const auto f = locate_seed(cdt, *begin, number);
      if (f->is_in_domain()) mark_component<Cdt>(f, false);
    }
  } else if (rule == Domain::MARKED && begin == end) {
    mark_all_faces(cdt, false);
  } else {
    mark_by_seeds(cdt, begin, end, rule == Domain::MARKED);
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_MESH_2_MARK_DOMAIN_H
