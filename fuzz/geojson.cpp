// Reads the bytes as GeoJSON. An error must name the file. The points of a domain are distinct and finite, and so are
// its segments; where these are valid and on a lattice, the seeds of holes and regions are valid, too. An input that
// begins with the byte 0 stands for a drawing of squares (drawn_cells.hpp), whose regions must have the areas that were
// drawn. The lengths of features are finite and positive, and change nothing else.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "../cli/parse_geojson.hpp"
#include "../cli/place_seeds.hpp"
#include "../parallel/validate.hpp"
#include "drawn_cells.hpp"
#include "fuzz_one.hpp"
#include "supply.hpp"

namespace pardel::fuzz {
namespace {

constexpr const char* name = "drawing.geojson";
constexpr std::size_t most_points = 1000;

void check_shapes(const Pslg& pslg) {
  std::set<std::pair<double, double>> points;
  for (const Point& p : pslg.points)
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !points.emplace(p.x, p.y).second)
      fail("a point is not finite, or there twice");
  std::set<std::pair<Index, Index>> segments;
  for (const Segment& s : pslg.segments) {
    if (s.a >= pslg.points.size() || s.b >= pslg.points.size() || s.a == s.b) fail("a segment has wrong ends");
    if (!segments.emplace(std::minmax(s.a, s.b)).second) fail("a segment is there twice");
  }
}

bool is_on_a_lattice(const Pslg& pslg) {
  constexpr double most = 1 << 20;
  const auto is_whole = [](double x) { return std::abs(x) <= most && x == std::floor(x); };
  return std::ranges::all_of(pslg.points, [&](const Point& p) { return is_whole(p.x) && is_whole(p.y); });
}

/// A drawing of holes only may have nothing left.
void check_seeds(const Pslg& seeded) {
  Pslg shapes = seeded;
  shapes.holes.clear();
  shapes.regions.clear();
  if (!is_on_a_lattice(shapes) || !find_problems(shapes).empty()) return;
  const std::vector<Problem> problems = find_problems(seeded);
  if (!problems.empty() && problems.front().kind != ProblemKind::no_domain) fail(messages(problems));
}

void check_lengths(std::string_view text, const Pslg& shapes) {
  const Result<cli::DrawnDomain> drawn = cli::parse_geojson(text, name, cli::LengthProperty::read);
  if (!drawn) {
    if (drawn.error().message.find("properties.length: expected a length") == std::string::npos)
      fail("a length makes another error: " + drawn.error().message);
    return;
  }
  if (!(drawn->pslg == shapes)) fail("a length changes the shapes");
  const auto is_length = [](double length) { return length > 0 && std::isfinite(length); };
  for (const SizeSource& source : drawn->sources)
    if (!is_length(source.at_a) || source.at_b != source.at_a) fail("a source has no length");
  for (const cli::DrawnPolygon& polygon : drawn->polygons)
    if (polygon.length && !is_length(*polygon.length)) fail("a polygon has a wrong length");
}

void check_cells(std::span<const std::uint8_t> seed) {
  generators::Random random(Supply(seed).word());
  const DrawnCells cells = any_cells(random);
  Result<cli::DrawnDomain> drawn = cli::parse_geojson(cells.text, name);
  if (!drawn) fail(drawn.error().message);
  if (const std::string wrong = difference(cli::place_seeds(std::move(*drawn)), cells); !wrong.empty())
    fail(wrong + " in " + cells.text);
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  if (!bytes.empty() && bytes.front() == 0) {
    check_cells(bytes.subspan(1));
    return 0;
  }
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  Result<cli::DrawnDomain> drawn = cli::parse_geojson(text, name);
  if (!drawn) {
    const Error& error = drawn.error();
    if (error.kind != ErrorKind::invalid_input || !error.message.starts_with(name))
      fail("an error of the wrong kind, or without the name of the file: " + error.message);
    return 0;
  }
  check_shapes(drawn->pslg);
  check_lengths(text, drawn->pslg);
  if (drawn->pslg.points.size() > most_points) return -1;
  check_seeds(cli::place_seeds(std::move(*drawn)));
  return 0;
}

}  // namespace pardel::fuzz
