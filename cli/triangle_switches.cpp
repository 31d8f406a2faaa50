#include "triangle_switches.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string_view>
#include <utility>

namespace pardel::cli {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The length of an exponent such as "e-05" at the start of the text; 0 if there is none.
std::size_t length_of_exponent(std::string_view text) {
  if (text.empty() || (text[0] != 'e' && text[0] != 'E')) return 0;
  const std::size_t sign = text.size() > 1 && (text[1] == '+' || text[1] == '-') ? 1 : 0;
  std::size_t length = 1 + sign;
  while (length < text.size() && is_digit(text[length])) ++length;
  return length > 1 + sign ? length : 0;
}

/// Removes the number at the start of `rest` and returns it, if there is one. As in Triangle a number consists of
/// digits and points: "a0.1e" is the switch a with 0.1, then the switch e. Other than in Triangle, it may have an
/// exponent, as Python writes it: "a1e-05".
template <class Number>
std::optional<Number> take_number(std::string_view& rest) {
  std::size_t length = 0;
  const auto part_of_number = [](char c) { return is_digit(c) || (std::is_floating_point_v<Number> && c == '.'); };
  while (length < rest.size() && part_of_number(rest[length])) ++length;
  if (std::is_floating_point_v<Number> && length > 0) length += length_of_exponent(rest.substr(length));
  Number value{};
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + length, value);
  const bool whole = error == std::errc() && end == rest.data() + length;
  if (length == 0 || !whole) return std::nullopt;
  rest.remove_prefix(length);
  return value;
}

bool begins_with_number(std::string_view rest) { return !rest.empty() && (is_digit(rest[0]) || rest[0] == '.'); }

/// What a switch of Triangle does that pardel does not support; null for any other letter.
const char* unsupported(char letter) {
  switch (letter) {
    case 'u':
      return "a user-defined test of triangles, which Triangle has to be compiled with";
    case 'v':
      return "a Voronoi diagram";
    case 'w':
    case 'W':
      return "a weighted Delaunay triangulation";
    default:
      return nullptr;
  }
}

/// The switches without a number, with the members that they set.
constexpr std::pair<char, bool TriangleSwitches::*> flags[] = {
    {'p', &TriangleSwitches::poly},
    {'r', &TriangleSwitches::refine},
    {'A', &TriangleSwitches::region_attributes},
    {'c', &TriangleSwitches::convex_hull},
    {'j', &TriangleSwitches::jettison},
    {'e', &TriangleSwitches::edges},
    {'n', &TriangleSwitches::neighbours},
    {'g', &TriangleSwitches::off},
    {'B', &TriangleSwitches::no_markers},
    {'P', &TriangleSwitches::no_poly},
    {'N', &TriangleSwitches::no_node},
    {'E', &TriangleSwitches::no_ele},
    {'I', &TriangleSwitches::no_iteration},
    {'O', &TriangleSwitches::no_holes},
    {'z', &TriangleSwitches::zero_based},
    {'C', &TriangleSwitches::check},
    {'Q', &TriangleSwitches::quiet},
    {'h', &TriangleSwitches::help},
    {'H', &TriangleSwitches::help},
    {'?', &TriangleSwitches::help},
};

Error wrong_switch(const std::string& message) { return {ErrorKind::usage, message + " (see 'pardel triangle -h')"}; }

/// Reads one switch with its number and removes both from `rest`.
Status take_switch(TriangleSwitches& s, std::string_view& rest) {
  const char letter = rest.front();
  rest.remove_prefix(1);
  for (const auto& [flag, member] : flags) {
    if (flag != letter) continue;
    s.*member = true;
    return Done{};
  }
  switch (letter) {
    case 'q':
      s.quality = true;
      s.min_angle_deg = 20;
      if (begins_with_number(rest)) {
        const std::optional<double> angle = take_number<double>(rest);
        if (!angle) return wrong_switch(fmt::format("switch q: '{}' does not begin with a number", rest));
        s.min_angle_deg = *angle;
      }
      return Done{};
    case 'a':
      s.quality = true;
      if (!begins_with_number(rest)) {
        s.area_caps = true;
        return Done{};
      }
      s.max_area = take_number<double>(rest);
      if (!s.max_area) return wrong_switch(fmt::format("switch a: '{}' does not begin with a number", rest));
      if (*s.max_area <= 0) return wrong_switch("switch a: the largest area must be greater than 0");
      return Done{};
    case 'D':
    case 'L':
      s.quality = s.conforming = true;
      return Done{};
    case 'o':
      if (!rest.empty() && rest.front() == '2') {
        s.second_order = true;
        rest.remove_prefix(1);
      }
      return Done{};
    case 'Y':
      ++s.no_splits;
      return Done{};
    case 'S':
      s.max_steiner_points = take_number<unsigned long long>(rest).value_or(0);
      return Done{};
    case 'V':
      ++s.verbose;
      return Done{};
    case 'i':
    case 'F':
    case 'l':
    case 's':
    case 'X':
      s.without_effect += letter;
      return Done{};
    default:
      if (const char* what = unsupported(letter)) {
        return wrong_switch(fmt::format("switch {} is not supported: {}", letter, what));
      }
      return wrong_switch(fmt::format("'{}' is not a switch of Triangle", letter));
  }
}

/// Sets the switch that the suffix of FILE implies.
void take_suffix(TriangleSwitches& s) {
  constexpr std::array<std::string_view, 4> suffixes = {".node", ".poly", ".ele", ".area"};
  for (const std::string_view suffix : suffixes) {
    if (!s.name.ends_with(suffix) || s.name.size() == suffix.size()) continue;
    s.name.resize(s.name.size() - suffix.size());
    if (suffix == ".poly") s.poly = true;
    if (suffix == ".ele" || suffix == ".area") s.refine = true;
    if (suffix == ".area") s.quality = s.area_caps = true;
    return;
  }
}

}  // namespace

Result<TriangleSwitches> parse_triangle_switches(const std::vector<std::string>& arguments) {
  TriangleSwitches switches;
  switches.command = "pardel triangle";
  for (const std::string& argument : arguments) {
    switches.command += ' ' + argument;
    if (argument == "--help") {
      switches.help = true;
    } else if (argument.size() > 1 && argument.front() == '-') {
      for (std::string_view rest = std::string_view(argument).substr(1); !rest.empty();) {
        if (Status taken = take_switch(switches, rest); !taken) return taken.error();
      }
    } else if (!switches.name.empty()) {
      return wrong_switch(fmt::format("two files: '{}' and '{}'", switches.name, argument));
    } else {
      switches.name = argument;
    }
  }
  if (switches.help) return switches;
  // The command becomes one line of a file.
  std::replace_if(
      switches.command.begin(), switches.command.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  if (switches.name.empty()) return wrong_switch("no input file");
  take_suffix(switches);
  if (switches.refine && switches.no_iteration) {
    return wrong_switch("with switch r, switch I would replace the mesh that is refined");
  }
  return switches;
}

}  // namespace pardel::cli
