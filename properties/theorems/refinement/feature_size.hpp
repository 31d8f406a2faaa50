// The local feature size of a domain, by its definition.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "../../../core/mesh.hpp"

namespace pardel::properties {

/// A vertex or a segment of the domain.
struct Feature {
  Index a, b;  ///< the ends of a segment; a == b for a vertex
};

inline double distance_to(const Mesh& domain, const Feature& feature, Point p) {
  const Point a = domain.points[feature.a], b = domain.points[feature.b];
  const double ux = b.x - a.x, uy = b.y - a.y, wx = p.x - a.x, wy = p.y - a.y;
  const double along = feature.a == feature.b ? 0 : std::clamp((ux * wx + uy * wy) / (ux * ux + uy * uy), 0.0, 1.0);
  return std::hypot(wx - along * ux, wy - along * uy);
}

/// The segments and vertices of a domain, given as its triangulation.
inline std::vector<Feature> features_of(const Mesh& domain) {
  std::vector<Feature> features;
  for (const ConstrainedEdge& e : domain.constrained_edges) features.push_back({e.a, e.b});
  for (Index v = 0; v < domain.points.size(); ++v) features.push_back({v, v});
  return features;
}

/// Ruppert's local feature size: the radius of the smallest disk around p that meets two features that do not touch.
inline double local_feature_size(const Mesh& domain, const std::vector<Feature>& features, Point p) {
  std::vector<std::pair<double, Feature>> nearest;
  for (const Feature& f : features) nearest.emplace_back(distance_to(domain, f, p), f);
  std::ranges::sort(nearest, {}, [](const auto& entry) { return entry.first; });
  const auto touch = [](const Feature& f, const Feature& g) {
    return f.a == g.a || f.a == g.b || f.b == g.a || f.b == g.b;
  };
  for (std::size_t i = 1; i < nearest.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!touch(nearest[i].second, nearest[j].second)) return nearest[i].first;
  return std::numeric_limits<double>::infinity();
}

}  // namespace pardel::properties
