// What the first rank decides on the skeleton, and all ranks need.
#pragma once

#include <cstdint>
#include <vector>

#include "skeleton.hpp"

namespace pardel::checker {

/// A mesh edge on a segment, by the numbers of its ends in the whole mesh.
struct NumberedChainEdge {
  std::uint64_t from, to;
  Index segment;
};

struct Judgement {
  std::vector<NumberedChainEdge> chains;
  /// An input point, and the number of the vertex there. Settled points that are not in the skeleton are left out.
  struct VertexOfInput {
    std::uint64_t number;
    Index input;
    Index unused = 0;
  };
  std::vector<VertexOfInput> vertices_of_inputs;
  std::vector<Index> suspects;  ///< holes with seeds that triangles may contain
  double area = 0;              ///< the area of the triangles, rounded once

  [[nodiscard]] Ranks::Bytes message() const;
  [[nodiscard]] static Judgement read(const Ranks::Bytes& message);
};

/// `settled`: see settled_inputs(). Checks on the skeleton what the stages of check() check on a whole mesh: the
/// vertices of the boundary, input vertices, chains, coverage, and labels if they are usable in all pieces.
/// `counter_clockwise`: all triangles of all pieces are.
[[nodiscard]] Judgement judge(const Skeleton& skeleton, const NumberSet& settled, const Task& task,
                              const Domain& domain, bool labels, bool counter_clockwise, Findings& found);

}  // namespace pardel::checker
