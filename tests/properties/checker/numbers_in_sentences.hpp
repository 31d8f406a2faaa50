// The numbers of files in sentences of the checker, found by their words. The checker itself knows which numbers are
// those of things; a test that compares the two notices a number that the checker takes for a part of the words.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "../../../properties/checker/certificate.hpp"
#include "../../../properties/checker/witness.hpp"

namespace pardel::testing {

/// Numbers that tell things apart: vertices are 100, 107, 114, ..., triangles count from 1, and so do parts of the
/// domain unless another number is given.
inline NumbersInWitnesses numbers_of_some_file(int first_of_domain = 1) {
  static const std::vector<std::uint64_t> vertices = [] {
    std::vector<std::uint64_t> numbers;
    for (std::uint64_t v = 0; v < 1'000; ++v) numbers.push_back(100 + 7 * v);
    return numbers;
  }();
  return {.first_of_domain = first_of_domain, .first_triangle = 1, .first_vertex = 1, .vertices = vertices};
}

/// What the next number names: an edge has two numbers of vertices.
enum class Noun : std::uint8_t { none, vertex, edge, triangle, of_domain };

/// A number follows one blank after a noun; or after "to", "and" or "lists", if the number before them was one of
/// `before`.
inline Noun named_by(std::string_view word, std::string_view last_word, Noun before) {
  constexpr std::array<std::pair<std::string_view, Noun>, 9> nouns = {{{"vertex", Noun::vertex},
                                                                       {"edge", Noun::edge},
                                                                       {"edges", Noun::edge},
                                                                       {"triangle", Noun::triangle},
                                                                       {"triangles", Noun::triangle},
                                                                       {"point", Noun::of_domain},
                                                                       {"segment", Noun::of_domain},
                                                                       {"hole", Noun::of_domain},
                                                                       {"region", Noun::of_domain}}};
  const auto* const found = std::ranges::find(nouns, word, &std::pair<std::string_view, Noun>::first);
  if (found != nouns.end()) return found->second;
  if (last_word == "part" && word == "of") return Noun::of_domain;  // "lists segment 2 but is part of 0"
  return word == "to" || word == "and" || word == "lists" ? before : Noun::none;
}

/// The word with other numbers; empty if it is no number of such a thing. The one number behind "constrained edge" is a
/// place in a list.
inline std::string renumbered(std::string_view word, Noun what, const NumbersInWitnesses& numbers) {
  const Numbered kind = what == Noun::triangle    ? Numbered::triangle
                        : what == Noun::of_domain ? Numbered::of_domain
                                                  : Numbered::vertex;
  std::string text;
  const auto take_number = [&] {
    Index index = 0;
    const auto [stop, status] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (status != std::errc()) return false;
    text += std::to_string(numbers.number(kind, index));
    word.remove_prefix(static_cast<std::size_t>(stop - word.data()));
    return true;
  };
  const auto take = [&](char mark) {
    if (!word.starts_with(mark)) return false;
    word.remove_prefix(1);
    text += mark;
    return true;
  };
  const bool in_brackets = what == Noun::edge && take('(');
  if (!take_number()) return {};
  if (what == Noun::edge && !(take('-') && take_number())) return {};
  if (in_brackets && !take(')')) return {};
  return word.empty() || word == "," || word == ":" ? text.append(word) : std::string();
}

/// The sentence, in which things count from 0, with these numbers.
inline std::string in_sentence(std::string_view sentence, const NumbersInWitnesses& numbers) {
  std::string text;
  Noun next = Noun::none, last = Noun::none;  // what the next number is, and what the one was with which `text` ends
  std::string_view last_word;
  while (!sentence.empty()) {
    const std::size_t end = std::min(sentence.find(' '), sentence.size());
    const std::string_view word = sentence.substr(0, end);
    if (word.starts_with('(')) next = Noun::edge;
    const std::string changed = next == Noun::none ? std::string() : renumbered(word, next, numbers);
    const Noun now = changed.empty() ? named_by(word, last_word, last) : Noun::none;
    last = changed.empty() ? Noun::none : next;
    next = now;
    last_word = word;
    const std::size_t blank = std::min<std::size_t>(1, sentence.size() - end);
    text.append(changed.empty() ? word : changed).append(sentence.substr(end, blank));
    sentence.remove_prefix(end + blank);
  }
  return text;
}

/// Tests that the witnesses of a certificate name all things with the numbers of files.
inline void expect_numbers_of_files(const Certificate& certificate) {
  for (const NumbersInWitnesses& numbers : {numbers_of_some_file(), numbers_of_some_file(70'000)})
    for (const Violation& violation : certificate.violations)
      EXPECT_EQ(violation.witness.text(numbers), in_sentence(violation.witness.text(), numbers));
}

}  // namespace pardel::testing
