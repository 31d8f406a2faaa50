// Verifies the points of an answer.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../../parallel/arithmetic/clearance.hpp"
#include "../breach.hpp"
#include "../subdomain_mesher.hpp"

namespace pardel::engine {

/// A new point on an edge of a subdomain.
struct PointOnEdge {
  Index edge;
  double along;  ///< 0 at the start of the edge, 1 at its end
  Index point;
};

/// The first breach in the points of the answer, or nothing if they keep the contract. Moves the points on edges onto
/// their lines, and appends them to `on_edges`. `lines`: as for verify(). O(points).
[[nodiscard]] std::optional<Breach> verify_points(const Subdomain& subdomain, std::span<const EndPoints> lines,
                                                  RefinedSubdomain& answer, std::vector<PointOnEdge>& on_edges);

/// An edge, for messages.
[[nodiscard]] std::string text_of_edge(Point a, Point b);

}  // namespace pardel::engine
