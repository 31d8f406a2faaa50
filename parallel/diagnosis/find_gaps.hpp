// Finds the narrow places of a domain in its constrained Delaunay triangulation.
#pragma once

#include <cstddef>
#include <vector>

#include "../construction/domain_triangulation.hpp"
#include "../gaps.hpp"

namespace pardel::engine {

/// One of several shares of nearly equal size.
struct Share {
  std::size_t number = 0, of = 1;

  /// The items of the share, of n items in all.
  [[nodiscard]] std::size_t begin(std::size_t n) const { return n * number / of; }
  [[nodiscard]] std::size_t end(std::size_t n) const { return n * (number + 1) / of; }
};

/// The gaps that the triangles of a share show, in any order and some of them several times. Precondition: nothing has
/// been refined yet.
[[nodiscard]] std::vector<Gap> gaps_in_share(const DomainTriangulation& domain, Share share, const Threads& threads);

/// Sorts the gaps of all shares. Leaves out gaps that are not narrower than a millionth of the extent of the segments
/// of about the same scale, unless they are always narrow, and a gap whose first point, or of two close points either
/// one, is in a narrower gap.
[[nodiscard]] std::vector<Gap> narrowest_first(std::vector<Gap> gaps, const DomainTriangulation& domain);

/// As pardel::find_gaps(). Precondition: nothing has been refined yet. O(n) if few triangles are narrow.
[[nodiscard]] std::vector<Gap> find_gaps(const DomainTriangulation& domain, const Threads& threads);

}  // namespace pardel::engine
