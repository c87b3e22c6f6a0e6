// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Runs the meshers on generated inputs without end, judges what they make, and makes what fails smaller. See --help.

#include "Batch_runner.h"
#include "File_case.h"
#include "Soak_case.h"
#include "Tally.h"
#include "families.h"
#include "judge.h"
#include "make_case.h"
#include "minimize.h"

#include "resources.h"

#include <boost/program_options.hpp>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

namespace po = boost::program_options;

/// Not graphs, but files for the program quality_mesh.
const soak::Family files{"files", nullptr};

std::vector<soak::Family> families_and_files() {
  std::vector<soak::Family> all = soak::all_families();
  all.push_back(files);
  return all;
}

struct Settings {
  double minutes = 1;
  std::size_t inputs = 0; ///< 0: as many as there is time for
  std::uint64_t seed = 0;
  std::vector<soak::Family> families; ///< one without graphs stands for files
  soak::Restriction restriction;
  std::string log, folder, commit;
  unsigned workers = 1;
  double minimizing_seconds = 60;
  soak::Limits limits;
};

po::options_description described_options() {
  po::options_description all("Options");
  // clang-format off
  all.add_options()
      ("help,h", "this text")
      ("minutes", po::value<double>()->default_value(1), "how long, by the clock")
      ("inputs", po::value<std::size_t>(), "how many, whatever the time")
      ("seed", po::value<std::uint64_t>()->default_value(0), "other seeds give other inputs")
      ("family", po::value<std::vector<std::string>>(), "only this one; may be given more than once")
      ("without", po::value<std::vector<std::string>>(), "not this family; may be given more than once")
      ("kernel", po::value<std::string>(), "filtered, exact, fixed or fixed32")
      ("separation", po::value<std::string>(), "on-demand or theorem-5")
      ("mode", po::value<std::string>(), "pslg, points, bounded, acute or warped")
      ("threads", po::value<unsigned>(), "compare the bits of so many threads with those of one")
      ("plain", "the default options only")
      ("log", po::value<std::string>(), "append lines of JSON to this file")
      ("folder", po::value<std::string>()->default_value("soak"), "where inputs go that fail")
      ("commit", po::value<std::string>()->default_value("unknown"), "what is run, for the log")
      ("workers", po::value<unsigned>(), "how many processes at a time; all processors if not given")
      ("minimize", po::value<double>()->default_value(60), "seconds to make one input smaller")
      ("replay", po::value<std::vector<std::string>>(), "judge this file again; may be given more than once")
      ("docs", po::value<std::vector<std::string>>()->multitoken(), "write the page that says what these logs say")
      ("list", "list the families");
  // clang-format on
  return all;
}

template <class Enum>
std::optional<Enum> chosen(const po::variables_map& given, const char* option,
                           const std::vector<std::string>& names) {
  if (given.count(option) == 0) return {};
  const auto at = std::find(names.begin(), names.end(), given[option].as<std::string>());
  if (at == names.end()) throw std::invalid_argument(std::string("--") + option + ": no such choice");
  return static_cast<Enum>(at - names.begin());
}

/// The families that are asked for, without those that are not wanted.
std::vector<soak::Family> chosen_families(const po::variables_map& given) {
  const std::vector<soak::Family> all = families_and_files();
  const auto named = [&](const char* option) {
    std::set<std::string> names;
    if (given.count(option) == 0) return names;
    for (const std::string& name : given[option].as<std::vector<std::string>>()) {
      if (std::none_of(all.begin(), all.end(), [&](const soak::Family& f) { return f.name == name; }))
        throw std::invalid_argument(std::string("--") + option + ": there is no '" + name + "'; see --list");
      names.insert(name);
    }
    return names;
  };
  const std::set<std::string> wanted = named("family"), unwanted = named("without");
  std::vector<soak::Family> result;
  for (const soak::Family& f : all)
    if ((wanted.empty() || wanted.count(f.name) > 0) && unwanted.count(f.name) == 0) result.push_back(f);
  if (result.empty()) throw std::invalid_argument("--without: no family is left");
  return result;
}

Settings settings_of(const po::variables_map& given) {
  Settings s;
  s.minutes = given["minutes"].as<double>();
  if (given.count("inputs") > 0) s.inputs = given["inputs"].as<std::size_t>();
  s.seed = given["seed"].as<std::uint64_t>();
  s.families = chosen_families(given);
  s.restriction.kernel = chosen<soak::Kernel>(given, "kernel", soak::kernel_names());
  s.restriction.separation = chosen<soak::Separation>(given, "separation", soak::separation_names());
  s.restriction.mode = chosen<soak::Mode>(given, "mode", soak::mode_names());
  if (given.count("threads") > 0) s.restriction.threads = given["threads"].as<unsigned>();
  s.restriction.is_plain = given.count("plain") > 0;
  if (given.count("log") > 0) s.log = given["log"].as<std::string>();
  s.folder = given["folder"].as<std::string>();
  s.commit = given["commit"].as<std::string>();
  s.workers =
      given.count("workers") > 0 ? given["workers"].as<unsigned>() : std::thread::hardware_concurrency();
  s.workers = std::max(1u, s.workers);
  s.minimizing_seconds = given["minimize"].as<double>();
  return s;
}

std::string name_of(const soak::Soak_case& c) {
  const std::string arguments = soak::arguments_of(c);
  return c.family + " number " + std::to_string(c.seed) + (arguments.empty() ? "" : ' ' + arguments);
}

/// With dashes for what is no letter.
std::string for_file_name(std::string words) {
  for (char& ch : words)
    if (std::isalnum(static_cast<unsigned char>(ch)) == 0) ch = '-';
  while (!words.empty() && words.back() == '-') words.pop_back();
  return words;
}

/// Writes an input that fails, smaller if it fails alone as well.
std::string write_failure(const Settings& s, const soak::Soak_case& c, const soak::Verdict& verdict) {
  const std::string kernel = soak::kernel_names()[static_cast<std::size_t>(c.kernel)];
  const std::string way = c.mode == soak::Mode::PSLG
                              ? soak::separation_names()[static_cast<std::size_t>(c.separation)]
                              : soak::mode_names()[static_cast<std::size_t>(c.mode)];
  const std::string file = s.folder + '/' + c.family + '_' + kernel + '_' + way + '_' +
                           for_file_name(verdict.kind.substr(0, 40)) + '_' + std::to_string(c.seed) + ".poly";
  const soak::Soak_case smaller =
      s.minimizing_seconds > 0 ? soak::minimized(c, verdict.kind, s.limits, s.minimizing_seconds) : c;
  soak::write_case(
      file, smaller,
      {verdict.kind, verdict.detail, "from " + name_of(c), "repeat: test/soak.sh --replay FILE"});
  return file;
}

std::string write_failure(const Settings& s, const soak::File_case& c, const soak::Verdict& verdict) {
  const soak::File_case smaller =
      s.minimizing_seconds > 0 ? soak::minimized(c, verdict.kind, s.limits.cpu_seconds, s.minimizing_seconds)
                               : c;
  return soak::write_case(s.folder + "/files_" + for_file_name(verdict.kind) + '_' + std::to_string(c.seed),
                          smaller, verdict);
}

class Soak {
public:
  explicit Soak(Settings settings) : s_(std::move(settings)), end_(wall_seconds() + 60 * s_.minutes) {}

  int run() {
    const std::size_t most = s_.inputs > 0 ? s_.inputs : std::numeric_limits<std::size_t>::max();
    for (std::size_t first = 0; first < most && has_time(); first += round_)
      run_round(first, std::min(round_, most - first));
    std::cout << tally_.number_of_inputs() << " inputs: " << tally_.number_of(soak::Outcome::MET) << " met, "
              << tally_.number_of(soak::Outcome::UNMET) << " unmet, "
              << tally_.number_of(soak::Outcome::REFUSED) << " refused, "
              << tally_.number_of(soak::Outcome::FAILED) << " failed\n";
    return tally_.number_of(soak::Outcome::FAILED) == 0 ? 0 : 1;
  }

private:
  /// After so many inputs the log is written and failures are made smaller; a child of this process judges so many.
  static constexpr std::size_t round_ = 10000, batch_ = 20;
  /// Of failures of one kind, family, kernel, separation and mode so many are written.
  static constexpr std::size_t written_of_a_kind_ = 2;
  struct Failure {
    std::size_t number;
    soak::Verdict verdict;
  };

  Settings s_;
  double end_;
  soak::Tally tally_;
  std::map<std::string, std::size_t> written_;

  bool has_time() const { return s_.inputs > 0 || wall_seconds() < end_; }

  const soak::Family& family(std::size_t i) const { return s_.families[i % s_.families.size()]; }
  std::uint64_t number(std::size_t i) const { return 1000000 * s_.seed + i / s_.families.size(); }
  bool is_of_files(std::size_t i) const { return family(i).make == nullptr; }

  soak::Soak_case make(std::size_t i) const { return soak::make_case(family(i), number(i), s_.restriction); }

  soak::Verdict judge(std::size_t i) const {
    if (is_of_files(i)) return soak::judge(soak::make_file_case(number(i)), s_.limits.cpu_seconds);
    return soak::judge(make(i));
  }

  /// What the log and the screen say of it.
  soak::Soak_case described(std::size_t i) const {
    if (!is_of_files(i)) return make(i);
    soak::Soak_case c;
    c.family = family(i).name;
    c.seed = number(i);
    return c;
  }

  void run_round(std::size_t first, std::size_t n) {
    std::vector<Failure> failures;
    soak::Tally tally;
    const auto done = [&](std::size_t i, const soak::Result& result) {
      const soak::Soak_case c = described(first + i);
      tally.add(c, result);
      if (result.verdict.outcome != soak::Outcome::FAILED) return;
      if (written_[c.family + arguments_of_kind(c) + result.verdict.kind]++ < written_of_a_kind_)
        failures.push_back({first + i, result.verdict});
      std::cout << "failed: " << name_of(c) << ": " << result.verdict.kind << ": " << result.verdict.detail
                << std::endl;
    };
    soak::run_in_batches(
        n, s_.workers, batch_, s_.limits, [&](std::size_t i) { return judge(first + i); }, done,
        [&] { return has_time(); });
    tally_.add(tally);
    if (!s_.log.empty()) {
      std::ofstream log(s_.log, std::ios::app);
      tally.write(log, s_.commit, s_.seed);
    }
    write(failures);
  }

  static std::string arguments_of_kind(const soak::Soak_case& c) {
    soak::Soak_case plain;
    plain.kernel = c.kernel, plain.separation = c.separation, plain.mode = c.mode;
    return ' ' + soak::arguments_of(plain) + ' ';
  }

  std::string write(const Failure& failure) const {
    if (is_of_files(failure.number))
      return write_failure(s_, soak::make_file_case(number(failure.number)), failure.verdict);
    return write_failure(s_, make(failure.number), failure.verdict);
  }

  void write(const std::vector<Failure>& failures) {
    if (failures.empty()) return;
    std::filesystem::create_directories(s_.folder);
    // A process that makes inputs smaller waits for its own children most of the time.
    soak::run_in_batches(
        failures.size(), s_.workers, 1, soak::Limits{s_.minimizing_seconds + 600, 4},
        [&](std::size_t i) {
          return soak::Verdict{soak::Outcome::MET, "", write(failures[i])};
        },
        [&](std::size_t, const soak::Result& result) {
          std::cout << "written: " << result.verdict.detail << std::endl;
        },
        [] { return true; });
  }
};

int replay(const std::vector<std::string>& written, const soak::Limits& limits) {
  int status = 0;
  for (const std::string& file : written) {
    const soak::Result result = soak::run_alone(limits, [&] { return soak::judge(soak::read_case(file)); });
    constexpr const char* words[] = {"met", "unmet", "refused", "failed"};
    std::cout << file << ": " << words[static_cast<std::size_t>(result.verdict.outcome)] << ' '
              << result.verdict.kind << ": " << result.verdict.detail << " (" << result.seconds << " s, "
              << result.megabytes << " MB)" << std::endl;
    if (result.verdict.outcome == soak::Outcome::FAILED) status = 1;
  }
  return status;
}

} // namespace

int main(int argc, char** argv) try {
  const po::options_description options = described_options();
  po::variables_map given;
  po::store(po::parse_command_line(argc, argv, options), given);
  if (given.count("help") > 0) {
    std::cout << "usage: soak [option]...\n\n"
              << options << "\nExit status: 0 without failures, 1 with, 2 bad usage.\n";
    return 0;
  }
  if (given.count("list") > 0) {
    for (const soak::Family& family : families_and_files()) std::cout << family.name << '\n';
    return 0;
  }
  if (given.count("docs") > 0) {
    soak::write_page(std::cout, given["docs"].as<std::vector<std::string>>());
    return 0;
  }
  const Settings settings = settings_of(given);
  if (given.count("replay") > 0)
    return replay(given["replay"].as<std::vector<std::string>>(), settings.limits);
  std::cout << "seed " << settings.seed << std::endl;
  return Soak(settings).run();
} catch (const std::exception& error) {
  std::cerr << "soak: error: " << error.what() << '\n';
  return 2;
}
