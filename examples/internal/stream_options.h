// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef QUADTREE_MESH_2_EXAMPLES_STREAM_OPTIONS_H
#define QUADTREE_MESH_2_EXAMPLES_STREAM_OPTIONS_H

// What `-` for input or output means, with --input-format and --output-format.

#include "file_formats.h"
#include "option_values.h"
#include "standard_streams.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace command_line_internal {

/// \throws Usage_error naming the option if its format is unknown
inline std::string format_of_stream(const po::variables_map& given, const std::string& option,
                                    const std::vector<std::string>& formats) {
  return given.count(option) == 0 ? std::string() : formats[choice(given, option, formats)];
}

/// The name by which the input is read: with the ending of its format, if it is standard input.
inline std::string name_of_input(const po::variables_map& given, const std::string& input) {
  const std::string format =
      format_of_stream(given, "input-format", {"poly", "geojson", "json", "wkt", "node", "xy", "csv", "txt"});
  if (input == "-") return name_of_stream(format);
  if (!format.empty()) throw Usage_error("--input-format has a meaning for standard input only, INPUT -");
  return name_of_file(input);
}

/// \throws Usage_error if a format is wanted and standard output is not, or the other way
inline std::vector<std::string> names_of_outputs(const po::variables_map& given) {
  std::vector<std::string> outputs;
  if (given.count("output") > 0) outputs = given["output"].as<std::vector<std::string>>();
  const std::string format = format_of_stream(
      given, "output-format", {"vtu", "svg", "html", "off", "obj", "msh", "mesh", "2dm", "gr3", "14"});
  const auto streams = std::count(outputs.begin(), outputs.end(), "-");
  if (streams > 1) throw Usage_error("standard output, -o -, takes one mesh");
  if (streams == 0 && !format.empty())
    throw Usage_error("--output-format has a meaning for standard output only, -o -");
  if (streams > 0 && format.empty())
    throw Usage_error("standard output, -o -, needs a format, such as --output-format off");
  for (std::string& output : outputs) output = output == "-" ? name_of_stream(format) : name_of_file(output);
  return outputs;
}

/// \throws Usage_error if pieces of a format would go to standard output
inline void check_stream_has_no_pieces(const std::vector<std::string>& outputs, std::size_t pieces) {
  for (const std::string& output : outputs)
    if (is_standard_stream(output) && !ending_of_pieces(output, pieces).empty())
      throw Usage_error("--pieces writes several files, which standard output, -o -, does not take");
}

} // namespace command_line_internal

#endif // QUADTREE_MESH_2_EXAMPLES_STREAM_OPTIONS_H
