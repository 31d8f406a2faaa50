#include "problems_of_points.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "../../core/support/exchange_lists.hpp"
#include "../../parallel/arithmetic/predicates.hpp"
#include "../../parallel/domain/check_values.hpp"
#include "../../parallel/domain/convex_hull.hpp"
#include "../../parallel/domain/duplicates.hpp"
#include "../../parallel/domain/findings.hpp"
#include "../../parallel/threads/parallel_arrays.hpp"
#include "resolve_halo.hpp"

namespace pardel::engine {
namespace {

/// The largest number of problems of each kind that is listed.
constexpr std::size_t most = 10'000;

struct TravellingProblem {
  std::array<std::uint64_t, 2> ids{};
  std::uint64_t id_count = 0;
  Point where;
  ProblemKind kind;
  std::array<char, 7> unused{};
};

/// The problems of all ranks, in the order of find_problems().
std::vector<Problem> of_all(const std::vector<TravellingProblem>& here, Ranks& ranks) {
  std::vector<Problem> problems;
  for (const TravellingProblem& each : concatenated(lists_of_all(here, ranks))) {
    Problem& problem = problems.emplace_back(Problem{each.kind, {}, each.where});
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(each.id_count, 2); ++i)
      problem.ids.push_back(id_of_problem(each.ids[i]));
  }
  std::ranges::sort(
      problems, [](const Problem& a, const Problem& b) { return std::pair(a.kind, a.ids) < std::pair(b.kind, b.ids); });
  Findings found(most);
  for (Problem& each : problems) found.add(each.kind, std::move(each.ids), each.where);
  return std::move(found).sorted();
}

/// Whether attributes or markers do not fit the number of points on a rank, or ranks differ about what a point has.
bool have_wrong_counts(const PartOfPoints& read, Ranks& ranks) {
  struct Counts {
    std::uint64_t points, per_point, attributes, markers;
  };
  const Counts here{read.points.size(), read.attributes_per_point, read.point_attributes.size(),
                    read.point_markers.size()};
  const std::vector<Counts> counts = concatenated(lists_of_all(std::vector{here}, ranks));
  const bool are_marked = std::ranges::any_of(counts, [](const Counts& each) { return each.markers != 0; });
  return std::ranges::any_of(counts, [&](const Counts& each) {
    return each.per_point != counts[0].per_point || each.attributes != each.points * each.per_point ||
           each.markers != (are_marked ? each.points : 0);
  });
}

}  // namespace

std::vector<Problem> unusable_values(const PartOfPoints& read, Ranks& ranks, const Threads& threads) {
  std::vector<TravellingProblem> here;
  std::map<ProblemKind, std::size_t> count;
  if (have_wrong_counts(read, ranks) && ranks.rank() == 0) here.push_back({{}, 0, {}, ProblemKind::wrong_count});
  for (const Index i :
       indices_where(threads, read.points.size(), [&](std::size_t i) { return !is_usable(read.points[i]); })) {
    const Point p = read.points[i];
    const ProblemKind kind = problem_of_coordinates(p);
    if (++count[kind] <= most) here.push_back({{read.first + i, 0}, 1, p, kind});
  }
  return of_all(here, ranks);
}

/// Equal points have the same owner.
std::vector<Problem> unusable_positions(const OwnPoints& own, Ranks& ranks, const Threads& threads) {
  const std::vector<Duplicate> duplicates = find_duplicates(own.at.span(), threads);
  std::map<Index, std::uint64_t> least;  // of the numbers of equal points, by the first of them on this rank
  for (const Duplicate& each : duplicates) {
    std::uint64_t& number = least.try_emplace(each.first, own.number[each.first]).first->second;
    number = std::min(number, own.number[each.again]);
  }
  std::vector<TravellingProblem> here;
  const auto add = [&](Index first, Index v) {
    if (own.number[v] != least[first] && here.size() < most)
      here.push_back({{least[first], own.number[v]}, 2, own.at[v], ProblemKind::duplicate_points});
  };
  for (const auto& [first, number] : least) add(first, first);
  for (const Duplicate& each : duplicates) add(each.first, each.again);
  // The sites that all ranks know are collinear only if all points are.
  std::vector<Point> known;
  for (const Site& site : common_sites(own.at.span(), own.first[ranks.rank()], own.first.back(), ranks))
    known.push_back(site.at);
  if (ranks.rank() == 0 && all_collinear(known, threads))
    here.push_back({{}, 0, known.empty() ? Point{} : known[0], ProblemKind::all_points_collinear});
  return of_all(here, ranks);
}

Status status_of(const std::vector<Problem>& problems, FirstId first_id) {
  if (problems.empty()) return Done{};
  return Error{ErrorKind::invalid_input, messages(problems, first_id.value)};
}

std::vector<Problem> problems_of_points(PartOfPoints&& points, Ranks& ranks, const Threads& threads) {
  std::vector<Problem> problems = unusable_values(points, ranks, threads);
  if (!problems.empty()) return problems;
  const CurveDivision division = divide_along_curve(points.points, ranks);
  return unusable_positions(send_to_owners(std::move(points), division, ranks, threads), ranks, threads);
}

}  // namespace pardel::engine
