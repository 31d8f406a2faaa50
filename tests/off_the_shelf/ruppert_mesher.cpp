#include "ruppert_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "../../core/mesh.hpp"
#include "../../core/support/stopwatch.hpp"
#include "../../ref/insertion.hpp"
#include "../../ref/refinement.hpp"

namespace pardel {
namespace {

using ref::Edge;

/// The subdomain as a mesh of the reference. The segment of an edge is its number in the subdomain.
ref::Refinement start_of(const Subdomain& subdomain) {
  ref::Refinement state;
  for (const Point p : subdomain.points) state.mesh.points.push_back(ref::exact(p));
  state.mesh.triangles = subdomain.triangles;
  for (Index i = 0; i < subdomain.edges.size(); ++i) {
    const Edge e = ref::edge(subdomain.edges[i].a, subdomain.edges[i].b);
    state.mesh.constraints.insert(e);
    state.provenance.segment_of_edge[e] = i;
  }
  state.provenance.origin.assign(subdomain.points.size(), input_vertex);
  return state;
}

/// The reference's criteria for the bounds of the subdomain. Areas per triangle become regions.
ref::Criteria criteria_of(const Subdomain& subdomain, const ref::PlainMesh& mesh) {
  Goal goal = subdomain.goal;
  goal.region_caps = !subdomain.max_areas.empty();
  Pslg regions;
  std::vector<char> has_region(subdomain.triangles.size(), 0);
  for (Index t = 0; t < subdomain.max_areas.size(); ++t) {
    if (has_region[t] != 0) continue;
    const ref::ExactPoint inside = CGAL::centroid(mesh.points[mesh.triangles[t][0]], mesh.points[mesh.triangles[t][1]],
                                                  mesh.points[mesh.triangles[t][2]]);
    regions.regions.push_back({ref::rounded(inside), 0, subdomain.max_areas[t]});
    for (const Index other : ref::face_of(mesh, inside)) has_region[other] = 1;
  }
  return {regions, goal, mesh};
}

class Run {
 public:
  explicit Run(const Subdomain& subdomain)
      : in_(subdomain), state_(start_of(subdomain)), criteria_(criteria_of(subdomain, state_.mesh)) {}

  RefinedSubdomain result() {
    split_with_followers(encroached_edges());
    while (!is_at_limit()) {
      const auto bad = std::ranges::find_if(state_.mesh.triangles, [&](const ref::Corners& t) {
        return !refused_.contains(t) && criteria_.split_point(state_.mesh, t).has_value();
      });
      if (bad == state_.mesh.triangles.end()) break;
      const ref::Corners triangle = *bad;
      if (!remove(triangle)) refused_.insert(triangle);
    }
    return answer();
  }

 private:
  [[nodiscard]] const ref::PlainMesh& mesh() const { return state_.mesh; }
  [[nodiscard]] bool is_at_limit() const {
    return mesh().points.size() - in_.points.size() >= in_.most_new_points || watch_.seconds() > in_.seconds;
  }
  [[nodiscard]] bool is_in_cell(const ref::ExactPoint& p) const {
    return !in_.cell || in_.cell->contains(ref::rounded(p));
  }
  /// True if a new point so far from the next one makes edges that are too short.
  [[nodiscard]] bool is_too_close(const ref::Number& squared_distance) const {
    return CGAL::to_double(squared_distance) <= 4 * in_.min_edge * in_.min_edge;
  }

  /// Inserts the circumcentre of a bad triangle, or splits what it encroaches upon. False if nothing has changed.
  bool remove(const ref::Corners& triangle) {
    const ref::ExactPoint centre = *criteria_.split_point(mesh(), triangle);
    std::vector<Edge> upon = ref::encroached_by(mesh(), centre);
    if (!upon.empty()) {
      std::erase_if(upon, [&](const Edge& e) { return !may_split(e); });
      split_with_followers(upon);
      return !upon.empty();
    }
    if (!is_in_cell(centre) || is_too_close(ref::squared_circumradius(mesh(), triangle))) return false;
    if (ref::cavity(mesh(), centre).empty()) return false;
    ref::record_origin(state_, ref::insert(state_.mesh, centre), std::nullopt);
    return true;
  }

  [[nodiscard]] bool is_frozen(const Edge& e) const {
    return !in_.edges[state_.provenance.segment_of_edge.at(e)].may_be_split;
  }
  [[nodiscard]] ref::ExactPoint middle_of(const Edge& e) const {
    return CGAL::midpoint(mesh().points[e[0]], mesh().points[e[1]]);
  }
  [[nodiscard]] bool may_split(const Edge& e) const {
    const ref::ExactPoint middle = middle_of(e);
    if (is_frozen(e) || !is_in_cell(middle) || ref::exact(ref::rounded(middle)) != middle) return false;
    if (is_too_close(CGAL::squared_distance(middle, mesh().points[e[0]]))) return false;
    return std::ranges::none_of(ref::encroached_by(mesh(), middle),
                                [&](const Edge& other) { return is_frozen(other); });
  }

  [[nodiscard]] std::vector<Edge> encroached_edges() const {
    std::vector<Edge> found;
    for (const Edge& e : mesh().constraints)
      if (ref::is_encroached(mesh(), e)) found.push_back(e);
    return found;
  }

  /// Splits those of the edges that may be split, and all that become encroached by it.
  void split_with_followers(std::vector<Edge> waiting) {
    while (!waiting.empty() && !is_at_limit()) {
      const Edge e = waiting.back();
      waiting.pop_back();
      if (!mesh().constraints.contains(e) || !may_split(e)) continue;
      const Index vertex = ref::insert(state_.mesh, middle_of(e));
      ref::record_origin(state_, vertex, e);
      const std::vector<Edge> followers = ref::newly_encroached(state_, vertex);
      waiting.insert(waiting.end(), followers.begin(), followers.end());
    }
  }

  [[nodiscard]] RefinedSubdomain answer() const {
    RefinedSubdomain answer;
    if (is_at_limit()) answer.ending = RefinedSubdomain::Ending::limit;
    answer.points = in_.points;
    for (std::size_t v = in_.points.size(); v < mesh().points.size(); ++v) {
      const Index origin = state_.provenance.origin[v];
      answer.points.push_back(ref::rounded(mesh().points[v]));
      answer.edge_of_new_point.push_back(origin == interior_vertex ? no_index : segment_of_origin(origin));
    }
    answer.triangles = mesh().triangles;
    return answer;
  }

  const Subdomain& in_;
  Stopwatch watch_;
  ref::Refinement state_;
  ref::Criteria criteria_;
  std::set<ref::Corners> refused_;  ///< triangles that cannot be removed
};

class RuppertMesher final : public SubdomainMesher {
 public:
  [[nodiscard]] MesherAbilities abilities() const override {
    return {.obeys_cell = true,
            .keeps_frozen_edges = true,
            .splits_segments = true,
            .exempts_small_angles = false,
            .is_thread_safe = false};
  }
  [[nodiscard]] RefinedSubdomain refine(const Subdomain& subdomain) override { return Run(subdomain).result(); }
};

}  // namespace

std::unique_ptr<SubdomainMesher> ruppert_mesher() { return std::make_unique<RuppertMesher>(); }

}  // namespace pardel
