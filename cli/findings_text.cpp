#include "findings_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <new>
#include <numbers>
#include <optional>

#include "../core/support/doubled_area.hpp"
#include "beside_mesh.hpp"
#include "length.hpp"
#include "numbers_in_findings.hpp"
#include "verdict.hpp"

namespace pardel::cli {
namespace {

/// The angle at `p`, in degrees.
double angle(Point p, Point a, Point b) {
  const double dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
  return std::atan2(std::abs(doubled_area(p, a, b)), dot) * 180 / std::numbers::pi;
}

double longest_edge(const std::vector<Point>& p) {
  return std::max({length(p[0], p[1]), length(p[1], p[2]), length(p[2], p[0])});
}

double circumradius(const std::vector<Point>& p) {
  return length(p[0], p[1]) * length(p[1], p[2]) * length(p[2], p[0]) / (2 * std::abs(doubled_area(p[0], p[1], p[2])));
}

/// The value with three digits, or with as many as are needed to tell it from the bound.
std::string shown(double value, double bound) {
  for (int digits = 3; digits < 17; ++digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    double rounded = value;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    if (rounded != bound && (rounded < bound) == (value < bound)) return text;
  }
  return fmt::format("{}", value);
}

std::string above(const std::string& what, const char* quantity, double value, double bound) {
  return fmt::format("{}: {} {} is above {}", what, quantity, shown(value, bound), bound);
}

/// The text up to `mark`, where a proof with exact numbers begins; all of it if there is no such mark.
std::string before(const std::string& text, std::string_view mark) { return text.substr(0, text.find(mark)); }

/// The size at a point; nothing if the function throws.
std::optional<double> size_at(const Goal& goal, Point p) {
  try {
    return goal.size(p);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
    return std::nullopt;
  }
}

/// The place of a constrained edge in the list says nothing about its file. "constrained edge 5 (1-2) has ..." becomes
/// "constrained edge 1-2 has ...".
std::string named_by_its_ends(const std::string& witness) {
  const std::size_t begin = witness.find('('), end = witness.find(')');
  if (end == std::string::npos) return witness;
  return "constrained edge " + witness.substr(begin + 1, end - begin - 1) + witness.substr(end + 1);
}

std::string sentence(const Violation& violation, const Goal& goal, const NumbersInWitnesses& numbers,
                     double max_circumradius) {
  const std::vector<Index>& ids = violation.ids;
  const std::vector<Point>& p = violation.where;
  const std::string witness = violation.witness.text(numbers);
  const auto number = [&](Numbered what, std::size_t place) { return numbers.number(what, ids[place]); };
  const auto triangle = [&] { return fmt::format("triangle {}", number(Numbered::triangle, 0)); };
  const auto area = [&] { return std::abs(doubled_area(p[0], p[1], p[2])) / 2; };
  switch (violation.kind) {
    case ViolationKind::small_angle: {
      const double value = angle(p[0], p[1], p[2]);
      return fmt::format("{}: angle {}° is below {}°", triangle(), shown(value, goal.min_angle_deg),
                         goal.min_angle_deg);
    }
    case ViolationKind::large_area:
      return above(triangle(), "area", area(), goal.max_area);
    case ViolationKind::region_area:
      return fmt::format("{}: area {:.4g} is above{}", triangle(), area(), witness.substr(witness.rfind('>') + 1));
    case ViolationKind::long_edge:
      return above(fmt::format("edge {}-{} of triangle {}", number(Numbered::vertex, 0), number(Numbered::vertex, 1),
                               number(Numbered::triangle, 2)),
                   "length", length(p[0], p[1]), goal.max_edge);
    case ViolationKind::size_exceeded: {
      if (goal.grading < INFINITY || goal.feature_edges > 0)
        return fmt::format("{}: longest edge {:.4g} is above the size at its centroid", triangle(), longest_edge(p));
      const Point centroid{(p[0].x + p[1].x + p[2].x) / 3, (p[0].y + p[1].y + p[2].y) / 3};
      const std::optional<double> size = size_at(goal, centroid);
      if (!size) return fmt::format("{}: the sizes have no value at its centroid", triangle());
      return fmt::format("{}: longest edge {} is above {:.4g}, the size at its centroid", triangle(),
                         shown(longest_edge(p), *size), *size);
    }
    case ViolationKind::large_circumradius:
      return above(triangle(), "circumradius", circumradius(p), max_circumradius);
    case ViolationKind::not_delaunay:
      return before(witness, ", in-circle determinant");
    case ViolationKind::chain_off_segment:
      return fmt::format("vertex {} lies too far from segment {}", number(Numbered::vertex, 0),
                         number(Numbered::of_domain, 1));
    case ViolationKind::wrong_constrained_edge:
    case ViolationKind::wrong_edge_marker:
      return named_by_its_ends(witness);
    case ViolationKind::overlap:
      return before(witness, ": the ends of each");
    default:
      return witness;
  }
}

/// True if the place itself is what is wrong. A few digits would not show by how much.
bool is_of_a_point(ViolationKind kind) {
  return kind == ViolationKind::missing_input_vertex || kind == ViolationKind::chain_off_segment;
}

std::string note_on_numbers(std::span<const std::filesystem::path> outputs, std::optional<MeshFormat> of_stream,
                            bool is_in_pieces) {
  const char* triangles = "";
  if (is_in_pieces)
    triangles = "; triangles count from the pieces of the first rank on, and may have another order in the file";
  else if (format_of_output(outputs.front(), of_stream) == MeshFormat::msh)
    triangles = "; triangles count from 1, not yet grouped by region as in a .msh";
  return fmt::format("\nnote    numbers are those of {}, or count from 0 where it has none{}; --json counts from 0",
                     outputs.front().string(), triangles);
}

}  // namespace

std::string in_words(const Violation& violation, const Goal& goal, const NumbersInWitnesses& numbers,
                     double max_circumradius) {
  std::string text = sentence(violation, goal, numbers, max_circumradius);
  if (!violation.where.empty()) {
    const Point at = violation.where.front();
    text += is_of_a_point(violation.kind) ? fmt::format(", at ({}, {})", at.x, at.y)
                                          : fmt::format(", at ({:.6g}, {:.6g})", at.x, at.y);
  }
  return text;
}

std::string findings_text(const Certificate& certificate, std::string_view all_in, const NumbersInWitnesses& numbers,
                          double max_circumradius) {
  std::string text;
  auto violation = certificate.violations.begin();
  for (std::size_t k = 0; k < certificate.violation_counts.size(); ++k) {
    const std::uint64_t count = certificate.violation_counts[k];
    if (count == 0) continue;
    const auto kind = static_cast<ViolationKind>(k);
    std::string title = name(kind);
    std::ranges::replace(title, '_', ' ');
    text += fmt::format("{}{}: {}", text.empty() ? "" : "\n", title, count);
    const std::uint64_t listed = std::min<std::uint64_t>(count, most_listed);
    for (std::uint64_t i = 0; i < listed; ++i, ++violation)
      text += fmt::format("\n  {}", in_words(*violation, certificate.goal, numbers, max_circumradius));
    if (count > listed) text += fmt::format("\n  ... and {} more (all in {})", count - listed, all_in);
    violation =
        std::find_if(violation, certificate.violations.end(), [&](const Violation& v) { return v.kind != kind; });
  }
  return text;
}

std::string check_message(const Certificate& certificate, bool goal_met, FirstId of_domain,
                          std::span<const std::filesystem::path> outputs, std::optional<MeshFormat> of_stream,
                          bool is_in_pieces) {
  const bool expected = !goal_met && only_bounds_missed(certificate);
  return (expected ? ": the check found missed bounds only\n" : ": the check found violations\n") +
         findings_text(certificate, "the report of --json", numbers_of_outputs(of_domain, outputs, of_stream)) +
         note_on_numbers(outputs, of_stream, is_in_pieces);
}

}  // namespace pardel::cli
