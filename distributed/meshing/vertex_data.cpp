#include "vertex_data.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "../../core/support/answers_of_ranks.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "../../core/support/without_repetitions.hpp"

namespace pardel::engine {
namespace {

/// What the owner says about a vertex. Its ranks follow in another list.
struct TravellingData {
  int marker;
  std::uint32_t pieces;
};

/// A reason for the marker of a vertex. Of several, that with the least rank counts.
struct Reason {
  VertexId v;
  Index rank;
  int marker;
};

class Collector {
 public:
  Collector(const DomainTriangulation& domain, const Distribution& distribution, const Members& members)
      : domain_(domain),
        t_(domain.triangulation),
        distribution_(distribution),
        ranks_(distribution.network()),
        members_(members),
        asked_numbers_(ranks_.count()),
        asked_data_(ranks_.count()) {}

  void number_own();
  void fetch_markers();
  void mark_own();
  void find_pieces();
  void resolve_halo();
  [[nodiscard]] VertexData take() { return std::move(data_); }

 private:
  [[nodiscard]] std::uint64_t number_common();
  [[nodiscard]] std::vector<Reason> reasons_for_markers() const;
  [[nodiscard]] int marker_of(VertexId v) const;
  void plan_questions();
  [[nodiscard]] Ranks::Bytes question_to(int rank) const;
  [[nodiscard]] Ranks::Bytes answer_to(const Ranks::Bytes& question) const;
  [[nodiscard]] std::uint64_t number_of(Name name) const;
  void take_answer(int rank, const Ranks::Bytes& answer);

  const DomainTriangulation& domain_;
  const Triangulation& t_;
  const Distribution& distribution_;
  Ranks& ranks_;
  const Members& members_;
  /// Of the vertices that the first rank has inserted in a submesh, before the division and at the end.
  VertexNumbers numbers_before_division_, numbers_in_submesh_;
  std::vector<std::pair<VertexId, int>> fetched_markers_;
  std::vector<std::vector<VertexId>> asked_numbers_, asked_data_;  ///< for each rank: what it is asked about
  VertexData data_;
};

/// Numbers the vertices from before the division, except the points of the input. Returns the number of all these
/// vertices, points of the input included.
std::uint64_t Collector::number_common() {
  std::uint64_t next = distribution_.inputs();
  if (distribution_.is_input_divided()) {
    const auto before_division = distribution_.inserted_before_division();
    for (std::size_t i = 0; i < before_division.size(); ++i)
      numbers_before_division_.add({before_division[i].id, before_division[i].id + 1}, next + i);
    numbers_before_division_.settle();
    return next + share_of_rank(before_division.size(), ranks_).all;
  }
  Index begin = distribution_.known_inputs();
  const auto number_until = [&](Index end) {
    data_.numbers.add({begin, end}, next);
    next += end - begin;
  };
  for (const IndexRange unused : distribution_.unused_common()) {
    number_until(unused.begin);
    begin = unused.end;
  }
  number_until(distribution_.common_vertices());
  return next;
}

void Collector::number_own() {
  std::uint64_t next = number_common();
  const Ownership& ownership = distribution_.ownership();
  std::vector<Index> place_on_curve(ownership.cells());
  for (Index place = 0; const Index cell : ownership.curve()) place_on_curve[cell] = place++;
  const auto own = distribution_.insertions();
  std::vector<Distribution::Insertions> insertions(own.begin(), own.end());
  std::ranges::stable_sort(insertions, {}, [&](const auto& each) { return place_on_curve[each.cell]; });
  std::uint64_t inserted = 0;
  for (const auto& each : insertions) inserted += each.vertices.size();
  const ShareOfRank share = share_of_rank(inserted, ranks_);
  data_.count = next + share.all;
  next += share.before;
  data_.first = ranks_.rank() == 0 ? distribution_.inputs() : next;
  for (const auto& each : insertions) {
    data_.numbers.add(each.vertices, next);
    next += each.vertices.size();
  }
  const auto in_submesh = distribution_.inserted_in_submesh();
  for (std::size_t i = 0; i < in_submesh.size(); ++i)
    numbers_in_submesh_.add({in_submesh[i].id, in_submesh[i].id + 1}, data_.count + i);
  data_.count += share_of_rank(in_submesh.size(), ranks_).all;
  data_.numbers.settle();
  numbers_in_submesh_.settle();
}

/// The marker of a vertex is its marker in the input. If this is 0 or missing, it is the marker of the first segment
/// with a marker on which the vertex lies. If there is none, it is 1 on the boundary and 0 elsewhere.
std::vector<Reason> Collector::reasons_for_markers() const {
  std::vector<Reason> reasons;
  const auto add = [&](VertexId v, Index rank, int marker) {
    if (members_.owns_vertex(v)) reasons.push_back({v, rank, marker});
  };
  for (VertexId v = 0; v < distribution_.known_inputs(); ++v)
    if (const int given = distribution_.input_point(v).marker; given != 0) add(v, 0, given);
  for (const auto& [v, given] : fetched_markers_)
    if (given != 0) add(v, 0, given);
  for (const EdgeRef e : members_.constrained_sides()) {
    const Slot& slot = t_.slot(e);
    const VertexId a = slot.from(e.side()), b = slot.to(e.side());
    const Index segment = domain_.segments.segment_of(t_, a, b);
    if (segment == no_index) continue;
    const Index input = domain_.input_segment[segment];
    const int marker = domain_.segments[segment].marker;
    for (const VertexId v : {a, b})
      if (marker != 0 && input != no_index)
        add(v, 1 + input, marker);
      else if (slot.n[e.side()].none())
        add(v, no_index, 1);
  }
  return reasons;
}

/// Asks for the markers of input points that this rank owns, but about which another one knows.
void Collector::fetch_markers() {
  if (!distribution_.lacks_markers()) return;
  std::vector<VertexId> vertices;
  std::vector<Name> names;
  for (const VertexId v : distribution_.part().vertices_of_others()) {
    if (t_.origin[v] != input_vertex || !members_.owns_vertex(v)) continue;
    vertices.push_back(v);
    names.push_back(distribution_.part().name_of_vertex(v));
  }
  const auto whom = [&](std::size_t i) { return Name::rank_of(names[i].creator); };
  const auto answer = [&](const std::vector<Name>& asked) {
    std::vector<int> markers;
    for (const Name name : asked) {
      if (name.id >= distribution_.known_inputs()) throw Reader::does_not_match();
      markers.push_back(distribution_.input_point(name.id).marker);
    }
    return markers;
  };
  const std::vector<int> markers = answers_of_ranks<int>(names, 1, ranks_, whom, answer);
  for (std::size_t i = 0; i < vertices.size(); ++i) fetched_markers_.emplace_back(vertices[i], markers[i]);
}

void Collector::mark_own() {
  std::vector<Reason> reasons = reasons_for_markers();
  std::ranges::sort(reasons, [](const Reason& a, const Reason& b) { return a.v != b.v ? a.v < b.v : a.rank < b.rank; });
  for (const Reason& reason : reasons)
    if (data_.markers.empty() || data_.markers.back().v != reason.v) data_.markers.push_back({reason.v, reason.marker});
}

int Collector::marker_of(VertexId v) const {
  const auto found = std::ranges::lower_bound(data_.markers, v, {}, &VertexData::Marker::v);
  return found != data_.markers.end() && found->v == v ? found->marker : 0;
}

/// A vertex of this rank lies in a triangle of another piece only if that triangle has a corner of another rank.
void Collector::find_pieces() {
  for (const std::vector<TriangleId>& list : {std::cref(members_.at_border()), std::cref(members_.of_others())})
    for (const TriangleId id : list)
      for (const VertexId v : t_.slots[id].v)
        if (members_.owns_vertex(v)) data_.pieces[v].push_back(distribution_.owner_of_triangle(id));
  for (auto& [v, ranks] : data_.pieces) {
    if (members_.has_vertex(v)) ranks.push_back(ranks_.rank());
    sort_without_repetitions(ranks);
  }
}

/// The first rank is asked about vertices that were inserted in a submesh.
void Collector::plan_questions() {
  for (const VertexId v : distribution_.part().vertices_of_others()) {
    if (!members_.has_vertex(v)) continue;
    const int rank = Name::rank_of(distribution_.part().name_of_vertex(v).creator);
    asked_numbers_[rank < ranks_.count() ? rank : 0].push_back(v);
  }
  for (const VertexId v : members_.not_owned()) asked_data_[distribution_.owner_of(v)].push_back(v);
}

Ranks::Bytes Collector::question_to(int rank) const {
  Writer message;
  for (const std::vector<VertexId>& vertices : {asked_numbers_[rank], asked_data_[rank]}) {
    std::vector<Name> names;
    for (const VertexId v : vertices) names.push_back(distribution_.part().name_of_vertex(v));
    message.list(names);
  }
  return message.take();
}

std::uint64_t Collector::number_of(Name name) const {
  const bool is_own = name.creator == Name::rank(ranks_.rank());
  if (is_own && name.id < distribution_.known_inputs()) return distribution_.input_point(name.id).number;
  const bool is_of_submesh = name.creator == Name::rank(ranks_.count());
  const VertexNumbers& numbers = is_own          ? data_.numbers
                                 : is_of_submesh ? numbers_in_submesh_
                                                 : numbers_before_division_;
  if (!numbers.has(name.id)) throw Reader::does_not_match();
  return numbers.of(name.id);
}

Ranks::Bytes Collector::answer_to(const Ranks::Bytes& question) const {
  Reader reader(question);
  std::vector<std::uint64_t> numbers;
  for (const Name name : reader.list<Name>()) numbers.push_back(number_of(name));
  std::vector<TravellingData> data;
  std::vector<int> all_pieces;
  for (const Name name : reader.list<Name>()) {
    const VertexId v = distribution_.part().vertex(name);
    if (v == no_index || !members_.owns_vertex(v)) throw Reader::does_not_match();
    const std::vector<int>& pieces = data_.pieces.at(v);
    data.push_back({marker_of(v), static_cast<std::uint32_t>(pieces.size())});
    all_pieces.insert(all_pieces.end(), pieces.begin(), pieces.end());
  }
  Writer message;
  message.list(numbers);
  message.list(data);
  message.list(all_pieces);
  return message.take();
}

void Collector::take_answer(int rank, const Ranks::Bytes& answer) {
  Reader reader(answer);
  const auto numbers = reader.list<std::uint64_t>();
  const auto data = reader.list<TravellingData>();
  const auto all_pieces = reader.list<int>();
  if (numbers.size() != asked_numbers_[rank].size() || data.size() != asked_data_[rank].size())
    throw Reader::does_not_match();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const VertexId v = asked_numbers_[rank][i];
    data_.numbers.add({v, v + 1}, numbers[i]);
  }
  auto next = all_pieces.begin();
  for (std::size_t i = 0; i < data.size(); ++i) {
    const VertexId v = asked_data_[rank][i];
    if (data[i].marker != 0) data_.markers.push_back({v, data[i].marker});
    data_.pieces[v] = {next, next + data[i].pieces};
    next += data[i].pieces;
  }
}

void Collector::resolve_halo() {
  plan_questions();
  std::vector<Ranks::Bytes> questions, answers;
  for (int rank = 0; rank < ranks_.count(); ++rank) questions.push_back(question_to(rank));
  for (const Ranks::Bytes& question : ranks_.exchange(std::move(questions))) answers.push_back(answer_to(question));
  const std::vector<Ranks::Bytes> arrived = ranks_.exchange(std::move(answers));
  for (int rank = 0; rank < ranks_.count(); ++rank) take_answer(rank, arrived[rank]);
  data_.numbers.settle();
}

}  // namespace

VertexData vertex_data(const DomainTriangulation& domain, const Distribution& distribution, const Members& members) {
  Collector collector(domain, distribution, members);
  collector.number_own();
  collector.fetch_markers();
  collector.mark_own();
  collector.find_pieces();
  collector.resolve_halo();
  return collector.take();
}

}  // namespace pardel::engine
