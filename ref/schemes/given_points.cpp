#include "given_points.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/triangulation.hpp"
#include "workers/phase.hpp"

namespace pardel::schemes {
namespace {

constexpr std::uint64_t bytes_of_point = 24;  // a number and two coordinates

/// Workers `first` to `first` + `count` - 1, each with an equal share of the points of a part.
struct Team {
  Part part;
  int first = 0, count = 1, level = 0;
};

/// The worker of the team that holds point k of n.
int holder(const Team& team, std::size_t k, std::size_t n) {
  return team.first + static_cast<int>(k * static_cast<std::size_t>(team.count) / n);
}

/// Each worker finds the hull of its share; the first one finds the hull of these hulls, and tells it to all.
std::vector<Index> path_of(const std::vector<Point>& points, const Team& team, Point m, Cut cut, Phase& shares,
                           Phase& joins) {
  const std::vector<Index>& of = team.part.points;
  std::vector<Index> candidates;
  for (std::size_t from = 0, to = 0; from < of.size(); from = to) {
    const int worker = holder(team, from, of.size());
    while (to < of.size() && holder(team, to, of.size()) == worker) ++to;
    const std::vector<Index> share(of.begin() + static_cast<std::ptrdiff_t>(from),
                                   of.begin() + static_cast<std::ptrdiff_t>(to));
    const std::vector<Index> hull = dividing_path(points, share, m, cut);
    shares.work(worker, share.size());
    shares.send(worker, team.first, hull.size() * bytes_of_point);
    candidates.insert(candidates.end(), hull.begin(), hull.end());
  }
  std::vector<Index> path = dividing_path(points, candidates, m, cut);
  joins.work(team.first, candidates.size());
  for (int k = 1; k < team.count; ++k) joins.send(team.first, team.first + k, path.size() * bytes_of_point);
  return path;
}

/// The points of the half travel to its team.
void travel(const Team& from, const Team& to, Phase& moves) {
  const std::vector<Index>& all = from.part.points;
  std::size_t place = 0;
  for (std::size_t k = 0; k < to.part.points.size(); ++k) {
    while (all[place] != to.part.points[k]) ++place;
    moves.send(holder(from, place, all.size()), holder(to, k, to.part.points.size()), bytes_of_point);
  }
}

/// The hull is the first border. It is found like a path: first the hulls of the workers' shares, then their hull.
std::vector<std::array<Index, 2>> first_border(const std::vector<Point>& points, int workers, Account& account) {
  Phase shares(workers), joins(workers);
  const auto count = static_cast<std::size_t>(workers);
  std::uint64_t candidates = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = [&](std::size_t share) {
      return points.begin() + static_cast<std::ptrdiff_t>(share * points.size() / count);
    };
    const std::vector<Point> share(at(k), at(k + 1));
    const std::size_t on_hull = share.size() < 3 ? share.size() : hull_of(share).size();
    if (share.empty()) continue;
    shares.work(static_cast<int>(k), share.size());
    shares.send(static_cast<int>(k), 0, on_hull * bytes_of_point);
    candidates += on_hull;
  }
  joins.work(0, candidates);
  shares.end(account);
  joins.end(account);
  return hull_of(points);
}

bool has_bounds(const Goal& goal) {
  return goal.min_angle_deg > 0 || std::isfinite(goal.max_area) || std::isfinite(goal.max_edge) || goal.size;
}

}  // namespace

Cut cut_of(const std::vector<Point>& points, const std::vector<Index>& of, int level, CutOrder order) {
  if (order == CutOrder::alternating) return level % 2 == 0 ? Cut::x : Cut::y;
  const auto [left, right] = std::ranges::minmax(of, {}, [&](Index v) { return points[v].x; });
  const auto [low, high] = std::ranges::minmax(of, {}, [&](Index v) { return points[v].y; });
  return points[right].x - points[left].x >= points[high].y - points[low].y ? Cut::x : Cut::y;
}

Division division_of(const std::vector<Point>& points, int workers, const GivenPointsOptions& options,
                     Account& account) {
  Division division{
      std::vector<Part>(static_cast<std::size_t>(workers)), {}, std::vector<int>(static_cast<std::size_t>(workers), 0)};
  Team all{{{}, first_border(points, workers, account)}, 0, workers, 0};
  for (Index v = 0; v < points.size(); ++v) all.part.points.push_back(v);
  std::vector<Team> teams = {std::move(all)};
  while (!teams.empty()) {
    Phase shares(workers), joins(workers), moves(workers);
    std::vector<Team> next;
    for (Team& team : teams) {
      const std::vector<Index> inner = team.count > 1 ? inner_points(team.part) : std::vector<Index>();
      if (inner.empty()) {
        division.levels[static_cast<std::size_t>(team.first)] = team.level;
        division.parts[static_cast<std::size_t>(team.first)] = std::move(team.part);
        continue;
      }
      const int lower = team.count / 2;
      const Cut cut = cut_of(points, team.part.points, team.level, options.cuts);
      const Point m = points[median(points, inner, cut, lower, team.count)];         // step 2
      const std::vector<Index> path = path_of(points, team, m, cut, shares, joins);  // steps 3 and 4
      auto [low, high] = halves_of(points, team.part, path, m, cut);                 // step 5
      division.paths.push_back(path);
      next.push_back({std::move(low), team.first, lower, team.level + 1});
      travel(team, next.back(), moves);
      next.push_back({std::move(high), team.first + lower, team.count - lower, team.level + 1});
      travel(team, next.back(), moves);
    }
    teams = std::move(next);
    if (teams.empty()) break;
    for (const Phase* phase : {&shares, &joins, &moves}) phase->end(account);
    ++account.rounds;
  }
  return division;
}

Triangles triangles_of(const std::vector<Point>& points, const Division& division, Account& account) {
  Triangles all;
  Phase phase(static_cast<int>(division.parts.size()));
  for (std::size_t worker = 0; worker < division.parts.size(); ++worker) {
    if (division.parts[worker].points.empty()) continue;
    const PartTriangles of_part = triangles_of(points, division.parts[worker]);
    phase.work(static_cast<int>(worker), of_part.work);
    account.most_held = std::max(account.most_held, of_part.held);
    all.corners.insert(all.corners.end(), of_part.triangles.begin(), of_part.triangles.end());
    all.owner.resize(all.corners.size(), static_cast<int>(worker));
  }
  phase.end(account);
  return all;
}

Result<Outcome> triangulate_given_points(const Problem& problem, const GivenPointsOptions& options) {
  if (auto error = unsupported(problem.pslg, problem.goal)) return *error;
  if (!is_point_set(problem.pslg) || has_bounds(problem.goal))
    return Error{ErrorKind::usage, "Given points are triangulated without segments and without bounds."};
  const std::vector<Point>& points = problem.pslg.points;
  const Error empty{ErrorKind::invalid_input, "The domain has no triangle."};
  if (points.size() < 3) return empty;
  Account account;
  const Division division = division_of(points, problem.workers, options, account);
  const Triangles triangles = triangles_of(points, division, account);
  if (triangles.corners.empty()) return empty;
  const std::vector<std::array<Index, 2>> hull = hull_of(points);
  std::vector<Piece> pieces;
  for (const auto& [a, b] : hull) pieces.push_back({a, b, static_cast<Index>(pieces.size())});
  std::vector<std::size_t> missing;
  LinkedMesh mesh = linked(points, triangles.corners, pieces, missing);
  mesh.segments = hull;
  return Outcome{std::move(mesh), account};
}

}  // namespace pardel::schemes
