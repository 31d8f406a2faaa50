#include "judgement.hpp"

#include <numeric>

#include "../../../core/support/message.hpp"

namespace pardel::checker {
namespace {

/// The neighbours in the skeleton. Sides between two vertices that are not special have no neighbour there, but are no
/// boundary edges: the triangle beyond them is not in the skeleton. Reports edges with too many triangles: sides
/// of these are boundary edges, so all of them are here.
Adjacency adjacency_of(const Skeleton& skeleton, const Subject& subject, Findings& found) {
  Array<Triangle> triangles = skeleton.mesh.triangles;
  std::vector<NonManifoldEdge> non_manifold;
  rebuild_neighbours(triangles.span(), non_manifold, found.stop());
  report_non_manifold(subject, non_manifold, found);
  Scan scanned = scan(skeleton.mesh.points.span(), std::as_const(triangles).span(), {}, found.stop());
  std::erase_if(scanned.boundary, [&](const BoundaryEdge& edge) {
    return skeleton.is_special[edge.from] == 0 && skeleton.is_special[edge.to] == 0;
  });
  return {std::move(triangles), std::move(scanned.start), std::move(scanned.boundary)};
}

}  // namespace

Judgement judge(const Skeleton& skeleton, const NumberSet& settled, const Task& task, const Domain& domain, bool labels,
                bool counter_clockwise, Findings& found) {
  const Subject subject{task.pslg,
                        skeleton.mesh,
                        task.goal,
                        task.options,
                        {.vertices = skeleton.vertices, .triangles = skeleton.triangles}};
  Adjacency adjacency = adjacency_of(skeleton, subject, found);
  check_boundary_vertices(subject, adjacency, found);
  const InputVertices inputs = check_input_vertices(subject, domain, adjacency, found, settled);
  const Chains chains = check_segments(subject, domain, adjacency, inputs, Scan{}, found);

  Judgement judgement;
  judgement.suspects = check_coverage(subject, domain, adjacency, chains, found);
  if (!counter_clockwise) {  // then winding numbers exclude no hole
    judgement.suspects.resize(task.pslg.holes.size());
    std::iota(judgement.suspects.begin(), judgement.suspects.end(), Index{0});
  }
  if (labels) check_labels(subject, domain, adjacency, chains, inputs, found);
  for (const ChainEdge& edge : chains.edges)
    judgement.chains.push_back({skeleton.vertices[edge.from], skeleton.vertices[edge.to], edge.segment});
  for (Index i = 0; i < subject.pslg.points.size(); ++i) {
    const Index v = inputs.vertex(i);
    if (v != no_index) judgement.vertices_of_inputs.push_back({skeleton.vertices[v], i});
  }
  judgement.area = covered_area(skeleton.mesh.points.span(), adjacency).rounded() / 2;
  return judgement;
}

Ranks::Bytes Judgement::message() const {
  Writer message;
  message.list(chains);
  message.list(vertices_of_inputs);
  message.list(suspects);
  message.list(std::vector<double>{area});
  return message.take();
}

Judgement Judgement::read(const Ranks::Bytes& message) {
  Reader reader(message);
  Judgement judgement;
  judgement.chains = reader.list<NumberedChainEdge>();
  judgement.vertices_of_inputs = reader.list<VertexOfInput>();
  judgement.suspects = reader.list<Index>();
  judgement.area = reader.list<double>().at(0);
  return judgement;
}

}  // namespace pardel::checker
