// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Relaxes the members of a patch until all triangles at them are in a range of angles.
//
// A step moves one vertex by a damped Gauss-Newton step on the energy of its star (Angle_range.h). The
// gradient of an angle at a fixed corner b is the perpendicular of the spoke over its squared length, so no
// trigonometry is needed. If a star has an inverted triangle, eight directions are searched. Only stars with
// energy move, and only the neighborhood of a move is looked at again. So the motion stays where it is
// needed. Sweeps may alternate with flips that lower the energy of the two triangles. O(degree) per step; the
// number of sweeps is bounded.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_STAR_RELAXER_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_STAR_RELAXER_H

#include <CGAL/Quadtree_mesh_2/internal/relaxation/Angle_range.h>
#include <CGAL/Quadtree_mesh_2/internal/relaxation/Ring_patch.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// The star of a vertex as vectors from it, scaled to lengths about 1, and padded to whole lanes with triangles whose
/// angles are all the same, so that these have no energy.
struct Star_vectors {
  static constexpr int lanes = Float_lanes::size;
  static constexpr int capacity = 2 * lanes + Ring::max_size;

  alignas(16) float x[capacity] = {};
  alignas(16) float y[capacity] = {};
  int number_of_triangles;
  double scale; ///< of the vectors

  template <class Geometry>
  Star_vectors(const Ring_mesh<Geometry>& mesh, Ring_vertex v) {
    const Ring& r = mesh.ring(v);
    number_of_triangles = r.number_of_triangles();
    const auto& center = mesh.point(v);
    const Vector first = Geometry::difference(mesh.point(r[0]), center);
    const double size = r.mobility == Mobility::RIGID ? least_length(mesh, r, center) : length(first);
    scale = size > 0 ? 1 / size : 1;
    set(0, first);
    for (int k = 1; k < r.size; ++k) set(k, Geometry::difference(mesh.point(r[k]), center));
    int n = r.size;
    if (!r.is_open) x[n] = x[0], y[n] = y[0], ++n;
    if (r.mobility == Mobility::RIGID) {
      exempt_ = triangles_of_rigid(mesh, r);
      shorten(n);
    }
    constexpr float cosine = 0.5f, sine = 0.8660254f;
    for (int k = n; k <= whole_lanes(); ++k) {
      x[k] = cosine * x[k - 1] - sine * y[k - 1];
      y[k] = sine * x[k - 1] + cosine * y[k - 1];
    }
  }

  int whole_lanes() const { return (number_of_triangles + lanes - 1) / lanes * lanes; }
  /// The triangles from k on, of the center moved by dx, dy.
  Triangle_lanes triangles(int k, Float_lanes dx, Float_lanes dy) const {
    return Triangle_lanes(Float_lanes::load(x + k) - dx, Float_lanes::load(y + k) - dy,
                          Float_lanes::load(x + k + 1) - dx, Float_lanes::load(y + k + 1) - dy);
  }

  /// What the triangles from k on have of something, but 0 for those that are exempt.
  Float_lanes demanded(int k, Float_lanes of_triangles) const {
    if (exempt_ == 0) return of_triangles;
    const auto lane = [&](int i) { return (exempt_ >> (k + i) & 1) != 0 ? 0.f : 1.f; };
    return of_triangles * Float_lanes(lane(0), lane(1), lane(2), lane(3));
  }

  /// Of the center moved by dx, dy.
  float energy(const Angle_range& range, float dx, float dy) const {
    Float_lanes e(0);
    for (int k = 0; k < number_of_triangles; k += lanes)
      e = e + demanded(k, Range_lanes(triangles(k, dx, dy), range).energy);
    return sum(e);
  }
  /// At least `bound` if it is not less.
  float energy(const Angle_range& range, float dx, float dy, float bound) const {
    float e = 0;
    for (int k = 0; k < number_of_triangles && e < bound; k += lanes)
      e += sum(demanded(k, Range_lanes(triangles(k, dx, dy), range).energy));
    return e;
  }

  bool is_in_range(const Angle_range& range) const {
    for (int k = 0; k < number_of_triangles; k += lanes) {
      const Triangle_lanes t = triangles(k, 0, 0);
      if (least(demanded(k, Range_lanes(t, range).slack(t, range))) < 0) return false;
    }
    return true;
  }

  /// Bit k is set if triangle k is not in the range for certain.
  unsigned violated(const Angle_range& range) const {
    unsigned bits = 0;
    for (int first = 0; first < number_of_triangles; first += lanes) {
      const Triangle_lanes t = triangles(first, 0, 0);
      const Float_lanes slack = Range_lanes(t, range).slack(t, range);
      for (int k = first; k < std::min(number_of_triangles, first + lanes); ++k)
        if (slack[k - first] < 0) bits |= 1u << k;
    }
    return bits & ~exempt_;
  }

private:
  unsigned exempt_ = 0; ///< bit k: triangle k has rigid vertices only

  template <class Mesh>
  static unsigned triangles_of_rigid(const Mesh& mesh, const Ring& r) {
    unsigned bits = 0;
    for (int k = 0; k < r.number_of_triangles(); ++k)
      if (mesh.ring(r[k]).mobility == Mobility::RIGID && mesh.ring(r.next(k)).mobility == Mobility::RIGID)
        bits |= 1u << k;
    return bits;
  }

  /// Rigid vertices may have neighbors of very different distance, by more than floats can span: near ones count.
  template <class Geometry>
  static double least_length(const Ring_mesh<Geometry>& mesh, const Ring& r,
                             const typename Geometry::Point& center) {
    double least = length(Geometry::difference(mesh.point(r[0]), center));
    for (int k = 1; k < r.size; ++k)
      least = std::min(least, length(Geometry::difference(mesh.point(r[k]), center)));
    return least;
  }
  static double length(Vector d) { return std::fabs(d.x) + std::fabs(d.y); }

  /// Far neighbors are in exempt triangles only, with which nothing has to be right, but numbers be finite.
  void shorten(int n) {
    constexpr float farthest = 0x1p28f;
    for (int k = 0; k < n; ++k) {
      x[k] = std::max(-farthest, std::min(x[k], farthest));
      y[k] = std::max(-farthest, std::min(y[k], farthest));
    }
  }

  void set(int k, Vector d) {
    x[k] = static_cast<float>(scale * d.x);
    y[k] = static_cast<float>(scale * d.y);
  }
};

/// The energy of the star of a movable vertex, and the sums of a Gauss-Newton step.
struct Star_energy {
  float energy, hxx, hxy, hyy, gx, gy;
  float shortest; ///< squared spoke
  bool has_flat;  ///< whether there may be a flat triangle: few others have that much energy

  Star_energy(const Star_vectors& star, const Angle_range& range) {
    Sums sums;
    Float_lanes squares(1e30f);
    for (int k = 0; k < star.number_of_triangles; k += Star_vectors::lanes) {
      const Triangle_lanes t = star.triangles(k, 0, 0);
      squares = min(squares, t.bb);
      const Range_lanes r(t, range);
      if (sum(r.energy) > 0) sums.add(star, k, t, r, range); // all that would be added is 0 otherwise
    }
    energy = sum(sums.energy);
    has_flat = energy >= 0.9f * Angle_range::energy_of_flat;
    if (energy == 0) return;
    shortest = least(squares);
    hxx = sum(sums.xx), hxy = sum(sums.xy), hyy = sum(sums.yy), gx = sum(sums.rx), gy = sum(sums.ry);
  }

private:
  struct Sums {
    Float_lanes energy{0}, xx{0}, xy{0}, yy{0}, rx{0}, ry{0};

    /// The gradient of an angle at a fixed corner b is the perpendicular of b over b^2; that of its cotangent is
    /// 1 + cot^2 times that, which is b^2 (b - c)^2 / cross^2, so that b^2 cancels.
    void add(const Star_vectors& star, int k, const Triangle_lanes& t, const Range_lanes& r,
             const Angle_range& range) {
      const Float_lanes zero(0);
      const Float_lanes share = r.inverse * r.inverse, per_side = t.squared_opposite_side() * share,
                        per_b = t.cc * share, per_c = t.bb * share;
      const Float_lanes bx = Float_lanes::load(star.x + k), by = Float_lanes::load(star.y + k),
                        cx = Float_lanes::load(star.x + k + 1), cy = Float_lanes::load(star.y + k + 1);
      const Float_lanes x[3] = {cy * per_c - by * per_b, by * per_side, zero - cy * per_side},
                        y[3] = {bx * per_b - cx * per_c, zero - bx * per_side, cx * per_side};
      energy = energy + r.energy;
      for (int i = 0; i < 3; ++i) {
        const Float_lanes residual = r.too_large[i] + r.too_small[i];
        const Float_lanes weight =
            select_where_less(zero, r.too_large[i], Float_lanes(range.high_weight), zero) -
            select_where_less(zero, r.too_small[i], Float_lanes(range.low_weight), zero);
        const Float_lanes jx = weight * x[i], jy = weight * y[i];
        xx = xx + jx * jx, xy = xy + jx * jy, yy = yy + jy * jy;
        rx = rx + residual * jx, ry = ry + residual * jy;
      }
    }
  };
};

/// How soon relaxation gives up.
enum class Patience {
  LITTLE, ///< as soon as success is unlikely, without flips: where another place can be tried instead
  MUCH    ///< when the energy does not fall any more
};

template <class Geometry>
class Star_relaxer {
public:
  Star_relaxer(Ring_patch<Geometry>& patch, const Angle_range& range) : patch_(patch), range_(range) {}

  const Angle_range& range() const { return range_; }

  /// Relaxes by at most `stages` times three sweeps and, with much patience, flips. Returns whether all changed stars
  /// are in the range.
  bool relax(int stages, Patience patience = Patience::MUCH) {
    double last = 1e300;
    for (int s = 0; s < stages; ++s) {
      double energy = 0;
      for (int sweep = 0; sweep < sweeps_of_stage; ++sweep) {
        energy = this->sweep();
        if (energy == 0) break;
        if (patience == Patience::LITTLE && energy > greatest_hopeful_energy(s * sweeps_of_stage + sweep))
          return false;
        if (energy < small_energy && sweep + 1 < sweeps_of_stage && are_changed_in_range()) return true;
      }
      if (are_changed_in_range()) return true;
      const bool is_flipped = patience == Patience::MUCH && flip_all();
      if (energy > least_progress * last && !is_flipped) return false;
      last = energy;
    }
    return false;
  }

  /// Moves active members once each. Returns the energies that their stars had.
  double sweep() {
    double energy = 0;
    // by position: flips and insertions do not happen here, so members stay
    for (std::size_t i = 0; i < patch_.members().size(); ++i) {
      const Ring_vertex v = patch_.members()[i];
      if (patch_.is_active(v)) energy += static_cast<double>(step(v));
    }
    return energy;
  }

  /// Moves v to lower the energy of its star, if it can. Returns the energy before.
  float step(Ring_vertex v) {
    const Mobility mobility = patch_.mesh().ring(v).mobility;
    const Star_vectors star(patch_.mesh(), v);
    if (!is_movable(mobility)) {
      const float energy = star.energy(range_, 0, 0);
      if (energy == 0) patch_.settle(v);
      return energy;
    }
    const Star_energy e(star, range_);
    if (e.energy == 0) return patch_.settle(v), 0.f;
    const Vector d = e.has_flat ? searched_step(star, e.energy, mobility) : newton_step(star, e, mobility);
    if (d.x != 0 || d.y != 0)
      patch_.move(v, Geometry::translate(patch_.mesh().point(v), (1 / star.scale) * d));
    return e.energy;
  }

  bool is_in_range(Ring_vertex v) const { return Star_vectors(patch_.mesh(), v).is_in_range(range_); }

  /// The sum over the triangles a, b, c and d, e, f, of points.
  template <class Point>
  float energy_of_two(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e,
                      const Point& f) const {
    const double size = size_of(Geometry::difference(b, a));
    const Vector ab = size * Geometry::difference(b, a), ac = size * Geometry::difference(c, a);
    const Vector de = size * Geometry::difference(e, d), df = size * Geometry::difference(f, d);
    const auto two = [](double x, double y) {
      const float p = static_cast<float>(x), q = static_cast<float>(y);
      return Float_lanes(p, q, p, q);
    };
    const Float_lanes energy =
        Range_lanes(Triangle_lanes(two(ab.x, de.x), two(ab.y, de.y), two(ac.x, df.x), two(ac.y, df.y)),
                    range_)
            .energy;
    return energy[0] + energy[1];
  }

  /// Flips an edge of each violated triangle at the changed members, where that lowers the energy. Returns whether it
  /// flipped any.
  bool flip_all() {
    bool is_flipped = false;
    for (std::size_t i = 0; i < patch_.members().size(); ++i) {
      const Ring_vertex v = patch_.members()[i];
      if (patch_.is_changed(v) && patch_.is_active(v)) is_flipped |= flip_one_at(v);
    }
    return is_flipped;
  }

  /// Flips edges opposite v that are not Delaunay, as far as members allow.
  void flip_to_Delaunay(Ring_vertex v) {
    const auto& mesh = patch_.mesh();
    for (int k = 0; k < mesh.ring(v).number_of_triangles();) {
      const Ring_vertex b = mesh.ring(v)[k], c = mesh.ring(v).next(k);
      if (can_flip(b, c, v) && is_in_circle(v, b, c))
        patch_.flip(b, c, v, mesh.right_of(b, mesh.ring(b).position_of(c)));
      else
        ++k;
    }
  }

  /// Flips the edge a, b, with c on its left, whatever becomes of the energy, if the four vertices are members and the
  /// two triangles stay turned as they should. Returns whether it did.
  bool flip_anyway(Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    if (!can_flip(a, b, c)) return false;
    const auto& mesh = patch_.mesh();
    const Ring_vertex d = mesh.right_of(a, mesh.ring(a).position_of(b));
    const auto &pa = mesh.point(a), &pb = mesh.point(b), &pc = mesh.point(c), &pd = mesh.point(d);
    if (energy_of_two(pc, pd, pb, pd, pc, pa) >= 0.9f * Angle_range::energy_of_flat) return false;
    if (mesh.ring(a).size < 5 || mesh.ring(b).size < 5) return false; // degree three is never of use
    patch_.flip(a, b, c, d);
    return true;
  }

private:
  static constexpr int sweeps_of_stage = 3;
  static constexpr double small_energy = 1e-2;
  static constexpr double least_progress = 0.5;
  static constexpr float least_gain = 1e-4f;

  Ring_patch<Geometry>& patch_;
  const Angle_range& range_;

  /// In a sweep, counted from 0. With more energy relaxation has succeeded in less than one of 30 cases: after a vertex
  /// was removed, in patches of one or two rings, with all angles in [36, 80] or at most 89.5 degrees alike.
  static double greatest_hopeful_energy(int sweep) {
    constexpr double energies[] = {2.4, 0.65, 0.18, 0.06, 0.027, 0.015, 0.009, 0.006, 0.004};
    constexpr int n = sizeof energies / sizeof energies[0];
    return energies[std::min(sweep, n - 1)];
  }

  static double size_of(Vector d) {
    const double size = std::fabs(d.x) + std::fabs(d.y);
    return size > 0 ? 1 / size : 1;
  }

  bool are_changed_in_range() const {
    return std::all_of(patch_.members().begin(), patch_.members().end(), [this](Ring_vertex v) {
      return !patch_.is_changed(v) || !patch_.is_active(v) || is_in_range(v);
    });
  }

  /// What of a step a vertex of the border may do.
  Vector permitted(Vector d, Mobility mobility) const {
    if (mobility == Mobility::FREE) return d;
    const Vector u = patch_.mesh().along;
    const Vector side = mobility == Mobility::SLIDES_ALONG ? u : Vector{-u.y, u.x};
    return dot(d, side) * side;
  }

  Vector newton_step(const Star_vectors& star, const Star_energy& e, Mobility mobility) const {
    constexpr double damping = 0.02, longest_share = 0.4;
    // Over-relaxed: what neighbors will have to do, too, is anticipated. A quarter fewer steps.
    constexpr double first_share = 1.7;
    const double lambda = damping * (static_cast<double>(e.hxx) + static_cast<double>(e.hyy)) + 1e-30;
    const double a = e.hxx + lambda, b = e.hxy, c = e.hyy + lambda, determinant = a * c - b * b;
    Vector d{-(c * e.gx - b * e.gy) / determinant, -(a * e.gy - b * e.gx) / determinant};
    if (mobility != Mobility::FREE) d = sliding_newton_step(e, lambda, mobility);
    const double longest = longest_share * longest_share * static_cast<double>(e.shortest),
                 length = squared_length(d);
    if (length > longest) d = std::sqrt(longest / length) * d;
    const float bound = e.energy * (1 - least_gain);
    for (double share = first_share; share > 0.1; share *= 0.5)
      if (star.energy(range_, static_cast<float>(share * d.x), static_cast<float>(share * d.y)) < bound)
        return share * d;
    return {};
  }

  /// Along the side only.
  Vector sliding_newton_step(const Star_energy& e, double lambda, Mobility mobility) const {
    const Vector side = permitted({1, 0}, mobility) + permitted({0, 1}, mobility);
    const Vector u = (1 / std::sqrt(squared_length(side))) * side;
    const double h = u.x * u.x * e.hxx + 2 * u.x * u.y * e.hxy + u.y * u.y * e.hyy + lambda;
    return (-(u.x * e.gx + u.y * e.gy) / h) * u;
  }

  /// The best of eight directions, at a third of the longest spoke, then nearer.
  Vector searched_step(const Star_vectors& star, float energy, Mobility mobility) const {
    constexpr double diagonal = 0.70710678118654752;
    constexpr Vector directions[] = {{1, 0},  {diagonal, diagonal},   {0, 1},  {-diagonal, diagonal},
                                     {-1, 0}, {-diagonal, -diagonal}, {0, -1}, {diagonal, -diagonal}};
    float longest = 0;
    for (int k = 0; k < star.number_of_triangles; ++k)
      longest = std::max(longest, star.x[k] * star.x[k] + star.y[k] * star.y[k]);
    const double length = std::sqrt(static_cast<double>(longest));
    for (double share = 0.3; share > 0.03; share *= 0.5) {
      Vector best;
      float least = energy;
      for (const Vector& u : directions) {
        const Vector d = permitted((share * length) * u, mobility);
        const float e = star.energy(range_, static_cast<float>(d.x), static_cast<float>(d.y), least);
        if (e < least) least = e, best = d;
      }
      if (least < energy) return best;
    }
    return {};
  }

  /// Flips an edge of a violated triangle of which v is the first of the changed members.
  bool flip_one_at(Ring_vertex v) {
    unsigned violated = Star_vectors(patch_.mesh(), v).violated(range_);
    for (int k = 0; violated != 0; ++k, violated >>= 1) {
      const Ring& r = patch_.mesh().ring(v);
      if ((violated & 1) == 0 || !is_first(v, r[k]) || !is_first(v, r.next(k))) continue;
      if (flip(v, r[k], r.next(k)) || flip(r[k], r.next(k), v) || flip(r.next(k), v, r[k])) return true;
    }
    return false;
  }
  bool is_first(Ring_vertex v, Ring_vertex other) const {
    return v < other || !patch_.is_changed(other) || !patch_.is_active(other);
  }

  /// Whether the edge a, b, with c on its left, is one of two triangles of members, which have room for another edge.
  bool can_flip(Ring_vertex a, Ring_vertex b, Ring_vertex c) const {
    const auto& mesh = patch_.mesh();
    if (!patch_.is_member(a) || !patch_.is_member(b) || !patch_.is_member(c)) return false;
    if (mesh.ring(a).mobility == Mobility::RIGID && mesh.ring(b).mobility == Mobility::RIGID) return false;
    const Ring_vertex d = mesh.right_of(a, mesh.ring(a).position_of(b));
    if (!d.is_valid() || !patch_.is_member(d)) return false;
    const Ring &rc = mesh.ring(c), &rd = mesh.ring(d);
    // nothing would be asked of a triangle of rigid vertices, so there must be no new one
    if (rc.mobility == Mobility::RIGID && rd.mobility == Mobility::RIGID) return false;
    return rc.size < Ring::max_size && rd.size < Ring::max_size && !rc.contains(d);
  }

  bool flip(Ring_vertex a, Ring_vertex b, Ring_vertex c) {
    const auto& mesh = patch_.mesh();
    if (!can_flip(a, b, c)) return false;
    const Ring_vertex d = mesh.right_of(a, mesh.ring(a).position_of(b));
    const auto &pa = mesh.point(a), &pb = mesh.point(b), &pc = mesh.point(c), &pd = mesh.point(d);
    const float now = energy_of_two(pa, pb, pc, pb, pa, pd);
    if (now == 0 || energy_of_two(pc, pd, pb, pd, pc, pa) >= 0.999f * now) return false;
    patch_.flip(a, b, c, d);
    return true;
  }

  /// Whether the vertex across b, c is in the circle of v, b, c; for the better or worse only.
  bool is_in_circle(Ring_vertex v, Ring_vertex b, Ring_vertex c) const {
    const auto& mesh = patch_.mesh();
    const auto& d = mesh.point(mesh.right_of(b, mesh.ring(b).position_of(c)));
    return In_circle(Geometry::difference(mesh.point(v), d), Geometry::difference(mesh.point(b), d),
                     Geometry::difference(mesh.point(c), d))
        .is_certainly_inside();
  }
};

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_RELAXATION_STAR_RELAXER_H
