// Subdomains and answers as the bytes of a message between processes on one machine.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "../subdomain_mesher.hpp"

namespace pardel::engine {

using Bytes = std::vector<std::byte>;

/// `seconds` takes the place of subdomain.seconds. Calls subdomain.goal.size, if there is one, at the points and
/// centroids. Precondition: the corners of the triangles are points.
[[nodiscard]] Bytes to_bytes(const Subdomain& subdomain, double seconds);
/// The size of the goal interpolates those that were sent. Throws Stopped if the bytes are no subdomain.
[[nodiscard]] Subdomain subdomain_from(std::span<const std::byte> bytes);

[[nodiscard]] Bytes to_bytes(const RefinedSubdomain& answer);
/// Throws Stopped if the bytes are no answer.
[[nodiscard]] RefinedSubdomain answer_from(std::span<const std::byte> bytes);

}  // namespace pardel::engine
