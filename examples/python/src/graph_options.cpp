// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "graph_options.h"

#include "sizes.h"

#include <CGAL/mesh_in_projection_2.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>

namespace quadtree_mesh_python {

namespace {

template <class Value>
Value named(const std::map<std::string, Value>& values, const std::string& name, const char* what) {
  const auto found = values.find(name);
  if (found != values.end()) return found->second;
  std::string text = std::string(what) + " must be one of";
  for (const auto& value : values) text += " '" + value.first + "'";
  throw std::invalid_argument(text + ", not '" + name + "'");
}

} // namespace

std::optional<CGAL::Conformal_projection_2> projection_for(const CGAL::Pslg_2<Point>& graph,
                                                           const std::string& name) {
  using Projection = CGAL::Conformal_projection_2;
  using Choice = Projection (*)(const Projection::Box&);
  const Choice choice =
      named<Choice>({{"none", nullptr},
                     {"auto", &Projection::for_box},
                     {"mercator", [](const Projection::Box& b) { return Projection::mercator(b); }},
                     {"lambert", [](const Projection::Box& b) { return Projection::lambert(b); }}},
                    name, "project");
  if (choice == nullptr) return std::nullopt;
  const Projection::Box box = CGAL::box_in_degrees(graph);
  const Projection projection = choice(box);
  if (std::abs(projection.cone_constant()) * (box.high[0] - box.low[0]) >= 360)
    throw std::invalid_argument(
        "the graph goes around the pole, where its two ends would meet in the projection");
  return projection;
}

CGAL::Quality_mesh_options_2 options_from(const py::dict& values,
                                          const CGAL::Conformal_projection_2* projection) {
  using Options = CGAL::Quality_mesh_options_2;
  Options options;
  options.min_angle(values["min_angle"].cast<double>())
      .max_area(values["max_area"].cast<double>())
      .max_edge(values["max_edge"].cast<double>())
      .min_edge(values["min_edge"].cast<double>())
      .gradation(values["gradation"].cast<double>())
      .max_edge_ratio(values["max_edge_ratio"].cast<double>())
      .max_angle(values["max_angle"].cast<double>())
      .size(least_size(values["size"].cast<py::list>(), projection))
      .smooth(values["smooth"].cast<int>())
      .thin(values["thin"].cast<int>())
      .max_vertices(values["max_vertices"].cast<std::size_t>());
  if (!values["max_steiner"].is_none())
    options.max_steiner_vertices(values["max_steiner"].cast<std::size_t>());
  if (values["conforming"].cast<bool>()) options.conform(Options::Conforming::DELAUNAY);
  options.keep_borders(named<Options::Keep_borders>({{"none", Options::Keep_borders::NONE},
                                                     {"boundary", Options::Keep_borders::BOUNDARY},
                                                     {"marked", Options::Keep_borders::MARKED},
                                                     {"all", Options::Keep_borders::ALL}},
                                                    values["keep_borders"].cast<std::string>(),
                                                    "keep_borders"));
  options.coarsen(values["coarsen"].cast<bool>() ? Options::Coarsening::GUARDED_REMOVAL
                                                 : Options::Coarsening::NONE);
  options.mesh_domain(named<Options::Domain>({{"enclosed", Options::Domain::ENCLOSED},
                                              {"marked", Options::Domain::MARKED},
                                              {"parity", Options::Domain::NESTING_PARITY}},
                                             values["domain"].cast<std::string>(), "domain"));
  options.separate(named<Options::Separation>(
      {{"on_demand", Options::Separation::ON_DEMAND}, {"theorem_5", Options::Separation::THEOREM_5}},
      values["separation"].cast<std::string>(), "separation"));
  return projection != nullptr ? CGAL::options_in_projection_2(std::move(options)) : options;
}

} // namespace quadtree_mesh_python
