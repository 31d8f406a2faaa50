#include "share_of_file.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "../support/exchange_lists.hpp"

namespace pardel::files {
namespace {

/// The limits of all ranges, in ascending order; the last one is the number of points.
std::vector<std::uint64_t> bounds_of_ranges(const PieceOfMesh& piece, Ranks& ranks) {
  std::vector<std::uint64_t> first_point(static_cast<std::size_t>(ranks.count()), 0);
  first_point[static_cast<std::size_t>(ranks.rank())] = piece.first_point;
  ranks.add_up(first_point);
  const std::uint64_t inputs = first_point.front(), parts = first_point.size();
  std::vector<std::uint64_t> bounds;
  for (std::uint64_t part = 0; part < parts; ++part)
    bounds.push_back(inputs / parts * part + std::min(part, inputs % parts));
  bounds.insert(bounds.end(), first_point.begin(), first_point.end());
  bounds.push_back(piece.points);
  return bounds;
}

}  // namespace

ShareOfFile::ShareOfFile(const PieceOfMesh& piece, Ranks& ranks)
    : piece_(piece), rank_(ranks.rank()), count_(ranks.count()), bounds_(bounds_of_ranges(piece, ranks)) {
  std::size_t first = 0;
  for (std::size_t s = 0; s < sections; ++s) {
    const std::size_t range = s * static_cast<std::size_t>(count_) + static_cast<std::size_t>(rank_);
    points_[s] = {first, bounds_[range + 1] - bounds_[range]};
    first += points_[s].count;
  }
  take_points(ranks);
  take_triangles(ranks);
  take_edges(ranks);
}

int ShareOfFile::writer_of(std::uint64_t number) const {
  const auto range = std::ranges::upper_bound(bounds_, number) - bounds_.begin() - 1;
  return static_cast<int>(range % count_);
}

std::size_t ShareOfFile::place_of(std::uint64_t number) const {
  const bool is_input = number < bounds_[static_cast<std::size_t>(count_)];
  const std::uint64_t first = bounds_[static_cast<std::size_t>(is_input ? rank_ : count_ + rank_)];
  return (is_input ? 0 : points_[1].first) + (number - first);
}

std::uint64_t ShareOfFile::number(std::size_t i) const {
  const bool is_input = i < points_[1].first;
  return bounds_[static_cast<std::size_t>(is_input ? rank_ : count_ + rank_)] + (is_input ? i : i - points_[1].first);
}

const Point& ShareOfFile::point(std::size_t i) const {
  const std::size_t own = piece_.mesh.points.size(), v = point_[i];
  return v < own ? piece_.mesh.points[v] : arrived_points_[v - own].point;
}

const int& ShareOfFile::marker(std::size_t i) const {
  const std::size_t own = piece_.mesh.points.size(), v = point_[i];
  return v < own ? piece_.mesh.point_markers[v] : arrived_points_[v - own].marker;
}

std::span<const double> ShareOfFile::attributes(std::size_t i) const {
  const std::size_t own = piece_.mesh.points.size(), v = point_[i], k = piece_.mesh.attributes_per_point;
  if (v < own) return piece_.mesh.point_attributes.span().subspan(v * k, k);
  return std::span<const double>(arrived_attributes_).subspan((v - own) * k, k);
}

Index ShareOfFile::region(std::size_t i) const {
  const std::size_t own = piece_.mesh.triangles.size(), t = order_[i];
  if (t >= own) return arrived_triangles_[t - own].region;
  return piece_.mesh.region.empty() ? no_index : piece_.mesh.region[t];
}

ShareOfFile::Corners ShareOfFile::corners_of(Index triangle) const {
  const std::size_t own = piece_.mesh.triangles.size();
  if (triangle >= own) return arrived_triangles_[triangle - own].corners;
  const auto& v = piece_.mesh.triangles[triangle].v;
  Corners corners{piece_.number[v[0]], piece_.number[v[1]], piece_.number[v[2]]};
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

/// A point at the border may arrive from several ranks, which have the same data.
void ShareOfFile::take_points(Ranks& ranks) {
  const Mesh& mesh = piece_.mesh;
  const std::size_t k = mesh.attributes_per_point;
  point_.resize(points_[1].first + points_[1].count, no_index);
  std::vector<std::vector<TravellingPoint>> leaving(static_cast<std::size_t>(count_));
  std::vector<std::vector<double>> leaving_attributes(leaving.size());
  for (Index v = 0; v < mesh.points.size(); ++v) {
    const std::uint64_t number = piece_.number[v];
    const int writer = writer_of(number);
    if (writer == rank_) {
      point_[place_of(number)] = v;
    } else {
      leaving[static_cast<std::size_t>(writer)].push_back({number, mesh.points[v], mesh.point_markers[v]});
      const auto attributes = mesh.point_attributes.span().subspan(v * k, k);
      auto& to = leaving_attributes[static_cast<std::size_t>(writer)];
      to.insert(to.end(), attributes.begin(), attributes.end());
    }
  }
  arrived_points_ = concatenated(exchange_lists(std::move(leaving), ranks));
  arrived_attributes_ = concatenated(exchange_lists(std::move(leaving_attributes), ranks));
  for (std::size_t i = 0; i < arrived_points_.size(); ++i) {
    const std::uint64_t number = arrived_points_[i].number;
    if (is_mine(number)) point_[place_of(number)] = static_cast<Index>(mesh.points.size() + i);
  }
}

Status ShareOfFile::complete() const {
  const auto missing = std::ranges::find(point_, no_index);
  if (missing == point_.end()) return Done{};
  return Error{ErrorKind::internal, "no piece has the point with the number " +
                                        std::to_string(number(static_cast<std::size_t>(missing - point_.begin())))};
}

void ShareOfFile::take_triangles(Ranks& ranks) {
  const Mesh& mesh = piece_.mesh;
  std::vector<std::vector<TravellingTriangle>> leaving(static_cast<std::size_t>(count_));
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const Corners corners = corners_of(t);
    const int writer = writer_of(corners[0]);
    if (writer != rank_)
      leaving[static_cast<std::size_t>(writer)].push_back({corners, mesh.region.empty() ? no_index : mesh.region[t]});
  }
  arrived_triangles_ = concatenated(exchange_lists(std::move(leaving), ranks));
  sort_triangles(mesh.triangles.size() + arrived_triangles_.size());
}

/// By the place of the first corner, then by the second corner: no two triangles have both in common. Linear time,
/// because few triangles have the same first corner.
void ShareOfFile::sort_triangles(std::size_t all) {
  std::vector<Index> next(point_.size() + 1, 0);
  const auto for_each_of_mine = [&](const auto& visit) {
    for (Index t = 0; t < all; ++t)
      if (const std::uint64_t first = corners_of(t)[0]; is_mine(first)) visit(t, place_of(first));
  };
  for_each_of_mine([&](Index, std::size_t place) { ++next[place + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  triangles_[0] = {0, next[points_[1].first]};
  triangles_[1] = {triangles_[0].count, next.back() - triangles_[0].count};
  order_.resize_uninitialised(next.back());
  for_each_of_mine([&](Index t, std::size_t place) { order_[next[place]++] = t; });
  // Now next[place] is the end of the triangles at the place.
  for (std::size_t place = 0, begin = 0; place < point_.size(); begin = next[place++])
    std::ranges::sort(order_.span().subspan(begin, next[place] - begin), {}, [&](Index t) { return corners_of(t)[1]; });
}

void ShareOfFile::take_edges(Ranks& ranks) {
  std::vector<std::vector<Edge>> leaving(static_cast<std::size_t>(count_));
  for (const ConstrainedEdge& e : piece_.mesh.constrained_edges) {
    const std::uint64_t a = piece_.number[e.a], b = piece_.number[e.b];
    leaving[static_cast<std::size_t>(writer_of(std::min(a, b)))].push_back({a, b, e.marker});
  }
  edge_ = concatenated(exchange_lists(std::move(leaving), ranks));
  const auto ends = [](const Edge& e) { return std::pair(std::min(e.a, e.b), std::max(e.a, e.b)); };
  std::ranges::sort(edge_, {}, ends);
  const auto second =
      std::ranges::lower_bound(edge_, std::pair(bounds_[static_cast<std::size_t>(count_)], std::uint64_t{0}), {}, ends);
  edges_[0] = {0, static_cast<std::size_t>(second - edge_.begin())};
  edges_[1] = {edges_[0].count, edge_.size() - edges_[0].count};
}

}  // namespace pardel::files
