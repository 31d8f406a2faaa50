#include "subdomain.hpp"

#include <limits>
#include <unordered_map>

namespace pardel::engine {

struct Subdomain::TravellingVertex {
  std::uint64_t name;
  Point at;
  std::uint64_t origin;  ///< HeldSegments::travelling_origin() if ranks have different segments
};

struct Subdomain::TravellingTriangle {
  std::uint64_t name;
  std::array<Index, 3> v;          ///< places in the message's list of vertices
  Index region;                    ///< no_index if triangles have no regions
  std::array<std::uint64_t, 3> n;  ///< see Subdomain::travelling
};

namespace {

/// A side of a triangle as it travels: the name of the neighbour's slot, the side there, and the constrained bit. Three
/// special values say that there is no neighbour, or that the sender does not hold it (with and without the bit).
constexpr std::uint64_t no_neighbour = UINT64_MAX, not_held = UINT64_MAX - 3;
constexpr std::uint64_t constrained_bit = 1;
constexpr unsigned bits_of_side = 3;

/// So many indices are taken at a time.
constexpr std::size_t chunk = 1024;

std::vector<IndexRange> some_of(IndexAllocator& indices, std::size_t count) {
  std::vector<IndexRange> ranges;
  indices.allocate(count, ranges);
  if (ranges.empty() && count > 0)
    throw Stopped{{ErrorKind::resources, "a rank has more triangles than it can number"}};
  return ranges;
}

}  // namespace

Subdomain::Subdomain(Triangulation& t, IndexAllocator& vertices, IndexAllocator& triangles, std::uint32_t self,
                     Common common, HeldSegments* segments)
    : t_(t),
      segments_(segments),
      vertices_(vertices),
      triangles_(&triangles),
      common_(common),
      vertex_names_(self, common.vertices),
      triangle_names_(self, common.triangles),
      beyond_(0),
      no_corner_(0) {
  // Unused indices among the common ones must not be used for something new: all ranks would give it the same name.
  static_cast<void>(some_of(vertices_, vertices_.end() - vertices_.in_use()));
  const std::vector<IndexRange> unused = some_of(*triangles_, triangles_->end() - triangles_->in_use());
  no_corner_ = new_vertex();
  beyond_ = new_slot();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  t_.points[no_corner_] = {nan, nan};
  t_.slots[beyond_].v.fill(no_corner_);
  for (const IndexRange range : unused)
    for (TriangleId id = range.begin; id < range.end; ++id) forget(id);
}

void Subdomain::make_room() {
  if (t_.points.size() < vertices_.end()) {
    t_.points.resize_uninitialised(vertices_.end());
    t_.origin.resize_uninitialised(vertices_.end());
  }
  if (t_.slots.size() < triangles_->end()) {
    t_.slots.resize_uninitialised(triangles_->end());
    if (!t_.region.empty()) t_.region.resize_uninitialised(triangles_->end());
  }
}

Index Subdomain::new_vertex() {
  if (new_vertices_.left() == 0) {
    new_vertices_ = IndexPool(some_of(vertices_, chunk));
    make_room();
  }
  return new_vertices_.take();
}

Index Subdomain::new_slot() {
  if (spare_.empty()) {
    const std::vector<IndexRange> ranges = some_of(*triangles_, chunk);
    make_room();
    for (const IndexRange range : ranges)
      for (TriangleId id = range.begin; id < range.end; ++id) {
        t_.slots[id] = {{no_corner_, no_corner_, no_corner_}, {}};
        spare_.push_back(id);
      }
  }
  const TriangleId id = spare_.back();
  spare_.pop_back();
  return id;
}

/// The neighbours of the triangle no longer refer to it.
void Subdomain::detach(TriangleId id) {
  for (unsigned side = 0; side < 3; ++side) {
    const EdgeRef across = t_.slots[id].n[side];
    if (across.none() || is_beyond(across)) continue;
    EdgeRef& back = t_.slots[across.triangle()].n[across.side()];
    if (!back.none() && back.triangle() == id) back = beyond(back.constrained());
  }
}

void Subdomain::forget(TriangleId id) {
  t_.slots[id] = {{no_corner_, no_corner_, no_corner_}, {}};
  triangle_names_.release(id);
  spare_.push_back(id);
}

void Subdomain::drop(TriangleId id) {
  detach(id);
  forget(id);
}

std::uint64_t Subdomain::travelling(EdgeRef across) const {
  if (across.none()) return no_neighbour;
  const std::uint64_t constrained = across.constrained() ? constrained_bit : 0;
  if (is_beyond(across)) return not_held + constrained;
  return Names::packed(name_of(across.triangle())) << bits_of_side | across.side() << 1U | constrained;
}

void Subdomain::write(std::span<const TriangleId> triangles, std::span<const Name> dropped, Writer& message) {
  std::vector<VertexId> vertices;
  const auto add = [&](VertexId v) {
    if (place_in_message_.get(v) != 0) return;
    vertices.push_back(v);
    place_in_message_.set(v, static_cast<Index>(vertices.size()));
  };
  for (const TriangleId id : triangles)
    for (const VertexId v : t_.slots[id].v) add(v);
  HeldSegments::Outgoing segments;
  if (segments_ != nullptr) {
    segments = segments_->leaving_with(vertices);
    for (const Index s : segments.segments)
      for (const VertexId v : {segments_->segments()[s].a, segments_->segments()[s].b}) add(v);
  }
  const auto place_of = [&](VertexId v) { return place_in_message_.get(v) - 1; };
  constexpr std::size_t counts = 3 * sizeof(std::uint64_t);
  message.reserve(counts + vertices.size() * sizeof(TravellingVertex) + triangles.size() * sizeof(TravellingTriangle) +
                  dropped.size_bytes());
  message.list_of<TravellingVertex>(vertices.size(), [&](std::size_t i) {
    const VertexId v = vertices[i];
    const Index origin = t_.origin[v];
    return TravellingVertex{Names::packed(vertex_names_.of(v)), t_.points[v],
                            segments_ != nullptr ? segments_->travelling_origin(origin) : origin};
  });
  message.list_of<TravellingTriangle>(triangles.size(), [&](std::size_t i) {
    const TriangleId id = triangles[i];
    is_known_elsewhere_.set(id, 1);
    const Slot& slot = t_.slots[id];
    return TravellingTriangle{Names::packed(name_of(id)),
                              {place_of(slot.v[0]), place_of(slot.v[1]), place_of(slot.v[2])},
                              t_.region.empty() ? no_index : t_.region[id],
                              {travelling(slot.n[0]), travelling(slot.n[1]), travelling(slot.n[2])}};
  });
  message.list(dropped);
  if (segments_ != nullptr) segments_->write(segments, place_of, message);
  for (const VertexId v : vertices) place_in_message_.set(v, 0);
}

/// A new vertex counts as a point of the input, until its origin is set.
VertexId Subdomain::place(Name name, Point at) {
  VertexId v = vertex_names_.index_of(name);
  if (v == no_index) {
    v = new_vertex();
    vertex_names_.bind(name, v);
    vertices_of_others_.push_back(v);
    t_.points[v] = at;
    t_.origin[v] = input_vertex;
  }
  return v;
}

void Subdomain::add(std::span<const LoosePoint> loose) {
  for (const LoosePoint& point : loose) static_cast<void>(place(point.name, point.at));
  vertices_.settle();
}

TriangleId Subdomain::place(const TravellingTriangle& triangle, std::span<const VertexId> vertices) {
  const Name name = Names::unpacked(triangle.name);
  TriangleId id = triangle_names_.index_of(name);
  if (id == no_index) {
    id = new_slot();
    triangle_names_.bind(name, id);
  } else {
    detach(id);
  }
  // Also a triangle that this rank has named: others may know it by a message of a third rank.
  is_known_elsewhere_.set(id, 1);
  Slot& slot = t_.slots[id];
  for (unsigned i = 0; i < 3; ++i) {
    if (triangle.v[i] >= vertices.size()) throw Reader::does_not_match();
    slot.v[i] = vertices[triangle.v[i]];
    slot.n[i] = triangle.n[i] == no_neighbour ? EdgeRef() : beyond((triangle.n[i] & constrained_bit) != 0);
  }
  if (!t_.region.empty()) t_.region[id] = triangle.region;
  return id;
}

void Subdomain::link(const TravellingTriangle& triangle, TriangleId id) {
  for (unsigned side = 0; side < 3; ++side) {
    const std::uint64_t across = triangle.n[side];
    if (across >= not_held) continue;
    if (!is_beyond(t_.slots[id].n[side])) continue;  // the triangle across came earlier, and has linked both
    const TriangleId other = triangle_names_.index_of(Names::unpacked(across >> bits_of_side));
    if (other == no_index) continue;
    t_.link({id, side}, {other, static_cast<unsigned>(across >> 1U & 3U), (across & constrained_bit) != 0});
  }
}

void Subdomain::sew() {
  std::unordered_map<std::uint64_t, EdgeRef> loose;  // by the ends of the side, in the direction of its triangle
  const auto key = [](VertexId from, VertexId to) { return std::uint64_t{from} << 32U | to; };
  for_each_triangle([&](TriangleId id) {
    const Slot& slot = t_.slots[id];
    for (unsigned side = 0; side < 3; ++side) {
      if (!is_beyond(slot.n[side])) continue;
      const auto other = loose.find(key(slot.to(side), slot.from(side)));
      if (other == loose.end()) {
        loose.emplace(key(slot.from(side), slot.to(side)), EdgeRef(id, side, slot.n[side].constrained()));
        continue;
      }
      t_.link({id, side}, other->second);
      loose.erase(other);
    }
  });
}

struct Subdomain::Arrived {
  PackedList<TravellingTriangle> triangles;
  std::vector<TriangleId> ids;
};

void Subdomain::read(std::span<const Ranks::Bytes> messages) {
  std::vector<Arrived> all;
  for (const Ranks::Bytes& bytes : messages) {
    if (bytes.empty()) continue;
    Reader message(bytes);
    const auto travelling_vertices = message.packed_list<TravellingVertex>();
    std::vector<VertexId> vertices(travelling_vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i] = place(Names::unpacked(travelling_vertices[i].name), travelling_vertices[i].at);
    Arrived& arrived = all.emplace_back(Arrived{message.packed_list<TravellingTriangle>(), {}});
    const auto dropped = message.packed_list<Name>();
    for (std::size_t i = 0; i < dropped.size(); ++i)
      if (const TriangleId id = triangle(dropped[i]); id != no_index) drop(id);
    if (segments_ != nullptr) segments_->read(message, vertices);
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const std::uint64_t origin = travelling_vertices[i].origin;
      t_.origin[vertices[i]] = segments_ != nullptr ? segments_->arrived_origin(origin) : static_cast<Index>(origin);
    }
    arrived.ids.resize(arrived.triangles.size());
    for (std::size_t i = 0; i < arrived.ids.size(); ++i) arrived.ids[i] = place(arrived.triangles[i], vertices);
  }
  for (const Arrived& arrived : all)
    for (std::size_t i = 0; i < arrived.ids.size(); ++i) link(arrived.triangles[i], arrived.ids[i]);
  vertices_.settle();
  triangles_->settle();
}

}  // namespace pardel::engine
