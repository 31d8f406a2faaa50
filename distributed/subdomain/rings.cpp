#include "rings.hpp"

#include <algorithm>
#include <utility>

#include "../../core/support/collective.hpp"
#include "../../core/support/exchange_lists.hpp"

namespace pardel::engine {

/// A corner on its way to the owner of its vertex.
struct Rings::TravellingCorner {
  Name triangle;
  std::uint64_t number;
};

Rings::Rings(const Subdomain& part, const Triangulation& t, Ranks& ranks, Owner owner,
             std::span<const TriangleId> centre)
    : part_(part), t_(t), ranks_(ranks), owner_(std::move(owner)) {
  for (const TriangleId id : centre) add(id);
}

void Rings::add(TriangleId id) {
  constexpr unsigned is_listed = 8;
  const unsigned marks = marks_.get(id);
  if ((marks & is_listed) != 0) return;
  marks_.set(id, static_cast<unsigned char>(marks | is_listed));
  triangles_.push_back(id);
  for (unsigned corner = 0; corner < 3; ++corner) next_.push_back({id, corner});
}

bool Rings::mark(Corner c) {
  const unsigned marks = marks_.get(c.triangle), marked = 1U << c.number;
  marks_.set(c.triangle, static_cast<unsigned char>(marks | marked));
  return (marks & marked) == 0;
}

/// Around a vertex on the boundary of the domain, there are triangles on both sides of the one with the corner.
void Rings::walk_around(Corner c) {
  if (!mark(c)) return;
  const VertexId v = t_.slots[c.triangle].v[c.number];
  add(c.triangle);
  for (const auto* turn : {&next_corner, &previous_corner})
    for (Corner at = c;;) {
      const EdgeRef across = t_.slots[at.triangle].n[(*turn)[at.number]];
      if (across.none()) break;
      if (part_.is_beyond(across)) throw Reader::does_not_match();  // the rank is not the owner of the vertex
      at = {across.triangle(), t_.slot(across).corner_of(v)};
      if (!mark(at)) break;
      add(at.triangle);
    }
}

void Rings::grow_around(std::span<const Name> vertices) {
  std::vector<VertexId> here;
  for (const Name name : vertices)
    if (const VertexId v = part_.vertex(name); v != no_index) here.push_back(v);
  std::ranges::sort(here);
  next_.clear();
  for (const TriangleId id : triangles_)
    for (unsigned corner = 0; corner < 3; ++corner)
      if (vertices.empty() || std::ranges::binary_search(here, t_.slots[id].v[corner])) next_.push_back({id, corner});
}

void Rings::grow() {
  const std::size_t before = triangles_.size();
  std::vector<std::vector<TravellingCorner>> leaving(static_cast<std::size_t>(ranks_.count()));
  for (const Corner c : std::exchange(next_, {})) {
    const int owner = owner_(t_.slots[c.triangle].v[c.number]);
    if (owner == ranks_.rank())
      walk_around(c);
    else if (mark(c))
      leaving[owner].push_back({part_.name_of(c.triangle), c.number});
  }
  for (const TravellingCorner& c : concatenated(exchange_lists(std::move(leaving), ranks_))) {
    const TriangleId id = part_.triangle(c.triangle);
    if (id == no_index || c.number > 2) throw Reader::does_not_match();
    walk_around({id, static_cast<unsigned>(c.number)});
  }
  is_complete_ = sum_of(triangles_.size() - before, ranks_) == 0;
}

}  // namespace pardel::engine
