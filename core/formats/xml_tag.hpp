// The tags of an XML file.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace pardel::files {

inline constexpr std::string_view xml_blanks = " \t\r\n";

/// A start tag or an end tag.
struct XmlTag {
  std::string_view name;
  std::string_view attributes;
  std::size_t end = 0;  ///< the position after the '>' of the tag
  bool closed = false;  ///< the tag has the form <.../>

  /// The value of an attribute, as it is written; empty if the tag does not have it. A value that does not end is all
  /// that follows, so that it is noticed.
  [[nodiscard]] std::string_view operator[](std::string_view key) const {
    std::string_view rest = attributes;
    const auto skip_blanks = [&] { rest.remove_prefix(std::min(rest.find_first_not_of(xml_blanks), rest.size())); };
    for (skip_blanks(); !rest.empty(); skip_blanks()) {
      const std::string_view attribute = rest.substr(0, rest.find_first_of(" \t\r\n="));
      rest.remove_prefix(attribute.size());
      skip_blanks();
      if (!rest.starts_with('=')) continue;
      rest.remove_prefix(1);
      skip_blanks();
      if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) continue;
      const std::string_view value = rest.substr(1, rest.find(rest[0], 1) - 1);
      if (attribute == key) return value;
      rest.remove_prefix(std::min(value.size() + 2, rest.size()));
    }
    return {};
  }
};

/// The position of the '>' that ends the tag at text[at]. A quoted value may contain '>', but not '<'.
[[nodiscard]] inline std::size_t end_of_xml_tag(std::string_view text, std::size_t at) {
  const std::string_view tag = text.substr(0, text.find('<', at + 1));
  std::size_t end = tag.find_first_of(">\"'", at);
  while (end != std::string_view::npos && tag[end] != '>') {
    const std::size_t end_of_value = tag.find(tag[end], end + 1);
    end = end_of_value == std::string_view::npos ? end_of_value : tag.find_first_of(">\"'", end_of_value + 1);
  }
  return std::min(end != std::string_view::npos ? end : text.find('>', at), text.size());
}

/// The tag whose '<' is text[at].
[[nodiscard]] inline XmlTag xml_tag_at(std::string_view text, std::size_t at) {
  const std::size_t close = end_of_xml_tag(text, at);
  XmlTag tag;
  std::string_view inside = text.substr(at + 1, close - at - 1);
  tag.end = std::min(close + 1, text.size());
  tag.closed = inside.ends_with('/');
  if (tag.closed) inside.remove_suffix(1);
  tag.name = inside.substr(0, inside.find_first_of(xml_blanks));
  tag.attributes = inside.substr(tag.name.size());
  return tag;
}

/// The position of the first tag from `at` on that is not in a comment; npos if there is none.
[[nodiscard]] inline std::size_t next_xml_tag(std::string_view text, std::size_t at) {
  for (at = text.find('<', at); at != std::string_view::npos && text.substr(at).starts_with("<!--");
       at = text.find('<', at)) {
    at = text.find("-->", at);
    if (at == std::string_view::npos) break;
  }
  return at;
}

inline constexpr std::array<std::pair<std::string_view, char>, 5> xml_entities = {
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};

/// The text that the value of an attribute stands for.
[[nodiscard]] inline std::string xml_text(std::string_view value) {
  std::string text;
  while (!value.empty()) {
    const auto* const entity =
        std::ranges::find_if(xml_entities, [&](const auto& each) { return value.starts_with(each.first); });
    text += entity == xml_entities.end() ? value[0] : entity->second;
    value.remove_prefix(entity == xml_entities.end() ? 1 : entity->first.size());
  }
  return text;
}

/// The value of an attribute that stands for the text. Control characters, which XML does not have, become blanks.
[[nodiscard]] inline std::string xml_value(std::string_view text) {
  std::string value;
  for (const char c : text) {
    const auto* const entity = std::ranges::find(xml_entities, c, [](const auto& each) { return each.second; });
    if (entity != xml_entities.end()) {
      value += entity->first;
    } else {
      value += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return value;
}

}  // namespace pardel::files
