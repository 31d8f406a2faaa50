#include "equal_points.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "../support/same_attribute.hpp"

namespace pardel::files {
namespace {

/// A point of a piece.
struct Place {
  const Mesh* piece = nullptr;
  std::size_t point = 0;

  [[nodiscard]] std::pair<double, double> at() const { return {piece->points[point].x, piece->points[point].y}; }
};

std::vector<Place> places_of(const std::vector<NumberedMesh>& pieces) {
  std::vector<Place> places;
  for (const NumberedMesh& piece : pieces)
    for (std::size_t v = 0; v < piece.mesh.points.size(); ++v) places.push_back({&piece.mesh, v});
  return places;
}

bool has_same_data(const Place& a, const Place& b) {
  const std::size_t k = a.piece->attributes_per_point;
  const auto marker = [](const Place& p) {
    return p.piece->point_markers.empty() ? 0 : p.piece->point_markers[p.point];
  };
  const auto attributes = [k](const Place& p) { return p.piece->point_attributes.span().subspan(p.point * k, k); };
  return b.piece->attributes_per_point == k && marker(a) == marker(b) &&
         std::ranges::equal(attributes(a), attributes(b), is_same_attribute);
}

/// For each place the first one with which it is one point. A place comes after the one that it is joined with.
std::vector<std::size_t> first_places(const std::vector<Place>& places) {
  std::vector<std::size_t> first(places.size()), sorted(places.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  std::iota(sorted.begin(), sorted.end(), std::size_t{0});
  std::ranges::stable_sort(sorted, {}, [&](std::size_t i) { return places[i].at(); });
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::find_if(begin, sorted.end(), [&](auto i) { return places[i].at() != places[*begin].at(); });
    const auto cannot_join = [&](std::size_t i, std::size_t j) {  // the places of one piece follow one another
      return places[i].piece == places[j].piece || !has_same_data(places[i], places[j]);
    };
    if (std::adjacent_find(begin, end, cannot_join) == end)
      for (auto i = begin; i != end; ++i) first[*i] = *begin;
    begin = end;
  }
  return first;
}

}  // namespace

std::vector<std::uint64_t> number_equal_points(std::vector<NumberedMesh>& pieces) {
  const std::vector<std::size_t> first = first_places(places_of(pieces));
  std::vector<std::uint64_t> number(first.size()), firsts;
  for (std::size_t i = 0; i < first.size(); ++i) {
    number[i] = first[i] == i ? firsts.size() : number[first[i]];
    if (first[i] == i) firsts.push_back(i);
  }
  auto next = number.begin();
  for (NumberedMesh& piece : pieces) {
    piece.number.clear();
    for (std::size_t v = 0; v < piece.mesh.points.size(); ++v) piece.number.push_back(*next++);
  }
  return firsts;
}

}  // namespace pardel::files
