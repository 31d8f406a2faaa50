#include "digest.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "support/hash.hpp"
#include "support/point_order.hpp"

namespace pardel {

Digest operator+(Digest a, const Digest& b) {
  a.low += b.low;
  a.high += b.high + (a.low < b.low ? 1 : 0);
  return a;
}

namespace {

/// Two chains (lanes) of 64-bit mixes. They start from different values and multiply each word by different constants.
class Hash {
 public:
  Hash() = default;
  explicit Hash(std::uint64_t kind) : high_(mixed(kind)), low_(mixed(~kind)) {}
  void add(std::uint64_t word) {
    high_ = mixed(high_ ^ (word * 0x9e3779b97f4a7c15u));
    low_ = mixed(low_ + (word * 0xd1342543de82ef95u) + 0x2545f4914f6cdd1du);
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }  // -0 + 0 is +0
  void add(const Point& p) {
    add(p.x);
    add(p.y);
  }
  [[nodiscard]] Digest value() const { return {mixed(high_ + low_), mixed(low_ ^ (high_ * 0x9e3779b97f4a7c15u))}; }

 private:
  std::uint64_t high_ = 0;
  std::uint64_t low_ = 0;
};

constexpr std::uint64_t triangle_kind = 3;
constexpr std::uint64_t edge_kind = 2;

/// 1 if a is lexicographically less than b, else 0; without branches.
std::size_t is_less(Point a, Point b) {
  const auto number = [](bool holds) { return static_cast<std::size_t>(holds); };
  return number(a.x < b.x) | (number(a.x == b.x) & number(a.y < b.y));
}

/// Asks for the points of a triangle that follows soon.
void prefetch_points(const Mesh& mesh, std::size_t t) {
  if (t >= mesh.triangles.size()) return;
  for (const Index v : mesh.triangles[t].v) __builtin_prefetch(&mesh.points[v]);
}

constexpr std::size_t words_per_triangle = 7;

/// The corners, from the least on, and the attribute.
inline std::array<double, words_per_triangle> words_of_triangle(const Mesh& mesh, std::size_t t) {
  constexpr std::size_t soon = 16;
  prefetch_points(mesh, t + soon);
  const auto& v = mesh.triangles[t].v;
  const Point a = mesh.points[v[0]], b = mesh.points[v[1]], c = mesh.points[v[2]];
  const std::array<Point, 5> p{a, b, c, a, b};
  // The least corner is anywhere, so a processor would guess wrong branches. This has none.
  const std::size_t b_first = is_less(b, a), c_before_a = is_less(c, a), c_before_b = is_less(c, b);
  const std::size_t first = b_first * (1 + c_before_b) + (1 - b_first) * 2 * c_before_a;
  const Point &d = p[first], &e = p[first + 1], &f = p[first + 2];
  const Index region = mesh.region.empty() ? no_index : mesh.region[t];
  const double attribute = region == no_index ? 0.0 : mesh.region_attributes[region];
  return {d.x, d.y, e.x, e.y, f.x, f.y, attribute};
}

/// The sum of the hashes of n triangles from t on. Each multiplication of a hash waits for the one before, so a
/// processor computes several hashes in little more time than one.
template <std::size_t n>
Digest hash_triangles(const Mesh& mesh, std::size_t t) {
  std::array<std::array<double, words_per_triangle>, n> words;
  for (std::size_t k = 0; k < n; ++k) words[k] = words_of_triangle(mesh, t + k);
  std::array<Hash, n> hashes;
  hashes.fill(Hash(triangle_kind));
  for (std::size_t i = 0; i < words_per_triangle; ++i)
    for (std::size_t k = 0; k < n; ++k) hashes[k].add(words[k][i]);
  Digest sum;
  for (const Hash& hash : hashes) sum = sum + hash.value();
  return sum;
}

Digest hash_edge(const Mesh& mesh, const ConstrainedEdge& edge) {
  Point a = mesh.points[edge.a];
  Point b = mesh.points[edge.b];
  if (lexicographically_less(b, a)) std::swap(a, b);
  Hash hash(edge_kind);
  hash.add(a);
  hash.add(b);
  hash.add(static_cast<std::uint64_t>(static_cast<std::int64_t>(edge.marker)));
  return hash.value();
}

/// The sum of hash(i) for i < n, computed on all threads. Each block of indices stores its own sum, so no thread waits
/// for another. The sums are added in the order of the blocks.
template <class HashOne>
Digest sum(std::size_t n, const HashOne& hash) {
  constexpr std::size_t block = 4096, few = 25'000;
  std::vector<Digest> parts((n + block - 1) / block);
#pragma omp parallel for schedule(dynamic, 1) if (n > few)
  for (std::size_t b = 0; b < parts.size(); ++b) {
    Digest part;
    for (std::size_t i = b * block; i < std::min(n, (b + 1) * block); ++i) part = part + hash(i);
    parts[b] = part;
  }
  Digest total;
  for (const Digest& part : parts) total = total + part;
  return total;
}

}  // namespace

Digest digest(const Mesh& mesh) {
  constexpr std::size_t at_once = 4;
  const std::size_t n = mesh.triangles.size(), groups = n / at_once;
  Digest all = sum(groups, [&](std::size_t g) { return hash_triangles<at_once>(mesh, at_once * g); });
  for (std::size_t t = at_once * groups; t < n; ++t) all = all + hash_triangles<1>(mesh, t);
  return all +
         sum(mesh.constrained_edges.size(), [&](std::size_t i) { return hash_edge(mesh, mesh.constrained_edges[i]); });
}

std::string to_string(const Digest& digest) {
  constexpr char digits[] = "0123456789abcdef";
  std::string text(32, '0');
  for (std::size_t i = 0; i < 16; ++i) {
    text[15 - i] = digits[(digest.high >> (4 * i)) & 15];
    text[31 - i] = digits[(digest.low >> (4 * i)) & 15];
  }
  return text;
}

}  // namespace pardel
