// A fingerprint of values, with the numbering and the order of their parts. Tests compare it with a recorded one.
#pragma once

#include <bit>
#include <cstdint>
#include <cstdio>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "../core/mesh.hpp"
#include "../core/size_source.hpp"
#include "../core/support/hash.hpp"

namespace pardel::testing {

class Fingerprint {
 public:
  template <class... Ts>
  explicit Fingerprint(const Ts&... values) {
    add_all(values...);
  }
  template <class T>
  requires std::is_integral_v<T> || std::is_enum_v<T>
  void add(T value) { hash_ = mixed(hash_ * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(value)); }
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
  void add(const Pslg& p) {
    add_all(p.points, p.attributes_per_point, p.point_attributes, p.point_markers, p.segments, p.has_segment_markers,
            p.holes, p.regions);
  }
  void add(const Mesh& m) {
    add_all(m.points, m.triangles, m.origin, m.region, m.region_attributes, m.constrained_edges, m.attributes_per_point,
            m.point_attributes, m.point_markers);
  }
  /// Other types have a function add_to() in their own namespace.
  template <class T>
  requires requires(Fingerprint& to, const T& value) { add_to(to, value); }
  void add(const T& value) { add_to(*this, value); }
  template <class A, class B>
  void add(const std::pair<A, B>& pair) {
    add_all(pair.first, pair.second);
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

}  // namespace pardel::testing
