#include "wrong_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "families.hpp"

namespace pardel::wrong_meshes {

std::span<const Kind> all() {
  static const std::vector<Kind> list = [] {
    std::vector<Kind> joined;
    for (const auto family :
         {kinds_of_moved_chains(), kinds_of_holes_and_outlines(), kinds_of_pinched_chains(), kinds_of_orders(),
          kinds_of_changed_sides(), kinds_of_excuses(), kinds_of_labels(), kinds_of_sizes(), kinds_of_structure()})
      joined.insert(joined.end(), family.begin(), family.end());
    return joined;
  }();
  return list;
}

std::optional<WrongMesh> make(const Kind& kind, std::uint64_t seed) {
  generators::Random random(seed);
  constexpr int tries = 100;
  for (int i = 0; i < tries; ++i)
    if (auto mesh = kind.make(random.next())) return mesh;
  return std::nullopt;
}

void add_stray(Drawing& drawing, Stray stray, double far) {
  const auto square = [&](double low, double high) {
    std::vector<Index> corners;
    for (const auto& [x, y] : {std::pair(low, low), {high, low}, {high, high}, {low, high}})
      corners.push_back(drawing.point(x, y));
    drawing.ring(corners);
  };
  switch (stray) {
    case Stray::point:
      drawing.point(far, far);
      break;
    case Stray::component:
      square(far, 2 * far);
      break;
    case Stray::outline_around:
      square(-far, far);
      break;
    case Stray::island_in_its_hole:
      square(-2 * far, 2 * far);
      square(-far, far);
      drawing.hole(-far / 2, -far / 2);
      break;
  }
}

namespace {

std::string kinds_in(const Certificate& certificate) {
  std::string text;
  for (std::size_t k = 0; k < certificate.violation_counts.size(); ++k)
    if (const auto n = certificate.violation_counts[k]; n > 0)
      text += " " + std::to_string(n) + " " + name(static_cast<ViolationKind>(k));
  return text.empty() ? " nothing" : text;
}

bool is_near(const WrongMesh& mesh, Point p) {
  return std::ranges::any_of(mesh.fault, [&](Point f) { return std::hypot(p.x - f.x, p.y - f.y) <= mesh.reach; });
}

}  // namespace

std::string missed(const Kind& kind, const WrongMesh& mesh, const Certificate& certificate) {
  if (kind.is_right()) {
    if (certificate.valid && certificate.violations.empty()) return {};
    return "a right mesh is refused:" + kinds_in(certificate) +
           (certificate.violations.empty() ? "" : ", first " + certificate.violations.front().message());
  }
  if (certificate.valid) return "it is accepted";
  bool is_expected = false;
  for (const Violation& v : certificate.violations) {
    if (std::ranges::find(kind.expected, v.kind) == kind.expected.end()) continue;
    is_expected = true;
    if (!v.ids.empty() && std::ranges::any_of(v.where, [&](Point p) { return is_near(mesh, p); })) return {};
  }
  return (is_expected ? "no violation names the place:" : "it is refused for another reason:") + kinds_in(certificate);
}

}  // namespace pardel::wrong_meshes
