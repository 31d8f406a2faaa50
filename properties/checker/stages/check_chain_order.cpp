// Checks that the chains around each input point follow one another in the order of their segments.
#include "../arithmetic/text.hpp"
#include "stages.hpp"

namespace pardel::checker {
namespace {

/// Where the chain of each segment begins and ends in Chains::edges; an empty range if it has none.
struct ChainRange {
  std::size_t first = 0, last = 0;
};

std::vector<ChainRange> ranges_of(const Domain& domain, const Chains& chains) {
  std::vector<ChainRange> ranges(domain.segments().size());
  for (std::size_t i = 0; i < chains.edges.size(); ++i) {
    ChainRange& range = ranges[chains.edges[i].segment];
    if (range.first == range.last) range.first = i;
    range.last = i + 1;
  }
  return ranges;
}

}  // namespace

void check_chain_order(const Subject& subject, const Domain& domain, const Chains& chains, const InputVertices& inputs,
                       Findings& found) {
  const std::vector<ChainRange> ranges = ranges_of(domain, chains);
  check_each(subject.pslg.points.size(), found, [&](std::size_t i, Findings& mine) {
    const auto input = static_cast<Index>(i);
    const auto around = domain.faces().incident(input);
    if (around.size() < 3 || inputs.vertex(input) == no_index) return;
    std::vector<std::pair<Index, Point>> leaving;  // a segment, and the first vertex of its chain
    for (const Index s : around) {
      const auto [first, last] = ranges[s];
      if (first == last) continue;  // outside the domain, or reported as broken
      const bool forward = domain.segments()[s].a == input;
      leaving.emplace_back(s, subject.mesh.points[forward ? chains.edges[first].to : chains.edges[last - 1].from]);
    }
    // In this order the directions go around once, so they begin again exactly once.
    const Point centre = subject.mesh.points[inputs.vertex(input)];
    const auto next = [&](std::size_t k) { return (k + 1) % leaving.size(); };
    std::size_t turns = 0;
    for (std::size_t k = 0; k < leaving.size(); ++k)
      if (!counter_clockwise_before(centre, leaving[k].second, leaving[next(k)].second)) ++turns;
    if (leaving.size() < 3 || turns == 1) return;
    std::vector<Index> ids{input};
    Witness segments;
    for (const auto& [s, to] : leaving) {
      ids.push_back(s);
      segments += (segments.empty() ? "" : ", ") + segment_text(domain, s);
    }
    mine.add(ViolationKind::wrong_chain_order, std::move(ids), {centre},
             "around input point " + domain_number(i) + ", the first edges on " + segments +
                 " do not leave in this counter-clockwise order, as the segments do");
  });
}

}  // namespace pardel::checker
