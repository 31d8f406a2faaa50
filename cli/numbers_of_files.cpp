#include "numbers_of_files.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

namespace pardel::cli {
namespace {

enum class Noun : std::uint8_t { none, vertex, edge, triangle, input };

/// What the next number is: after a noun, or after "to", "and" or "lists" if the number before them was one of
/// `before`.
Noun named_by(std::string_view word, Noun before) {
  constexpr std::array<std::pair<std::string_view, Noun>, 10> nouns = {{{"vertex", Noun::vertex},
                                                                        {"vertices", Noun::vertex},
                                                                        {"edge", Noun::edge},
                                                                        {"edges", Noun::edge},
                                                                        {"triangle", Noun::triangle},
                                                                        {"triangles", Noun::triangle},
                                                                        {"point", Noun::input},
                                                                        {"segment", Noun::input},
                                                                        {"hole", Noun::input},
                                                                        {"region", Noun::input}}};
  const auto* const found = std::ranges::find(nouns, word, &std::pair<std::string_view, Noun>::first);
  if (found != nouns.end()) return found->second;
  return word == "to" || word == "and" || word == "lists" ? before : Noun::none;
}

/// The number at the beginning of the text, which then begins after it.
std::optional<std::uint64_t> take_number(std::string_view& text) {
  std::uint64_t number = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (status != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return number;
}

/// What may follow a number in a sentence.
bool is_end(std::string_view rest) { return rest.empty() || rest == "," || rest == ":"; }

}  // namespace

std::uint64_t NumbersOfFiles::vertex(std::uint64_t index) const {
  return mesh_ != nullptr && index < mesh_->points.size() ? number_in_file(*mesh_, static_cast<Index>(index)) : index;
}

std::uint64_t NumbersOfFiles::triangle(std::uint64_t index) const {
  return mesh_ != nullptr ? index + static_cast<unsigned>(mesh_->first_id.value) : index;
}

std::uint64_t NumbersOfFiles::of_input(std::uint64_t index) const {
  return index + static_cast<unsigned>(of_domain_.value);
}

std::string NumbersOfFiles::in_sentence(std::string_view sentence) const {
  const auto number = [this](std::uint64_t index, Noun noun) {
    return std::to_string(noun == Noun::vertex || noun == Noun::edge ? vertex(index)
                          : noun == Noun::triangle                   ? triangle(index)
                                                                     : of_input(index));
  };
  /// The word with other numbers; empty if it is no number of such a thing.
  const auto renumbered = [&](std::string_view word, Noun noun) -> std::string {
    const auto first = noun == Noun::none ? std::nullopt : take_number(word);
    if (!first) return {};
    std::string text = number(*first, noun);
    if (noun == Noun::edge) {
      if (!word.starts_with('-')) return {};
      word.remove_prefix(1);
      const auto second = take_number(word);
      if (!second) return {};
      text += '-' + number(*second, noun);
    }
    return is_end(word) ? text.append(word) : std::string();
  };
  std::string text;
  Noun next = Noun::none, last = Noun::none;  // what the next number is, and what the one was with which `text` ends
  while (!sentence.empty()) {
    const std::size_t end = std::min(sentence.find(' '), sentence.size());
    const std::string_view word = sentence.substr(0, end);
    const std::string changed = renumbered(word, next);
    const Noun now = changed.empty() ? named_by(word, last) : Noun::none;
    last = changed.empty() ? Noun::none : next;
    next = now;
    text.append(changed.empty() ? word : changed);
    const std::size_t blank = std::min<std::size_t>(1, sentence.size() - end);
    text.append(sentence.substr(end, blank));
    sentence.remove_prefix(end + blank);
  }
  return text;
}

}  // namespace pardel::cli
