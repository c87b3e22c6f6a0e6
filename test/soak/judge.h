// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_TEST_SOAK_JUDGE_H
#define QUADTREE_MESH_2_TEST_SOAK_JUDGE_H

// Whether a mesher kept its promises for one input.

#include "Soak_case.h"

#include <string>

namespace soak {

enum class Outcome {
  MET,     ///< a valid mesh that meets all bounds
  UNMET,   ///< a valid mesh that misses some where coordinates have no room, as an exact check confirms
  REFUSED, ///< with a message that names what is at fault, as an exact check confirms
  FAILED
};

struct Verdict {
  Outcome outcome = Outcome::MET;
  std::string kind;   ///< of failure: a word or two, the same for the same cause
  std::string detail; ///< for people
};

inline Verdict failure(const std::string& kind, const std::string& detail) {
  return {Outcome::FAILED, kind, detail};
}

/// Runs the mesher, with one thread and, if the case has more, with these, and judges what comes out.
Verdict judge(const Soak_case& c);

/// Whether what a mesher says about an input that it refuses is true.
Verdict judge_refusal(const Soak_case& c, const std::string& message);

} // namespace soak

#endif // QUADTREE_MESH_2_TEST_SOAK_JUDGE_H
