// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "families.h"

#include "random_pslg_shapes.h"

#include <algorithm>

namespace soak {

namespace {

std::vector<Family> families_of_the_tests() {
  std::vector<Family> result;
  for (const random_pslg::Family& family : random_pslg::all_families()) {
    std::string name = family.name;
    std::replace(name.begin(), name.end(), ' ', '-');
    result.push_back({name, family.make});
  }
  return result;
}

} // namespace

const std::vector<Family>& all_families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> result;
    for (const auto& some : {families_of_the_tests(), near_duplicate_families(), tiny_feature_families(),
                             near_line_families(), exact_families(), survey_families(), scale_families(),
                             thin_families(), trifle_families(), point_families()})
      result.insert(result.end(), some.begin(), some.end());
    return result;
  }();
  return all;
}

} // namespace soak
