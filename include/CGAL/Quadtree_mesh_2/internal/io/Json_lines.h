// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

// Where the values of a JSON text are.
//
// Computes: what a text of JSON says, and the line where a value begins or where the text cannot be parsed.
//           nlohmann-json keeps no lines, and they are wanted only to report an error.
// Bound:    Linear: one search for the value in what was parsed, and one pass over the text up to its place.
//           Parsing takes a logarithm more for objects with many keys, because keys are looked up.

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_IO_JSON_LINES_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_IO_JSON_LINES_H

#include <CGAL/Quadtree_mesh_2/internal/io/printable.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

/// A step from a value to a part of it: the key in an object, or the index in an array.
struct Json_step {
  std::string key;
  std::size_t index = 0;
  bool operator==(const Json_step& other) const { return key == other.key && index == other.index; }
};
using Json_path = std::vector<Json_step>;

/// The way from the root to one of its parts, which is told by its address; empty if it is none. A stack of its own
/// stands for recursion, as text may be nested as deep as it is long.
inline Json_path path_to(const nlohmann::json& root, const nlohmann::json& part) {
  struct Level {
    const nlohmann::json* value;
    nlohmann::json::const_iterator next;
    std::size_t index;
  };
  std::vector<Level> levels{{&root, root.begin(), 0}};
  while (!levels.empty() && levels.back().value != &part) {
    Level& level = levels.back();
    if (!level.value->is_structured() || level.next == level.value->end()) {
      levels.pop_back();
      if (!levels.empty()) ++levels.back().next, ++levels.back().index;
    } else {
      levels.push_back({&*level.next, level.next->begin(), 0});
    }
  }
  Json_path path;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    const bool is_object = levels[i].value->is_object();
    path.push_back({is_object ? levels[i].next.key() : std::string(), is_object ? 0 : levels[i].index});
  }
  return path;
}

/// Goes through a text as it is parsed, until a value is found; what nlohmann-json calls a SAX handler.
class Json_place_finder {
public:
  explicit Json_place_finder(const Json_path& path) : path_(path) {}

  bool null() { return shall_go_on(); }
  bool boolean(bool) { return shall_go_on(); }
  bool number_integer(nlohmann::json::number_integer_t) { return shall_go_on(); }
  bool number_unsigned(nlohmann::json::number_unsigned_t) { return shall_go_on(); }
  bool number_float(nlohmann::json::number_float_t, const std::string&) { return shall_go_on(); }
  bool string(std::string&) { return shall_go_on(); }
  bool binary(nlohmann::json::binary_t&) { return shall_go_on(); }
  bool start_object(std::size_t) { return begin_part(Part::OBJECT); }
  bool start_array(std::size_t) { return begin_part(Part::ARRAY); }
  bool key(std::string& key) {
    place_.back().key = key;
    return true;
  }
  bool end_object() { return end_part(); }
  bool end_array() { return end_part(); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) { return false; }

private:
  enum class Part { OBJECT, ARRAY };

  /// At a value: false if it is the one.
  bool shall_go_on() {
    if (place_.size() == path_.size() && std::equal(place_.begin(), place_.end(), path_.begin()))
      return false;
    go_to_next();
    return true;
  }
  bool begin_part(Part part) {
    if (place_.size() == path_.size() && std::equal(place_.begin(), place_.end(), path_.begin()))
      return false;
    place_.emplace_back();
    parts_.push_back(part);
    return true;
  }
  bool end_part() {
    place_.pop_back();
    parts_.pop_back();
    go_to_next();
    return true;
  }
  void go_to_next() {
    if (!parts_.empty() && parts_.back() == Part::ARRAY) ++place_.back().index;
  }

  const Json_path& path_;
  Json_path place_;
  std::vector<Part> parts_;
};

/// Reads characters and tells how far.
class Watched_character {
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Watched_character(const char* at, const char*& last) : at_(at), last_(&last) {}
  reference operator*() const { return *at_; }
  Watched_character& operator++() {
    *last_ = at_++;
    return *this;
  }
  Watched_character operator++(int) {
    const Watched_character before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const Watched_character& a, const Watched_character& b) { return a.at_ == b.at_; }
  friend bool operator!=(const Watched_character& a, const Watched_character& b) { return a.at_ != b.at_; }

private:
  const char* at_;
  const char** last_;
};

/// The line, counted from 1, where the value at the end of a path begins.
inline std::size_t line_in_json(const std::string& text, const Json_path& path) {
  const char* const begin = text.data();
  const char* last = begin;
  Json_place_finder finder(path);
  nlohmann::json::sax_parse(Watched_character(begin, last), Watched_character(begin + text.size(), last),
                            &finder);
  return 1 + static_cast<std::size_t>(std::count(begin, last, '\n'));
}

/// A key that an object has twice; the message names it.
struct Repeated_json_key : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Refuses keys that an object already has. nlohmann-json would keep one of them. It is told of every part as
/// it is parsed.
class Json_key_watch {
public:
  /// \throws Repeated_json_key
  void operator()(nlohmann::json::parse_event_t event, const nlohmann::json& part) {
    using Event = nlohmann::json::parse_event_t;
    if (event == Event::object_start) keys_of_open_objects_.emplace_back();
    if (event == Event::object_end) keys_of_open_objects_.pop_back();
    if (event == Event::key && !keys_of_open_objects_.back().insert(part.get<std::string>()).second)
      throw Repeated_json_key("the key " + in_quotes(part.get<std::string>()) +
                              " appears twice in one object");
  }

private:
  std::vector<std::set<std::string>> keys_of_open_objects_;
};

/// What nlohmann-json says of an error, without its own name for it and without the line, which the caller tells.
inline std::string json_error_text(const nlohmann::json::exception& error) {
  const std::string_view text =
      error.what(); // "[json.exception.parse_error.101] parse error at line 2, column 7: ..."
  const std::string_view words = text.substr(text.find("] ") + 2);
  const std::size_t column = words.find("column ");
  return std::string(words.rfind("parse error at line ", 0) == 0 ? words.substr(column) : words);
}

/// Parses a text, in which no key may appear twice in an object.
/// \param line where parsing ended, counted from 1: that of the culprit if it throws
/// \throws nlohmann::json::exception, Repeated_json_key
inline nlohmann::json parse_json(const std::string& text, std::size_t& line) {
  const char* const begin = text.data();
  const char* last = begin;
  const auto count_lines = [&] { line = 1 + static_cast<std::size_t>(std::count(begin, last, '\n')); };
  Json_key_watch watch;
  try {
    nlohmann::json root =
        nlohmann::json::parse(Watched_character(begin, last), Watched_character(begin + text.size(), last),
                              [&](int, nlohmann::json::parse_event_t event, const nlohmann::json& part) {
                                watch(event, part);
                                return true;
                              });
    count_lines();
    return root;
  } catch (...) {
    count_lines();
    throw;
  }
}

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_IO_JSON_LINES_H
