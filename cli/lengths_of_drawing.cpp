#include "lengths_of_drawing.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "../parallel/mesher.hpp"
#include "../parallel/sizes.hpp"
#include "drawn_faces.hpp"

namespace pardel::cli {
namespace {

/// The sides of the polygons, each once, with the numbers that their ends have in the file.
class Sides {
 public:
  explicit Sides(const Pslg& drawing) {
    for (const Point& p : drawing.points) number_.try_emplace({p.x, p.y}, number_.size());
  }
  void add(const std::vector<Point>& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Index a = index_of(ring[j]), b = index_of(ring[i]);
      if (a != b && between_.insert(std::minmax(a, b)).second) sides_.pslg.segments.push_back({a, b});
    }
  }
  /// Adds the corners of a box around all sides. Then the triangles at the hull are outside of all polygons. The box is
  /// near the sides, because a mesh of a long way from a round polygon to a far corner takes quadratic time.
  void add_frame() {
    if (sides_.pslg.points.empty()) return;
    const auto [left, right] = std::ranges::minmax(sides_.pslg.points, {}, &Point::x);
    const auto [bottom, top] = std::ranges::minmax(sides_.pslg.points, {}, &Point::y);
    const double margin = std::max(right.x - left.x, top.y - bottom.y);
    const double west = left.x - margin, east = right.x + margin, south = bottom.y - margin, north = top.y + margin;
    for (const Point corner : {Point{west, south}, {east, south}, {east, north}, {west, north}}) {
      sides_.pslg.points.push_back(corner);
      sides_.points.of_points.push_back(number_.size());
    }
  }
  [[nodiscard]] FramedSides take() && { return std::move(sides_); }

 private:
  Index index_of(Point p) {
    const auto [found, is_new] = index_.try_emplace({p.x, p.y}, static_cast<Index>(sides_.pslg.points.size()));
    if (!is_new) return found->second;
    sides_.pslg.points.push_back(p);
    sides_.points.of_points.push_back(number_.at({p.x, p.y}));
    return found->second;
  }

  FramedSides sides_;
  std::map<std::pair<double, double>, std::uint64_t> number_;  ///< in the file
  std::map<std::pair<double, double>, Index> index_;           ///< in sides_
  std::set<std::pair<Index, Index>> between_;
};

/// The sides and a frame around them.
FramedSides framed(const DrawnDomain& drawing, const std::vector<DrawnPolygon>& polygons) {
  Sides sides(drawing.pslg);
  for (const DrawnPolygon& polygon : polygons)
    for (const std::vector<Point>& ring : polygon.rings) sides.add(ring);
  sides.add_frame();
  return std::move(sides).take();
}

double least_length(const std::vector<const DrawnPolygon*>& polygons) {
  double least = std::numeric_limits<double>::infinity();
  for (const DrawnPolygon* polygon : polygons) least = std::min(least, *polygon->length);
  return least;
}

/// The least length of the polygons around a point. Each polygon has a length.
Result<std::function<double(Point)>> length_inside(std::vector<DrawnPolygon> polygons, ValidPslg sides,
                                                   const std::string& name) {
  DrawnDomain drawing{std::move(sides).pslg(), std::move(polygons)};
  std::vector<Region> regions;
  std::vector<double> lengths;
  for (const DrawnFace& face : drawn_faces(drawing)) {
    if (face.polygons.empty()) continue;
    regions.push_back({.seed = face.seed});
    lengths.push_back(least_length(face.polygons));
  }
  drawing.pslg.regions = std::move(regions);
  const Result<ValidPslg, std::vector<Problem>> domain = validate(std::move(drawing.pslg), {.convex_hull = true});
  if (!domain) return Error{ErrorKind::invalid_input, name + ": " + messages(domain.error())};
  Result<RegionSizes> sizes = region_sizes(*domain, lengths);
  if (!sizes && sizes.error().kind == ErrorKind::invalid_input)
    return Error{ErrorKind::invalid_input, name + ": " + sizes.error().message};
  if (!sizes) return sizes.error();
  return std::move(sizes->size);
}

}  // namespace

Result<DrawnLengths> lengths_of(DrawnDomain drawing, const std::string& name, const MakeValid& make_valid) {
  DrawnLengths lengths{std::move(drawing.sources)};
  if (lengths.sources.empty())
    return Error{ErrorKind::invalid_input,
                 name + ": expected an edge length: no point, line or polygon has the property 'length'"};
  std::vector<DrawnPolygon> polygons = std::move(drawing.polygons);
  std::erase_if(polygons, [](const DrawnPolygon& polygon) { return !polygon.length; });
  FramedSides sides = framed(drawing, polygons);
  if (sides.pslg.segments.empty()) return lengths;
  Result<ValidPslg> valid = make_valid(std::move(sides));
  if (!valid) return valid.error();
  Result<std::function<double(Point)>> size = length_inside(std::move(polygons), std::move(*valid), name);
  if (!size) return size.error();
  lengths.size = std::move(*size);
  return lengths;
}

}  // namespace pardel::cli
