// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors
//
// Text files broken in the ways in which files break: bytes flipped, words lost, doubled, swapped or moved together,
// lines lost, the end cut off, numbers made extreme. The same for each seed.

#ifndef QUADTREE_MESH_2_TEST_MUTATE_TEXT_H
#define QUADTREE_MESH_2_TEST_MUTATE_TEXT_H

#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

/// Makes texts that differ from a given one in one to four places.
class Text_mutator {
public:
  explicit Text_mutator(std::uint64_t seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
      constexpr std::array<void (Text_mutator::*)(std::string&), 10> ways{
          &Text_mutator::flip_bit,     &Text_mutator::set_byte,    &Text_mutator::drop_byte,
          &Text_mutator::drop_word,    &Text_mutator::repeat_word, &Text_mutator::swap_words,
          &Text_mutator::replace_word, &Text_mutator::drop_line,   &Text_mutator::repeat_line,
          &Text_mutator::cut_off};
      (this->*ways[below(ways.size())])(text);
    }
    return text;
  }

private:
  /// From the begin of a word to its end. Words are what blanks and marks divide, and the marks.
  using Span = std::pair<std::size_t, std::size_t>;

  std::size_t below(std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random_() % n); }

  static bool is_mark(char c) { return std::string("(),;:[]{}\"#").find(c) != std::string::npos; }
  static bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

  static std::vector<Span> words(const std::string& text) {
    std::vector<Span> result;
    for (std::size_t i = 0; i < text.size();) {
      std::size_t end = i + 1;
      if (!is_mark(text[i]) && !is_blank(text[i]))
        while (end < text.size() && !is_mark(text[end]) && !is_blank(text[end])) ++end;
      if (!is_blank(text[i])) result.push_back({i, end});
      i = end;
    }
    return result;
  }
  Span any_word(const std::string& text) {
    const std::vector<Span> all = words(text);
    return all.empty() ? Span(0, 0) : all[below(all.size())];
  }
  Span any_line(const std::string& text) {
    const std::size_t at = below(text.size());
    const std::size_t before = text.rfind('\n', at == 0 ? 0 : at - 1), behind = text.find('\n', at);
    const std::size_t begin = at == 0 || before == std::string::npos ? 0 : before + 1;
    return {begin, behind == std::string::npos ? text.size() : behind + 1};
  }
  static std::string part(const std::string& text, Span s) {
    return text.substr(s.first, s.second - s.first);
  }

  void flip_bit(std::string& text) {
    if (text.empty()) return;
    char& c = text[below(text.size())];
    c = static_cast<char>(static_cast<unsigned char>(c) ^ (1u << below(8)));
  }
  void set_byte(std::string& text) {
    constexpr char bytes[] =
        "0123456789+-.,;:eE#()[]{}\"'\\ \t\r\n\f\vnaifxzmZM\x7f\x80\xff"; // and the 0 at its end
    if (!text.empty()) text[below(text.size())] = bytes[below(sizeof bytes)];
  }
  void drop_byte(std::string& text) {
    if (!text.empty()) text.erase(below(text.size()), 1);
  }
  void drop_word(std::string& text) {
    const Span w = any_word(text);
    text.erase(w.first, w.second - w.first);
  }
  void repeat_word(std::string& text) {
    const Span w = any_word(text);
    text.insert(w.first, part(text, w) + (below(2) == 0 ? " " : ""));
  }
  void swap_words(std::string& text) {
    Span v = any_word(text), w = any_word(text);
    if (w.first < v.first) std::swap(v, w);
    if (v.second > w.first) return;
    const std::string a = part(text, v), b = part(text, w);
    text.replace(w.first, b.size(), a);
    text.replace(v.first, a.size(), b);
  }
  void replace_word(std::string& text) {
    static const std::vector<std::string> words{"0",
                                                "-0",
                                                "-1",
                                                "1e999",
                                                "-1e999",
                                                "1e-999",
                                                "nan",
                                                "inf",
                                                "-inf",
                                                "1,5",
                                                "0x10",
                                                "1e308",
                                                "-1.7976931348623157e308",
                                                "5e-324",
                                                "2147483648",
                                                "-2147483649",
                                                "4294967295",
                                                "4294967296",
                                                "1000000000000",
                                                "9223372036854775807",
                                                "9223372036854775808",
                                                "18446744073709551616",
                                                "1e5",
                                                "+3",
                                                "--1",
                                                "1.",
                                                ".5",
                                                ".",
                                                "e",
                                                "1e",
                                                "EMPTY",
                                                "Z",
                                                "null",
                                                "true",
                                                "\"\"",
                                                "[]",
                                                "{}",
                                                "\"1\"",
                                                "POINT",
                                                "SRID=1;",
                                                "7 7",
                                                "9.5"};
    const Span w = any_word(text);
    text.replace(w.first, w.second - w.first, words[below(words.size())]);
  }
  void drop_line(std::string& text) {
    const Span l = any_line(text);
    text.erase(l.first, l.second - l.first);
  }
  void repeat_line(std::string& text) {
    const Span l = any_line(text);
    text.insert(l.first, part(text, l));
  }
  void cut_off(std::string& text) { text.resize(below(text.size())); }

  std::mt19937_64 random_;
};

#endif // QUADTREE_MESH_2_TEST_MUTATE_TEXT_H
