#include "vertex_data.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "../../core/support/point_order.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../concurrency/parallel_arrays.hpp"

namespace pardel::engine {
namespace {

/// What the owner says about a vertex. Its ranks follow in another list.
struct TravellingData {
  std::uint64_t number;
  int marker;
  std::uint32_t pieces;
};

/// Sorts vertices by row and column in a grid over the cell, and by coordinates where several lie in one square. Linear
/// time if they are spread evenly.
class SortInCell {
 public:
  /// The order depends on the coordinates only, also that of the grid: it lies over the bounding box of the vertices.
  void operator()(const Triangulation& t, std::span<VertexId> vertices) {
    if (vertices.size() < 2) return;
    Box bounds = empty_box;
    for (const VertexId v : vertices) bounds.cover(Box::around(t.points[v]));
    const auto along = static_cast<unsigned>(std::sqrt(static_cast<double>(vertices.size()))) + 1;
    const double scale = along / std::max(bounds.extent(), std::numeric_limits<double>::min());
    const auto square_of = [&](VertexId v) {
      const Point p = t.points[v];
      const auto column = std::min(along - 1, static_cast<unsigned>((p.x - bounds.min_x) * scale));
      const auto row = std::min(along - 1, static_cast<unsigned>((p.y - bounds.min_y) * scale));
      return row * along + column;
    };
    square_.clear();
    start_.assign(std::size_t{along} * along + 1, 0);
    for (const VertexId v : vertices) {
      square_.push_back(square_of(v));
      ++start_[square_.back() + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    sorted_.resize(vertices.size());
    next_ = start_;
    for (std::size_t i = 0; i < vertices.size(); ++i) sorted_[next_[square_[i]]++] = vertices[i];
    for (std::size_t square = 0; square + 1 < start_.size(); ++square)
      if (start_[square + 1] - start_[square] > 1)
        std::sort(sorted_.begin() + start_[square], sorted_.begin() + start_[square + 1],
                  [&](VertexId a, VertexId b) { return lexicographically_less(t.points[a], t.points[b]); });
    std::ranges::copy(sorted_, vertices.begin());
  }

 private:
  std::vector<unsigned> square_, start_, next_;
  std::vector<VertexId> sorted_;
};

struct VerticesOfCells {
  std::vector<std::size_t> start;  ///< those of cell c are vertices[start[c]] to vertices[start[c + 1] - 1]
  Array<VertexId> vertices;
  [[nodiscard]] std::span<VertexId> of(Index cell) {
    return vertices.span().subspan(start[cell], start[cell + 1] - start[cell]);
  }
};

class Collector {
 public:
  Collector(const DomainTriangulation& domain, const Distribution& distribution, const Members& members,
            Array<Index> cells, const Threads& threads)
      : domain_(domain),
        t_(domain.triangulation),
        distribution_(distribution),
        ranks_(distribution.network()),
        members_(members),
        cells_(std::move(cells)),
        threads_(threads) {
    data_.marker = Array<int>::zeroes(t_.points.size());
  }

  void number_own();
  void mark_own(std::span<const int> input_markers);
  void find_pieces();
  void ask_owners();
  [[nodiscard]] VertexData take() { return std::move(data_); }

 private:
  [[nodiscard]] VerticesOfCells take_vertices_of_cells();
  [[nodiscard]] Ranks::Bytes question_about(const std::vector<VertexId>& vertices) const;
  [[nodiscard]] Ranks::Bytes answer_to(const Ranks::Bytes& question) const;
  void take_answer(const Ranks::Bytes& answer, const std::vector<VertexId>& vertices);
  [[nodiscard]] bool is_input(VertexId v) const { return v < domain_.input_of_vertex.size(); }

  const DomainTriangulation& domain_;
  const Triangulation& t_;
  const Distribution& distribution_;
  Ranks& ranks_;
  const Members& members_;
  Array<Index> cells_;  ///< per vertex
  Threads threads_;
  VertexData data_;
};

/// Replaces the cells of the vertices by the vertices of each cell. Those that are input points, or belong to other
/// ranks, are in no cell.
VerticesOfCells Collector::take_vertices_of_cells() {
  const std::size_t cells = distribution_.ownership().cells();
  VerticesOfCells of_cells{std::vector<std::size_t>(cells + 1, 0), {}};
  for (VertexId v = 0; v < cells_.size(); ++v) {
    if (is_input(v) || !members_.owns_vertex(v)) cells_[v] = static_cast<Index>(cells);
    if (cells_[v] < cells) ++of_cells.start[cells_[v] + 1];
  }
  std::partial_sum(of_cells.start.begin(), of_cells.start.end(), of_cells.start.begin());
  of_cells.vertices.resize_uninitialised(of_cells.start.back());
  std::vector<std::size_t> next = of_cells.start;
  for (VertexId v = 0; v < cells_.size(); ++v)
    if (cells_[v] < cells) of_cells.vertices[next[cells_[v]]++] = v;
  cells_ = {};
  return of_cells;
}

void Collector::number_own() {
  VerticesOfCells of_cells = take_vertices_of_cells();
  const std::size_t inputs = domain_.input_of_vertex.size();
  const ShareOfRank share = share_of_rank(of_cells.vertices.size(), ranks_);
  data_.count = inputs + share.all;
  data_.first = inputs + share.before;
  std::uint64_t next = data_.first;
  const std::span<const Index> curve = distribution_.ownership().curve();
  std::vector<std::uint64_t> first_of_place;
  for (const Index cell : curve) {
    first_of_place.push_back(next);
    next += of_cells.of(cell).size();
  }
  data_.number.resize_uninitialised(t_.points.size());
  for (VertexId v = 0; v < inputs; ++v) data_.number[v] = domain_.input_of_vertex[v];
  std::vector<SortInCell> sort(static_cast<std::size_t>(threads_.count));
  parallel_for(threads_, curve.size(), [&](std::size_t place, int thread) {
    const std::span<VertexId> vertices = of_cells.of(curve[place]);
    sort[static_cast<std::size_t>(thread)](t_, vertices);
    for (std::size_t i = 0; i < vertices.size(); ++i) data_.number[vertices[i]] = first_of_place[place] + i;
  });
}

/// The marker of a vertex is its marker in the input. If this is 0 or missing, it is the marker of the first segment
/// with a marker on which the vertex lies. If there is none, it is 1 on the boundary and 0 elsewhere.
void Collector::mark_own(std::span<const int> input_markers) {
  std::unordered_map<VertexId, Index> first_segment;
  for (const EdgeRef e : members_.constrained_sides()) {
    const Slot& slot = t_.slot(e);
    const VertexId a = slot.from(e.side()), b = slot.to(e.side());
    const Index segment = domain_.segments.segment_of(t_, a, b);
    if (segment == no_index) continue;
    const Index input = domain_.input_segment[segment];
    const int marker = domain_.segment_marker[segment];
    for (const VertexId v : {a, b}) {
      if (marker != 0 && input != no_index) {
        const auto [found, is_new] = first_segment.try_emplace(v, input);
        if (is_new || input < found->second) {
          found->second = input;
          data_.marker[v] = marker;
        }
      } else if (slot.n[e.side()].none() && data_.marker[v] == 0) {
        data_.marker[v] = 1;
      }
    }
  }
  if (!input_markers.empty())
    for (VertexId v = 0; is_input(v); ++v)
      if (const int given = input_markers[domain_.input_of_vertex[v]]; given != 0) data_.marker[v] = given;
}

/// A vertex of this rank lies in a triangle of another piece only if that triangle has a corner of another rank.
void Collector::find_pieces() {
  for (const TriangleId id : members_.at_border()) {
    const int owner = distribution_.owner_of_triangle(id);
    for (const VertexId v : t_.slots[id].v)
      if (members_.owns_vertex(v)) data_.pieces[v].push_back(owner);
  }
  for (auto& [v, ranks] : data_.pieces) {
    if (members_.has_vertex(v)) ranks.push_back(ranks_.rank());
    std::sort(ranks.begin(), ranks.end());
    ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  }
}

Ranks::Bytes Collector::question_about(const std::vector<VertexId>& vertices) const {
  std::vector<Name> names;
  for (const VertexId v : vertices) names.push_back(distribution_.part().name_of_vertex(v));
  Writer message;
  message.list(names);
  return message.take();
}

Ranks::Bytes Collector::answer_to(const Ranks::Bytes& question) const {
  std::vector<TravellingData> data;
  std::vector<int> all_pieces;
  for (const Name name : Reader(question).list<Name>()) {
    const VertexId v = distribution_.part().vertex(name);
    if (v == no_index || !members_.owns_vertex(v)) throw Reader::does_not_match();
    const std::vector<int>& pieces = data_.pieces.at(v);
    data.push_back({data_.number[v], data_.marker[v], static_cast<std::uint32_t>(pieces.size())});
    all_pieces.insert(all_pieces.end(), pieces.begin(), pieces.end());
  }
  Writer message;
  message.list(data);
  message.list(all_pieces);
  return message.take();
}

void Collector::take_answer(const Ranks::Bytes& answer, const std::vector<VertexId>& vertices) {
  Reader reader(answer);
  const auto data = reader.list<TravellingData>();
  const auto all_pieces = reader.list<int>();
  if (data.size() != vertices.size()) throw Reader::does_not_match();
  auto next = all_pieces.begin();
  for (std::size_t i = 0; i < data.size(); ++i) {
    const VertexId v = vertices[i];
    data_.number[v] = data[i].number;
    data_.marker[v] = data[i].marker;
    data_.pieces[v] = {next, next + data[i].pieces};
    next += data[i].pieces;
  }
}

void Collector::ask_owners() {
  std::vector<std::vector<VertexId>> asked(ranks_.count());
  for (VertexId v = 0; v < t_.points.size(); ++v)
    if (members_.has_vertex(v) && !members_.owns_vertex(v)) asked[distribution_.owner_of(v)].push_back(v);
  std::vector<Ranks::Bytes> questions, answers;
  for (const std::vector<VertexId>& of_rank : asked) questions.push_back(question_about(of_rank));
  for (const Ranks::Bytes& question : ranks_.exchange(std::move(questions))) answers.push_back(answer_to(question));
  const std::vector<Ranks::Bytes> arrived = ranks_.exchange(std::move(answers));
  for (int rank = 0; rank < ranks_.count(); ++rank) take_answer(arrived[rank], asked[rank]);
}

}  // namespace

VertexData vertex_data(const DomainTriangulation& domain, const Distribution& distribution, Members& members,
                       std::span<const int> input_markers, const Threads& threads) {
  Collector collector(domain, distribution, members, members.take_cells(), threads);
  collector.number_own();
  collector.mark_own(input_markers);
  collector.find_pieces();
  collector.ask_owners();
  return collector.take();
}

}  // namespace pardel::engine
