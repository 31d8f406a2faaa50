// The certificate as text and as JSON.
#include "certificate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "arithmetic/text.hpp"

namespace pardel {

using namespace checker;

namespace {

using Json = nlohmann::ordered_json;

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

std::string right_aligned(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

/// "1 triangle", "2 triangles"
std::string counted(std::uint64_t n, const char* one, const char* several) {
  return to_text(n) + ' ' + (n == 1 ? one : several);
}

/// The caps of the regions, for example ", areas up to 0.1 in region 0, 0.02 in region 2".
std::string region_caps_text(const std::vector<double>& caps, const NumbersInWitnesses& numbers) {
  constexpr std::size_t most_named = 10;
  std::string text;
  std::size_t capped = 0;
  for (std::size_t r = 0; r < caps.size(); ++r) {
    if (!std::isfinite(caps[r]) || ++capped > most_named) continue;
    text += (capped == 1 ? ", areas up to " : ", ") + to_text(caps[r]) + " in region " +
            to_text(numbers.number(Numbered::of_domain, static_cast<Index>(r)));
  }
  if (capped > most_named) text += " and caps in " + to_text(capped - most_named) + " more";
  return text;
}

std::string goal_text(const Goal& goal, const std::vector<double>& region_caps, const NumbersInWitnesses& numbers) {
  std::string text = "angles of at least " + to_text(goal.min_angle_deg) + " degrees";
  if (std::isfinite(goal.max_area)) text += ", areas up to " + to_text(goal.max_area);
  if (std::isfinite(goal.max_edge)) text += ", edges up to " + to_text(goal.max_edge);
  text += region_caps_text(region_caps, numbers);
  if (goal.size) text += ", sizes by position";
  if (std::isfinite(goal.grading)) text += ", lengths that grow by at most " + to_text(goal.grading);
  if (goal.feature_edges > 0) text += ", " + to_text(goal.feature_edges) + " edges per feature size";
  if (goal.user_test) text += ", a test of the user";
  text += goal.conforming ? ", Delaunay" : ", constrained Delaunay";
  if (goal.convex_hull) text += ", the convex hull";
  return text;
}

void append_extreme(std::string& text, const char* label, const Extreme& extreme, const NumbersInWitnesses& numbers) {
  text += "  " + padded(label, 26) + padded(to_short_text(extreme.value), 14);
  if (extreme.triangle != no_index)
    text += "triangle " + to_text(numbers.number(Numbered::triangle, extreme.triangle)) + " at (" +
            to_short_text(extreme.where.x) + ", " + to_short_text(extreme.where.y) + ")";
  text += '\n';
}

void append_histogram(std::string& text, const std::vector<std::uint64_t>& histogram) {
  if (histogram.empty()) return;
  constexpr std::uint64_t width = 50;
  const std::uint64_t largest = *std::max_element(histogram.begin(), histogram.end());
  text += "angles, in degrees\n";
  for (std::size_t bin = 0; bin < histogram.size(); ++bin) {
    const std::uint64_t count = histogram[bin];
    // A bin that is not empty has at least one mark.
    const std::uint64_t marks = count == 0 ? 0 : std::max<std::uint64_t>(1, count * width / largest);
    text += "  " + right_aligned(to_text(10 * bin), 3) + " - " + padded(to_text(10 * (bin + 1)), 4) +
            right_aligned(to_text(count), 11);
    if (marks > 0) text += "  " + std::string(marks, '#');
    text += '\n';
  }
}

/// The triangles that one apex justifies.
struct Summary {
  std::uint64_t triangles = 0;
  double least_input_angle = 180, largest_input_angle = 0, angle = 180;
};

std::string input_angles_text(const Summary& summary) {
  const std::string least = to_short_text(summary.least_input_angle);
  const std::string largest = to_short_text(summary.largest_input_angle);
  return least == largest ? "an input angle of " + least : "input angles of " + least + " to " + largest;
}

/// One line for each apex: the number of triangles it justifies, and the smallest angle among them.
void append_justified(std::string& text, const std::vector<Justified>& justified, const NumbersInWitnesses& numbers) {
  if (justified.empty()) return;
  std::map<Index, Summary> by_apex;
  for (const Justified& j : justified) {
    Summary& summary = by_apex[j.apex];
    ++summary.triangles;
    summary.least_input_angle = std::min(summary.least_input_angle, j.input_angle_deg);
    summary.largest_input_angle = std::max(summary.largest_input_angle, j.input_angle_deg);
    summary.angle = std::min(summary.angle, j.angle_deg);
  }
  text +=
      counted(justified.size(), "triangle", "triangles") + " below the angle bound, justified by small input angles\n";
  constexpr std::size_t shown = 20;
  std::size_t lines = 0;
  for (const auto& [apex, summary] : by_apex) {
    if (lines++ == shown) {
      text += "  and at " + to_text(by_apex.size() - shown) + " further points\n";
      break;
    }
    text += "  at point " + to_text(numbers.number(Numbered::of_domain, apex)) + ": " + to_text(summary.triangles) +
            ", down to " + to_short_text(summary.angle) + " degrees, at " + input_angles_text(summary) + '\n';
  }
}

void append_violations(std::string& text, const Certificate& certificate) {
  for (std::size_t kind = 0; kind < certificate.violation_counts.size(); ++kind)
    if (certificate.violation_counts[kind] > 0)
      text += "  " + padded(name(static_cast<ViolationKind>(kind)), 26) + to_text(certificate.violation_counts[kind]) +
              '\n';
  for (const Violation& violation : certificate.violations) text += "- " + violation.message() + '\n';
  std::uint64_t total = 0;
  for (const std::uint64_t count : certificate.violation_counts) total += count;
  if (total > certificate.violations.size())
    text += "- and " + to_text(total - certificate.violations.size()) + " more\n";
}

Json to_json(Point p) { return Json::array({p.x, p.y}); }

Json to_json(const Extreme& extreme) {
  Json json{{"value", extreme.value}};
  json["triangle"] = extreme.triangle == no_index ? Json(nullptr) : Json(extreme.triangle);
  json["where"] = to_json(extreme.where);
  return json;
}

Json to_json(const Goal& goal) {
  // An infinite bound means that there is no bound; JSON has null for it.
  const auto bound = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  Json json = {
      {"min_angle_deg", goal.min_angle_deg}, {"max_area", bound(goal.max_area)}, {"max_edge", bound(goal.max_edge)},
      {"region_caps", goal.region_caps},     {"sizing", bool(goal.size)},        {"grading", bound(goal.grading)},
      {"feature_edges", goal.feature_edges}, {"conforming", goal.conforming},    {"convex_hull", goal.convex_hull}};
  if (goal.user_test) json["user_test"] = true;
  return json;
}

Json to_json(const Violation& violation) {
  Json ids = Json::array(), where = Json::array();
  for (const Index id : violation.ids) ids.push_back(id == no_index ? Json(nullptr) : Json(id));
  for (const Point p : violation.where) where.push_back(to_json(p));
  return {{"kind", name(violation.kind)},
          {"ids", std::move(ids)},
          {"where", std::move(where)},
          {"witness", violation.witness.text()}};
}

}  // namespace

std::string summary_text(const Certificate& certificate, const NumbersInWitnesses& numbers) {
  std::string text = certificate.cancelled ? "cancelled" : certificate.valid ? "valid" : "NOT VALID";
  text += ": " + counted(certificate.vertices, "vertex", "vertices") + ", " +
          counted(certificate.triangles, "triangle", "triangles") + ", " +
          counted(certificate.constrained_edges, "constrained edge", "constrained edges") + '\n';
  text += "goal: " + goal_text(certificate.goal, certificate.region_caps, numbers) + '\n';
  append_extreme(text, "smallest angle", certificate.min_angle_deg, numbers);
  append_extreme(text, "largest angle", certificate.max_angle_deg, numbers);
  append_extreme(text, "shortest edge", certificate.min_edge, numbers);
  append_extreme(text, "longest edge", certificate.max_edge, numbers);
  append_extreme(text, "largest area", certificate.max_area, numbers);
  append_extreme(text, "largest circumradius", certificate.max_circumradius, numbers);
  append_extreme(text, "largest radius / edge", certificate.max_radius_edge_ratio, numbers);
  text += "  " + padded("area", 26) + to_text(certificate.area) + '\n';
  text += "  " + padded("equilateral triangles", 26) + to_text(certificate.equilateral) + '\n';
  append_histogram(text, certificate.angle_histogram);
  append_justified(text, certificate.justified, numbers);
  for (const std::string& what : certificate.not_checked) text += "not checked: " + what + '\n';
  text += "digest " + to_string(certificate.digest) + '\n';
  return text;
}

std::string to_text(const Certificate& certificate) {
  std::string text = summary_text(certificate);
  append_violations(text, certificate);
  return text;
}

std::string to_json(const Certificate& certificate) {
  Json counts = Json::object();
  for (std::size_t kind = 0; kind < certificate.violation_counts.size(); ++kind)
    if (certificate.violation_counts[kind] > 0)
      counts[name(static_cast<ViolationKind>(kind))] = certificate.violation_counts[kind];
  Json violations = Json::array();
  for (const Violation& violation : certificate.violations) violations.push_back(to_json(violation));
  Json justified = Json::array();
  for (const Justified& j : certificate.justified)
    justified.push_back({{"triangle", j.triangle},
                         {"apex", j.apex},
                         {"input_angle_deg", j.input_angle_deg},
                         {"angle_deg", j.angle_deg}});
  Json json{{"schema", "pardel.certificate/1"},
            {"valid", certificate.valid},
            {"cancelled", certificate.cancelled},
            {"goal", to_json(certificate.goal)},
            {"mesh",
             {{"vertices", certificate.vertices},
              {"triangles", certificate.triangles},
              {"constrained_edges", certificate.constrained_edges},
              {"area", certificate.area},
              {"equilateral", certificate.equilateral}}},
            {"decided_exactly", certificate.decided_exactly},
            {"extremes",
             {{"min_angle_deg", to_json(certificate.min_angle_deg)},
              {"max_angle_deg", to_json(certificate.max_angle_deg)},
              {"min_edge", to_json(certificate.min_edge)},
              {"max_edge", to_json(certificate.max_edge)},
              {"max_area", to_json(certificate.max_area)},
              {"max_circumradius", to_json(certificate.max_circumradius)},
              {"max_radius_edge_ratio", to_json(certificate.max_radius_edge_ratio)}}},
            {"angle_histogram", certificate.angle_histogram},
            {"justified", std::move(justified)},
            {"not_checked", certificate.not_checked},
            {"violation_counts", std::move(counts)},
            {"violations", std::move(violations)},
            {"digest", to_string(certificate.digest)}};
  if (certificate.ranks > 0) json["ranks"] = certificate.ranks;
  return json.dump(2);
}

}  // namespace pardel
