#ifndef QUADTREE_MESH_2_EXAMPLES_OPTION_USES_H
#define QUADTREE_MESH_2_EXAMPLES_OPTION_USES_H

// Which options of quality_mesh have a meaning with which others.

#include "command_line_types.h"
#include "file_formats.h"
#include "option_values.h"

#include <CGAL/Quality_mesh_options_2.h>

#include <algorithm>
#include <string>
#include <vector>

namespace command_line_internal {

/// Which modes an option has a meaning in.
struct Option_use {
  const char* option;
  std::vector<Command_line::Mode> modes;
};

inline const std::vector<Option_use>& option_uses() {
  using Mode = Command_line::Mode;
  static const std::vector<Option_use> uses = {
      {"min-angle", {Mode::PSLG}},
      {"max-edge", {Mode::PSLG}},
      {"max-area", {Mode::PSLG}},
      {"min-edge", {Mode::PSLG}},
      {"region-property", {Mode::PSLG}},
      {"marker-property", {Mode::PSLG}},
      {"hull", {Mode::PSLG}},
      {"repair", {Mode::PSLG}},
      {"project", {Mode::PSLG}},
      {"area-file", {Mode::PSLG}},
      {"size-points", {Mode::PSLG}},
      {"size-grid", {Mode::PSLG}},
      {"size-from-features", {Mode::PSLG}},
      {"gradation", {Mode::PSLG}},
      {"max-edge-ratio", {Mode::PSLG}},
      {"max-angle", {Mode::PSLG}},
      {"domain", {Mode::PSLG}},
      {"separation", {Mode::PSLG}},
      {"neighbors", {Mode::PSLG}},
      {"subdivision", {Mode::PSLG}},
      {"placement", {Mode::PSLG}},
      {"tree-rounds", {Mode::PSLG}},
      {"smooth", {Mode::PSLG}},
      {"thin", {Mode::PSLG}},
      {"max-vertices", {Mode::PSLG}},
      {"max-steiner", {Mode::PSLG}},
      {"conforming", {Mode::PSLG}},
      {"keep-borders", {Mode::PSLG}},
      {"no-coarsening", {Mode::PSLG}},
      {"compare", {Mode::PSLG, Mode::POINTS}},
      {"angles", {Mode::BOUNDED}},
      {"square", {Mode::BOUNDED}},
      {"effort", {Mode::POINTS, Mode::BOUNDED, Mode::ACUTE}},
      {"budget", {Mode::BOUNDED, Mode::ACUTE}},
      {"lengths", {Mode::POINTS, Mode::BOUNDED, Mode::ACUTE, Mode::WARPED}}};
  return uses;
}

/// \throws Usage_error naming an option that is given and has no meaning in the mode.
inline void check_option_uses(const po::variables_map& given, Command_line::Mode mode) {
  for (const auto& [option, modes] : option_uses()) {
    if (given.count(option) == 0 || given[option].defaulted()) continue;
    if (std::find(modes.begin(), modes.end(), mode) != modes.end()) continue;
    std::string all;
    for (const Command_line::Mode m : modes) all += (all.empty() ? "" : ", ") + std::string(name(m));
    throw Usage_error(std::string("--") + option + " has no meaning with --mode " + name(mode) +
                      ", only with " + all);
  }
}

/// \throws Usage_error naming an option that has no meaning with the separation chosen.
inline void check_uses_with(const po::variables_map& given,
                            CGAL::Quality_mesh_options_2::Separation separation) {
  const bool is_on_demand = separation == CGAL::Quality_mesh_options_2::Separation::ON_DEMAND;
  const std::vector<const char*> senseless =
      is_on_demand ? std::vector<const char*>{"neighbors", "subdivision", "placement", "tree-rounds"}
                   : std::vector<const char*>{"min-edge"};
  for (const char* const option : senseless)
    if (given.count(option) > 0 && !given[option].defaulted())
      throw Usage_error(std::string("--") + option + " has no meaning with --separation " +
                        (is_on_demand ? "on-demand" : "theorem-5"));
}

/// \throws Usage_error naming an option that has no meaning for the input, where this is a mesh to refine or is none
inline void check_uses_with(const po::variables_map& given, Input_format input) {
  const bool is_mesh = input == Input_format::ELE;
  const std::vector<const char*> senseless =
      is_mesh ? std::vector<const char*>{"hull",   "repair", "project", "size-from-features", "domain",
                                         "kernel", "memory", "resume",  "separation",         "compare"}
              : std::vector<const char*>{"area-file"};
  for (const char* const option : senseless)
    if (given.count(option) > 0 && !given[option].defaulted())
      throw Usage_error(std::string("--") + option + " has " +
                        (is_mesh ? "no meaning for a mesh to refine (.ele)"
                                 : "a meaning for a mesh to refine only, an input .ele"));
}

} // namespace command_line_internal

#endif // QUADTREE_MESH_2_EXAMPLES_OPTION_USES_H
