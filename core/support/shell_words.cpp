#include "shell_words.hpp"

#include <algorithm>
#include <utility>

namespace pardel {

Result<std::vector<std::string>> split_words(std::string_view line) {
  std::vector<std::string> words;
  bool in_word = false;
  char quote = '\0';
  const auto put = [&](char c) {
    if (!in_word) words.emplace_back();
    in_word = true;
    words.back() += c;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote == '\0' && (c == ' ' || c == '\t' || c == '\n')) {
      in_word = false;
    } else if (quote == '\0' && (c == '\'' || c == '"')) {
      if (!in_word) words.emplace_back();  // '' is an empty word
      in_word = true;
      quote = c;
    } else if (c == quote && quote != '\0') {
      quote = '\0';
    } else if (c == '\\' && quote != '\'') {
      if (++i == line.size()) return Error{ErrorKind::usage, "a \\ at the end of the command"};
      if (quote == '"' && line[i] != '"' && line[i] != '\\') put('\\');
      put(line[i]);
    } else {
      put(c);
    }
  }
  if (quote != '\0') return Error{ErrorKind::usage, std::string("an open ") + quote + " in the command"};
  return words;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  return text;
}

std::string filled_in(std::string_view text, std::span<const std::pair<std::string_view, std::string>> placeholders) {
  std::string result;
  while (!text.empty()) {
    const auto found =
        std::ranges::find_if(placeholders, [&](const auto& each) { return text.starts_with(each.first); });
    const bool is_placeholder = found != placeholders.end();
    if (is_placeholder)
      result += found->second;
    else
      result += text.front();
    text.remove_prefix(is_placeholder ? found->first.size() : 1);
  }
  return result;
}

}  // namespace pardel
