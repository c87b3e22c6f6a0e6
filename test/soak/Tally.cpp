// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#include "Tally.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <ostream>

namespace soak {

namespace {

constexpr const char* outcome_names[] = {"met", "unmet", "refused", "failed"};

} // namespace

void Tally::Counts::add(const Counts& other) {
  for (std::size_t i = 0; i < of_outcome.size(); ++i) of_outcome[i] += other.of_outcome[i];
  seconds += other.seconds;
  worst_seconds = std::max(worst_seconds, other.worst_seconds);
  worst_megabytes = std::max(worst_megabytes, other.worst_megabytes);
}

void Tally::add(const Soak_case& c, const Result& result) {
  Counts one{{}, result.seconds, result.seconds, result.megabytes};
  one.of_outcome[static_cast<std::size_t>(result.verdict.outcome)] = 1;
  counts_[{c.family, kernel_names()[static_cast<std::size_t>(c.kernel)],
           c.mode == Mode::PSLG ? separation_names()[static_cast<std::size_t>(c.separation)] : "-",
           mode_names()[static_cast<std::size_t>(c.mode)]}]
      .add(one);
}

void Tally::add(const Tally& other) {
  for (const auto& [key, counts] : other.counts_) counts_[key].add(counts);
}

std::size_t Tally::number_of(Outcome outcome) const {
  std::size_t sum = 0;
  for (const auto& [key, counts] : counts_) sum += counts.of_outcome[static_cast<std::size_t>(outcome)];
  return sum;
}

std::size_t Tally::number_of_inputs() const {
  return number_of(Outcome::MET) + number_of(Outcome::UNMET) + number_of(Outcome::REFUSED) +
         number_of(Outcome::FAILED);
}

void Tally::write(std::ostream& out, const std::string& commit, std::uint64_t seed) const {
  for (const auto& [key, counts] : counts_) {
    nlohmann::ordered_json line = {{"commit", commit}, {"seed", seed},         {"family", key[0]},
                                   {"kernel", key[1]}, {"separation", key[2]}, {"mode", key[3]}};
    for (std::size_t i = 0; i < counts.of_outcome.size(); ++i) line[outcome_names[i]] = counts.of_outcome[i];
    line["seconds"] = counts.seconds;
    line["worst_seconds"] = counts.worst_seconds;
    line["worst_megabytes"] = counts.worst_megabytes;
    out << line.dump() << '\n';
  }
  out.flush();
}

} // namespace soak
