#ifndef QUADTREE_MESH_2_BENCHMARK_BENCHMARK_OPTIONS_H
#define QUADTREE_MESH_2_BENCHMARK_BENCHMARK_OPTIONS_H

// What the command lines and the JSON files of the benchmarks have in common.

#include <CGAL/version.h>

#include <boost/program_options.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

/// Parses options, and inputs as all other words. Returns false if the user asked for help, and got it.
inline bool parse_options_and_inputs(int argc, char** argv,
                                     const boost::program_options::options_description& visible,
                                     std::vector<std::string>& inputs,
                                     boost::program_options::variables_map& given) {
  namespace po = boost::program_options;
  po::options_description all = visible;
  all.add_options()("input", po::value(&inputs));
  po::positional_options_description positional;
  positional.add("input", -1);
  po::store(po::command_line_parser(argc, argv).options(all).positional(positional).run(), given);
  po::notify(given);
  if (given.count("help") == 0) return true;
  std::cout << visible;
  return false;
}

/// Writes what was measured, under the given name, with what it was measured by.
inline void write_figures(const std::string& file_name, const std::string& name,
                          const nlohmann::ordered_json& figures, int repetitions) {
  const nlohmann::ordered_json json{
      {"repetitions", repetitions}, {"cgal", CGAL_VERSION_STR}, {name, figures}};
  std::ofstream out(file_name);
  out << json.dump(2) << '\n';
  if (!out.flush()) throw std::runtime_error("cannot write '" + file_name + "'");
}

#endif // QUADTREE_MESH_2_BENCHMARK_BENCHMARK_OPTIONS_H
