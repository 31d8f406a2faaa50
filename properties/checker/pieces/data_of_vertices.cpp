#include "data_of_vertices.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../../../core/support/agree.hpp"
#include "../../../core/support/exchange_lists.hpp"
#include "../../../core/support/same_attribute.hpp"

namespace pardel::checker {
namespace {

/// What a piece says about a vertex. Its attributes are in another list.
struct TravellingVertex {
  std::uint64_t number;
  Index origin;
  std::int32_t marker;
  friend bool operator==(const TravellingVertex&, const TravellingVertex&) = default;
};

/// The kinds of data that all pieces with points have.
Result<KindsOfData> kinds_of_all(const PiecesRead& read, Ranks& ranks) {
  std::vector<KindsOfData> kinds;
  for (const KeptPiece& piece : read.pieces)
    if (piece.points > 0 && (kinds.empty() || kinds.back() != piece.part.kinds)) kinds.push_back(piece.part.kinds);
  kinds = concatenated(lists_of_all(kinds, ranks));
  if (std::ranges::adjacent_find(kinds, std::not_equal_to<>()) != kinds.end())
    return Error{ErrorKind::invalid_input, "the pieces do not have the same kinds of data"};
  return kinds.empty() ? KindsOfData{} : kinds.front();
}

/// The vertices that one rank compares for all pieces.
class Comparison {
 public:
  /// `k`: the number of attributes of each vertex.
  Comparison(std::vector<TravellingVertex> vertices, std::vector<double> attributes, std::size_t k)
      : vertices_(std::move(vertices)), attributes_(std::move(attributes)), k_(k) {}

  /// Error: two pieces do not agree on a vertex.
  [[nodiscard]] Status judge() const {
    std::vector<std::size_t> order(vertices_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return vertices_[i].number; });
    const auto differ = std::ranges::adjacent_find(order, [&](std::size_t i, std::size_t j) {
      return vertices_[i].number == vertices_[j].number && !are_alike(i, j);
    });
    if (differ == order.end()) return Done{};
    return Error{ErrorKind::invalid_input,
                 "there are different data of the point with the number " + std::to_string(vertices_[*differ].number)};
  }

 private:
  [[nodiscard]] bool are_alike(std::size_t i, std::size_t j) const {
    const std::span<const double> all(attributes_);
    return vertices_[i] == vertices_[j] &&
           std::ranges::equal(all.subspan(i * k_, k_), all.subspan(j * k_, k_), is_same_attribute);
  }

  std::vector<TravellingVertex> vertices_;
  std::vector<double> attributes_;
  std::size_t k_;
};

}  // namespace

Status check_data_of_vertices(const PiecesRead& read, std::uint64_t points, Ranks& ranks) {
  const Result<KindsOfData> kinds = kinds_of_all(read, ranks);
  if (!kinds) return kinds.error();
  const std::size_t k = kinds->attributes_per_point;
  const Referees referees(points, ranks.count());
  std::vector<std::vector<TravellingVertex>> vertices(static_cast<std::size_t>(ranks.count()));
  std::vector<std::vector<double>> attributes(vertices.size());
  for (const KeptPiece& piece : read.pieces)
    for (std::size_t v = 0; v < piece.part.vertices.size(); ++v) {
      const KeptVertex& vertex = piece.part.vertices[v];
      const auto referee = static_cast<std::size_t>(referees.of(vertex.number));
      vertices[referee].push_back({vertex.number, vertex.origin, vertex.marker});
      const auto own = std::span(piece.part.attributes).subspan(v * k, k);
      attributes[referee].insert(attributes[referee].end(), own.begin(), own.end());
    }
  const Comparison here(concatenated(exchange_lists(std::move(vertices), ranks)),
                        concatenated(exchange_lists(std::move(attributes), ranks)), k);
  return agree(here.judge(), ranks);
}

}  // namespace pardel::checker
