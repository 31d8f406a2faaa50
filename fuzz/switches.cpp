// The switches of `pardel triangle`. The bytes select switches one by one, so what they mean is known, and they are
// written behind each other in any grouping; the parser must find exactly these. Bytes that begin with a minus are
// parsed as a command line; an error must be one of usage, and the switches that were found, written in a fixed order,
// must be found again.
#include <charconv>
#include <sstream>
#include <string>

#include "../cli/triangle_switches.hpp"
#include "fuzz_one.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

using cli::TriangleSwitches;
using Flag = bool TriangleSwitches::*;

/// The switches without a number.
constexpr std::pair<char, Flag> flags[] = {{'p', &TriangleSwitches::poly},
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
                                           {'Q', &TriangleSwitches::quiet}};

/// The shortest decimal that gives the same double, without an exponent: Triangle's numbers have none.
std::string decimal(double x) {
  char digits[400];
  const auto end = std::to_chars(digits, digits + sizeof digits, x, std::chars_format::fixed).ptr;
  return {digits, end};
}

/// All members except for the command line itself.
bool same(const TriangleSwitches& a, const TriangleSwitches& b) {
  bool is_same = a.quality == b.quality && a.min_angle_deg == b.min_angle_deg && a.max_area == b.max_area &&
                 a.area_caps == b.area_caps && a.conforming == b.conforming && a.second_order == b.second_order &&
                 a.no_splits == b.no_splits && a.max_steiner_points == b.max_steiner_points && a.verbose == b.verbose &&
                 a.help == b.help && a.without_effect == b.without_effect && a.name == b.name;
  for (const auto& [letter, flag] : flags) is_same &= a.*flag == b.*flag;
  return is_same;
}

/// A command line with the same meaning. Precondition: no help is asked for.
std::vector<std::string> arguments_of(const TriangleSwitches& s) {
  std::string text = "-";
  for (const auto& [letter, flag] : flags)
    if (s.*flag) text += letter;
  if (s.max_area) text += "a" + decimal(*s.max_area);
  if (s.area_caps) text += "a";
  if (s.conforming) text += "D";
  if (s.second_order) text += "o2";
  text +=
      std::string(static_cast<std::size_t>(s.no_splits), 'Y') + std::string(static_cast<std::size_t>(s.verbose), 'V');
  if (s.max_steiner_points) text += "S" + std::to_string(*s.max_steiner_points);
  // With an angle of zero, q differs from nothing only in that points may be added, which a and D allow as well.
  if (s.quality && (s.min_angle_deg > 0 || (!s.max_area && !s.area_caps && !s.conforming)))
    text += "q" + decimal(s.min_angle_deg);
  text += s.without_effect;
  if (text == "-") return {s.name};
  return {text, s.name};
}

void parse_text(std::span<const std::uint8_t> bytes) {
  std::vector<std::string> arguments;
  std::istringstream words(std::string(bytes.begin(), bytes.end()));
  for (std::string word; words >> word;) arguments.push_back(word);
  const auto parsed = cli::parse_triangle_switches(arguments);
  if (!parsed) {
    if (parsed.error().kind != ErrorKind::usage || parsed.error().message.empty())
      fail("an error that is not one of usage: " + parsed.error().message);
    return;
  }
  // A suffix of FILE implies switches, and a name may end in two suffixes.
  const bool has_suffix = parsed->name.find('.') != std::string::npos;
  if (parsed->help || has_suffix || parsed->name.front() == '-') return;
  const auto again = cli::parse_triangle_switches(arguments_of(*parsed));
  if (!again) fail("the same switches in another order are refused: " + again.error().message);
  if (!same(*again, *parsed)) fail("the same switches in another order mean something else");
}

/// Chooses one switch, appends it to `text` and sets what it means.
void choose(Supply& bytes, std::string& text, TriangleSwitches& expected) {
  const auto kind = static_cast<std::size_t>(bytes.below(static_cast<int>(std::size(flags)) + 11));
  if (kind < std::size(flags)) {
    const auto& [letter, flag] = flags[kind];
    text += letter;
    expected.*flag = true;
    return;
  }
  const double number = bytes.byte() / 8.0;
  switch (kind - std::size(flags)) {
    case 0:
      text += "q" + decimal(number);
      expected.quality = true;
      expected.min_angle_deg = number;
      break;
    case 1:
      text += "q";
      expected.quality = true;
      expected.min_angle_deg = 20;
      break;
    case 2:
      text += "a" + decimal(number + 0.125);
      expected.quality = true;
      expected.max_area = number + 0.125;
      break;
    case 3:
      text += "a";
      expected.quality = expected.area_caps = true;
      break;
    case 4:
      text += bytes.flag(128) ? 'D' : 'L';
      expected.quality = expected.conforming = true;
      break;
    case 5:
      text += "o2";
      expected.second_order = true;
      break;
    case 6:
      text += "Y";
      ++expected.no_splits;
      break;
    case 7:
      text += "V";
      ++expected.verbose;
      break;
    case 8:
      expected.without_effect += "iFlsX"[bytes.below(5)];
      text += expected.without_effect.back();
      break;
    case 9:
      text += "S";
      expected.max_steiner_points = 0;
      break;
    default:
      text += "S" + std::to_string(static_cast<int>(number));
      expected.max_steiner_points = static_cast<unsigned>(number);
  }
}

/// Chooses a suffix of FILE, and sets the switch that it implies.
std::string choose_suffix(Supply& bytes, TriangleSwitches& expected) {
  std::string suffix = bytes.one_of<std::string>({"", ".node", ".poly", ".ele", ".area"});
  expected.poly |= suffix == ".poly";
  expected.refine |= suffix == ".ele" || suffix == ".area";
  expected.quality |= suffix == ".area";
  expected.area_caps |= suffix == ".area";
  return suffix;
}

void parse_chosen(Supply& bytes) {
  TriangleSwitches expected;
  std::vector<std::string> arguments;
  expected.name = "square";
  for (int n = 0; n < 20 && !bytes.empty(); ++n) {
    std::string text;
    choose(bytes, text, expected);
    if (arguments.empty() || bytes.flag(64)) arguments.emplace_back("-");
    arguments.back() += text;
  }
  arguments.push_back(expected.name + choose_suffix(bytes, expected));
  const auto parsed = cli::parse_triangle_switches(arguments);
  std::string line;
  for (const std::string& argument : arguments) line += " " + argument;
  if (expected.refine && expected.no_iteration) {
    if (parsed) fail("r and I together are accepted:" + line);
    return;
  }
  if (!parsed) fail("refused:" + line + ": " + parsed.error().message);
  if (!same(*parsed, expected)) fail("misunderstood:" + line);
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  Supply supply(bytes);
  if (!bytes.empty() && bytes.front() == '-')
    parse_text(bytes);
  else
    parse_chosen(supply);
  return 0;
}

}  // namespace pardel::fuzz
