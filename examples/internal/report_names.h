// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_REPORT_NAMES_H
#define QUADTREE_MESH_2_EXAMPLES_REPORT_NAMES_H

// What the parts of a report are called in JSON by the program, and in Python: one table for both. What has to do with
// an option has its name.

#include <CGAL/Conformal_projection_2.h>
#include <CGAL/Quadtree_mesh_2/mesh_quality_types.h>
#include <CGAL/Quality_mesh_report_2.h>

namespace report_words {

inline const char* name(CGAL::Conformal_projection_2::Kind kind) {
  using Kind = CGAL::Conformal_projection_2::Kind;
  switch (kind) {
  case Kind::MERCATOR:
    return "mercator";
  case Kind::LAMBERT:
    return "lambert";
  case Kind::STEREOGRAPHIC:
    return "stereographic";
  }
  return "";
}

inline const char* name(CGAL::Mesh_quality_2::Bound bound) {
  switch (bound) {
  case CGAL::Mesh_quality_2::Bound::ANGLE:
    return "min_angle";
  case CGAL::Mesh_quality_2::Bound::EDGE_LENGTH:
    return "max_edge";
  case CGAL::Mesh_quality_2::Bound::AREA:
    return "max_area";
  case CGAL::Mesh_quality_2::Bound::GREATEST_ANGLE:
    return "max_angle";
  }
  return "";
}

inline const char* name(CGAL::Quality_mesh_report_2::Reason reason) {
  using Reason = CGAL::Quality_mesh_report_2::Reason;
  switch (reason) {
  case Reason::BUDGET:
    return "budget";
  case Reason::CANCELLED:
    return "cancelled";
  case Reason::LEAST_EDGE:
    return "min_edge";
  case Reason::KEPT_SEGMENT:
    return "kept_segment";
  case Reason::CORNER:
    return "corner";
  case Reason::GREATEST_ANGLE:
    return "max_angle";
  case Reason::COORDINATES:
    return "coordinates";
  case Reason::CRITERIA:
    return "criteria";
  }
  return "";
}

inline const char* name(CGAL::Tree_separation_report_2::End end) {
  using End = CGAL::Tree_separation_report_2::End;
  switch (end) {
  case End::NONE:
    return "none";
  case End::DONE:
    return "done";
  case End::ROUNDS:
    return "rounds";
  case End::COORDINATES:
    return "coordinates";
  case End::BUDGET:
    return "budget";
  case End::CANCELLED:
    return "cancelled";
  case End::FAILED:
    return "failed";
  }
  return "";
}

} // namespace report_words

#endif // QUADTREE_MESH_2_EXAMPLES_REPORT_NAMES_H
