#include "messages.hpp"

#include <memory>

#include "../../core/support/message.hpp"
#include "sampled_sizes.hpp"

namespace pardel::engine {
namespace {

/// The numbers of a subdomain.
struct Numbers {
  double min_angle_deg, max_area, max_edge;
  SubdomainCell cell;
  double min_edge, seconds;
  std::uint64_t most_new_points, has_cell;
};

/// A SubdomainEdge without bytes that are never written.
struct PackedEdge {
  Index a, b, is_inside, may_be_split;
};

Numbers numbers_of(const Subdomain& s, double seconds) {
  return {s.goal.min_angle_deg, s.goal.max_area, s.goal.max_edge,   s.cell.value_or(SubdomainCell{}),
          s.min_edge,           seconds,         s.most_new_points, s.cell ? 1U : 0U};
}

/// Throws Stopped unless the whole message has been read.
void require(bool fits) {
  if (!fits) throw Reader::does_not_match();
}

template <class T>
T single(Reader& reader) {
  const std::vector<T> values = reader.list<T>();
  require(values.size() == 1);
  return values.front();
}

}  // namespace

Bytes to_bytes(const Subdomain& subdomain, double seconds) {
  Writer writer;
  writer.list_of<Numbers>(1, [&](std::size_t) { return numbers_of(subdomain, seconds); });
  writer.list(subdomain.points);
  writer.list(subdomain.triangles);
  writer.list_of<PackedEdge>(subdomain.edges.size(), [&](std::size_t i) -> PackedEdge {
    const SubdomainEdge& e = subdomain.edges[i];
    return {e.a, e.b, e.inside ? 1U : 0U, e.may_be_split ? 1U : 0U};
  });
  writer.list(subdomain.max_areas);
  writer.list(subdomain.goal.size ? sample_sizes(subdomain) : std::vector<double>{});
  return writer.take();
}

Subdomain subdomain_from(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  const auto numbers = single<Numbers>(reader);
  Subdomain result;
  result.goal.min_angle_deg = numbers.min_angle_deg;
  result.goal.max_area = numbers.max_area;
  result.goal.max_edge = numbers.max_edge;
  if (numbers.has_cell != 0) result.cell = numbers.cell;
  result.min_edge = numbers.min_edge;
  result.seconds = numbers.seconds;
  result.most_new_points = numbers.most_new_points;
  result.points = reader.list<Point>();
  result.triangles = reader.list<std::array<Index, 3>>();
  for (const PackedEdge& e : reader.list<PackedEdge>())
    result.edges.push_back({e.a, e.b, e.is_inside != 0, e.may_be_split != 0});
  result.max_areas = reader.list<double>();
  std::vector<double> sizes = reader.list<double>();
  require(reader.empty());
  if (!sizes.empty())
    result.goal.size = [all = std::make_shared<const SampledSizes>(result.points, result.triangles, std::move(sizes))](
                           Point p) { return all->at(p); };
  return result;
}

Bytes to_bytes(const RefinedSubdomain& answer) {
  Writer writer;
  writer.list_of<RefinedSubdomain::Ending>(1, [&](std::size_t) { return answer.ending; });
  writer.list(std::span<const char>(answer.why));
  writer.list(answer.points);
  writer.list(answer.edge_of_new_point);
  writer.list(answer.triangles);
  return writer.take();
}

RefinedSubdomain answer_from(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  RefinedSubdomain result;
  const auto ending = single<std::uint8_t>(reader);
  require(ending <= static_cast<std::uint8_t>(RefinedSubdomain::Ending::unreadable));
  result.ending = static_cast<RefinedSubdomain::Ending>(ending);
  const std::vector<char> why = reader.list<char>();
  result.why.assign(why.begin(), why.end());
  result.points = reader.list<Point>();
  result.edge_of_new_point = reader.list<Index>();
  result.triangles = reader.list<std::array<Index, 3>>();
  require(reader.empty());
  return result;
}

}  // namespace pardel::engine
