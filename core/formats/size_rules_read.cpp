// Reads the file of --sources: one rule per line, `point X Y LENGTH`, `marker M LENGTH` or `region R LENGTH`.
#include <limits>
#include <string>

#include "../formats.hpp"
#include "../support/shortest.hpp"
#include "text_reader.hpp"

namespace pardel {
using namespace files;
namespace {

double length(TextReader& in) {
  const double value = in.number("a length");
  if (!(value > 0)) in.fail("expected a length greater than 0, found " + shortest(value));
  return value;
}

void read_rule(TextReader& in, SizeRules& rules) {
  const std::size_t line = in.line();
  const std::string kind(in.word());
  if (kind == "point") {
    const double x = in.number("x"), y = in.number("y");
    rules.points.push_back({{x, y}, length(in)});
  } else if (kind == "marker") {
    using Limits = std::numeric_limits<int>;
    const auto marker = static_cast<int>(in.integer("a marker", Limits::min(), Limits::max()));
    rules.markers.push_back({marker, length(in), line});
  } else if (kind == "region") {
    const double attribute = in.number("the attribute of a region");
    rules.regions.push_back({attribute, length(in), line});
  } else {
    in.fail("expected 'point', 'marker' or 'region', found " + in_quotes(kind));
  }
  if (in.has_field()) in.fail("expected the end of the line, found " + in_quotes(in.word()));
}

}  // namespace

Result<SizeRules> read_size_rules(const std::filesystem::path& file) {
  const auto text = read_file(file);
  if (!text.ok()) return text.error();
  TextReader in(*text, file.string());
  SizeRules rules;
  while (in.next_line()) read_rule(in, rules);
  if (rules.empty()) in.fail("expected a rule: 'point X Y LENGTH', 'marker M LENGTH' or 'region R LENGTH'");
  if (in.failed()) return in.error();
  return rules;
}

}  // namespace pardel
