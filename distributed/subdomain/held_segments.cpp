#include "held_segments.hpp"

namespace pardel::engine {
namespace {

/// Other origins travel in the lower half. No name has this creator.
constexpr std::uint64_t no_segment = std::uint64_t{no_index} << 32U;

/// The first elements of a list, which loses them.
template <class T>
std::span<const T> taken(std::span<const T>& list, std::size_t count) {
  if (count > list.size()) throw Reader::does_not_match();
  const std::span<const T> first = list.first(count);
  list = list.subspan(count);
  return first;
}

}  // namespace

DomainTriangulation HeldSegments::domain_of_common() const {
  DomainTriangulation common;
  for (Index s = 0; s < common_; ++s) {
    common.segments.add(domain_.segments[s], domain_.segments.places_beside_ends(s), domain_.segments.clearances(s));
    common.input_segment.push_back(domain_.input_segment[s]);
  }
  return common;
}

std::uint64_t HeldSegments::travelling_origin(Index origin) const {
  const Index segment = segment_of_origin(origin);
  return segment < domain_.segments.size() ? Names::packed(name_of(segment)) : no_segment | origin;
}

Index HeldSegments::arrived_origin(std::uint64_t origin) const {
  if (origin >= no_segment) return static_cast<Index>(origin);
  const Index segment = names_.index_of(Names::unpacked(origin));
  if (segment >= domain_.segments.size()) throw Reader::does_not_match();
  return origin_on_segment(segment);
}

HeldSegments::Outgoing HeldSegments::leaving_with(std::span<const VertexId> corners) {
  const Triangulation& t = domain_.triangulation;
  Outgoing outgoing;
  const auto add = [&](Index s) {
    if (s < common_ || is_listed_.get(s) != 0) return;
    is_listed_.set(s, 1);
    outgoing.segments.push_back(s);
  };
  for (const VertexId v : corners) {
    if (const Index s = segment_of_origin(t.origin[v]); s < domain_.segments.size()) add(s);
    if (t.origin[v] != input_vertex) continue;
    const std::span<const Index> here = domain_.segments.segments_at(v);
    if (here.empty()) continue;
    outgoing.ends.push_back(v);
    outgoing.count.push_back(static_cast<Index>(here.size()));
    for (const Index s : here) {
      add(s);
      outgoing.at_ends.push_back(s);
    }
  }
  for (const Index s : outgoing.segments) is_listed_.set(s, 0);
  return outgoing;
}

void HeldSegments::place(const TravellingSegment& arrived, std::span<const TravellingPlace> places,
                         std::span<const TravellingClearance> clearances, std::span<const VertexId> vertices) {
  const Name name = Names::unpacked(arrived.name);
  if (names_.index_of(name) != no_index) return;
  if (arrived.a >= vertices.size() || arrived.b >= vertices.size()) throw Reader::does_not_match();
  using Narrow = TravellingSegment::Narrow;
  const VertexId a = vertices[arrived.a], b = vertices[arrived.b];
  const VertexId apex = arrived.narrow == Narrow::at_a ? a : arrived.narrow == Narrow::at_b ? b : no_index;
  std::vector<PlaceBesideEnd> beside_ends;
  for (const TravellingPlace& each : places) beside_ends.push_back({each.at_b != 0 ? b : a, each.distance, each.gap});
  std::vector<Clearance> beside;
  for (const auto& [x, y, gap, slope, is_passed] : clearances) beside.push_back({{x, y}, gap, slope, is_passed != 0});
  names_.bind(name, static_cast<Index>(domain_.segments.size()));
  domain_.segments.add({a, b, arrived.cosine_at_a, arrived.cosine_at_b, apex, arrived.marker}, beside_ends, beside);
  domain_.input_segment.push_back(arrived.input);
}

void HeldSegments::read(Reader& message, std::span<const VertexId> vertices) {
  const auto segments = message.list<TravellingSegment>();
  const auto places = message.list<TravellingPlace>();
  const auto clearances = message.list<TravellingClearance>();
  std::span<const TravellingPlace> places_left = places;
  std::span<const TravellingClearance> clearances_left = clearances;
  for (const TravellingSegment& arrived : segments)
    place(arrived, taken(places_left, arrived.places), taken(clearances_left, arrived.clearances), vertices);
  if (!places_left.empty() || !clearances_left.empty()) throw Reader::does_not_match();
  const auto ends = message.list<TravellingEnd>();
  const auto names = message.list<std::uint64_t>();
  auto next = names.begin();
  std::vector<Index> here;
  for (const TravellingEnd& end : ends) {
    if (end.vertex >= vertices.size() || end.count > static_cast<std::size_t>(names.end() - next))
      throw Reader::does_not_match();
    here.clear();
    for (Index i = 0; i < end.count; ++i) {
      here.push_back(names_.index_of(Names::unpacked(*next++)));
      if (here.back() >= domain_.segments.size()) throw Reader::does_not_match();
    }
    const VertexId v = vertices[end.vertex];
    if (domain_.segments.segments_at(v).empty()) domain_.segments.add_end(v, here);
  }
  if (next != names.end()) throw Reader::does_not_match();
}

}  // namespace pardel::engine
