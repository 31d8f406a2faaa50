#include "chains.hpp"

#include <algorithm>

#include "units.hpp"

namespace pardel::fuzz {

using ref::Edge;
using ref::ExactPoint;

bool Chain::passes(Index v) const { return std::ranges::find(path, v) != path.end(); }

namespace {

constexpr std::size_t most_chains = 40, most_choices = 200;

/// Lists the chains of one wall.
class Paths {
 public:
  Paths(const ExactMesh& mesh, const Pslg& pslg, const Wall& wall)
      : mesh_(mesh), wall_(wall), path_{wall.a}, along_(at(wall.b) - at(wall.a)) {
    for (Index v = 0; v < mesh.given.points.size(); ++v)
      is_allowed_.push_back(v == wall.b ||
                            (v >= pslg.points.size() && mesh.has_triangle[v] &&
                             is_within_two_units(mesh.given.points[v], pslg.points[wall.a], pslg.points[wall.b])));
    extend();
  }

  [[nodiscard]] Chains all() && { return std::move(found_); }

 private:
  [[nodiscard]] const ExactPoint& at(Index v) const { return mesh_.plain.points[v]; }

  void extend() {
    const Index from = path_.back();
    if (found_.size() > most_chains) return;
    if (from == wall_.b) return found_.push_back({&wall_, path_});
    for (Index to = 0; to < is_allowed_.size(); ++to) {
      if (!is_allowed_[to] || to == from || !mesh_.triangles_at.contains(ref::edge(from, to))) continue;
      if ((at(to) - at(from)) * along_ <= 0) continue;
      path_.push_back(to);
      extend();
      path_.pop_back();
    }
  }

  const ExactMesh& mesh_;
  const Wall& wall_;
  std::vector<char> is_allowed_;
  std::vector<Index> path_;
  ref::Kernel::Vector_2 along_;
  Chains found_;
};

/// True if the mesh lists all edges of the chain, and each has triangles on those sides on which the wall has the
/// domain.
bool is_as_listed(const Chain& chain, const ExactMesh& mesh) {
  for (std::size_t i = 1; i < chain.path.size(); ++i) {
    const Edge e = ref::edge(chain.path[i - 1], chain.path[i]);
    const auto sides = static_cast<std::size_t>(chain.wall->sides_inside());
    if (!mesh.plain.constraints.contains(e) || mesh.triangles_at.at(e).size() != sides) return false;
  }
  return true;
}

}  // namespace

bool PossibleChains::leave_a_choice() const {
  return std::ranges::any_of(of_walls, [](const Chains& chains) { return chains.size() > 1; });
}

PossibleChains possible_chains(const ExactMesh& mesh, const Pslg& pslg, const InputFaces& faces) {
  PossibleChains possible;
  for (const Wall& wall : faces.walls()) {
    if (wall.sides_inside() == 0) continue;
    Chains chains = Paths(mesh, pslg, wall).all();
    if (chains.size() > most_chains) possible.are_listed = false;
    if (chains.empty()) {
      possible.are_whole = false;
      if (wall.segment != no_index) possible.broken.insert(wall.segment);
    }
    possible.of_walls.push_back(std::move(chains));
  }
  return possible;
}

std::optional<Chains> meant_chains(const ExactMesh& mesh, const PossibleChains& possible) {
  if (!possible.are_listed) return std::nullopt;
  Chains meant;
  for (const Chains& chains : possible.of_walls) {
    Chains listed;
    for (const Chain& chain : chains)
      if (chains.size() == 1 || is_as_listed(chain, mesh)) listed.push_back(chain);
    if (listed.size() != 1) return std::nullopt;
    meant.push_back(listed.front());
  }
  return meant;
}

std::optional<bool> some_choice_fits(const PossibleChains& possible, const std::function<bool(const Chains&)>& fits) {
  std::size_t choices = possible.are_listed ? 1 : most_choices + 1;
  for (const Chains& chains : possible.of_walls) choices = std::min(choices * chains.size(), most_choices + 1);
  if (choices > most_choices) return std::nullopt;
  for (std::size_t choice = 0; choice < choices; ++choice) {
    Chains chosen;
    std::size_t rest = choice;
    for (const Chains& chains : possible.of_walls) {
      chosen.push_back(chains[rest % chains.size()]);
      rest /= chains.size();
    }
    if (fits(chosen)) return true;
  }
  return false;
}

WallsOfMesh::WallsOfMesh(const ExactMesh& mesh, const Chains& chains) : of_vertex(mesh.given.points.size(), nullptr) {
  for (const Chain& chain : chains) {
    for (std::size_t i = 1; i < chain.path.size(); ++i) {
      of_edge.emplace(ref::edge(chain.path[i - 1], chain.path[i]), chain.wall);
      if (i + 1 < chain.path.size()) of_vertex[chain.path[i]] = chain.wall;
    }
  }
}

}  // namespace pardel::fuzz
