// A fingerprint of everything that a stage of the engine makes, with the numbering and the order of its parts.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>

#include "../../../core/mesh.hpp"
#include "../../../core/size_source.hpp"
#include "../../../core/support/hash.hpp"
#include "../../../parallel/triangulation/triangulation.hpp"

namespace pardel::recorded {

class Fingerprint {
 public:
  template <class... Ts>
  explicit Fingerprint(const Ts&... values) {
    add_all(values...);
  }
  template <class T>
    requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T value) {
    hash_ = mixed(hash_ * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(value));
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }  // -0 + 0 is 0
  void add(Point p) { add_all(p.x, p.y); }
  void add(std::string_view text) {
    add(text.size());
    for (const char c : text) add(c);
  }
  void add(const std::string& text) { add(std::string_view(text)); }
  void add(const Segment& s) { add_all(s.a, s.b, s.marker); }
  void add(const Region& r) { add_all(r.seed, r.attribute, r.max_area); }
  void add(const SizeSource& s) { add_all(s.a, s.b, s.at_a, s.at_b); }
  void add(const Triangle& t) { add_all(t.v, t.n); }
  void add(const ConstrainedEdge& e) { add_all(e.a, e.b, e.segment, e.marker); }
  void add(engine::EdgeRef e) { add_all(e.triangle(), e.side(), e.constrained()); }
  void add(const engine::Slot& s) { add_all(s.v, s.n); }
  void add(const engine::Triangulation& t) { add_all(t.points, t.slots, t.origin, t.region); }
  void add(const Pslg& p) {
    add_all(p.points, p.attributes_per_point, p.point_attributes, p.point_markers, p.segments, p.has_segment_markers,
            p.holes, p.regions);
  }
  void add(const Mesh& m) {
    add_all(m.points, m.triangles, m.origin, m.region, m.region_attributes, m.constrained_edges,
            m.attributes_per_point, m.point_attributes, m.point_markers);
  }
  template <std::ranges::range Range>
  void add(const Range& range) {
    add(std::ranges::size(range));
    for (const auto& each : range) add(each);
  }
  template <class... Ts>
  void add_all(const Ts&... values) {
    (add(values), ...);
  }

  [[nodiscard]] std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
    return digits;
  }

 private:
  std::uint64_t hash_ = 0;
};

template <class... Ts>
[[nodiscard]] std::string fingerprint(const Ts&... values) {
  return Fingerprint(values...).text();
}

}  // namespace pardel::recorded
