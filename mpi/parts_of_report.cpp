#include "parts_of_report.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "../cli/memory.hpp"
#include "../core/support/collective.hpp"
#include "../core/support/exchange_lists.hpp"

namespace pardel::mpi {
namespace {

/// Of two sets of triangles together. The number of vertices is left out.
MeshStatistics together(const MeshStatistics& a, const MeshStatistics& b) {
  if (a.triangles == 0) return b;
  if (b.triangles == 0) return a;
  return {.vertices = 0,
          .triangles = a.triangles + b.triangles,
          .min_angle_deg = std::min(a.min_angle_deg, b.min_angle_deg),
          .max_angle_deg = std::max(a.max_angle_deg, b.max_angle_deg),
          .max_circumradius = std::max(a.max_circumradius, b.max_circumradius),
          .area = a.area + b.area};
}

/// Collective. The lists of all ranks one after the other, on the first rank.
template <class T>
std::vector<T> all_on_first(std::vector<T> list, Ranks& ranks) {
  std::vector<std::vector<T>> lists(static_cast<std::size_t>(ranks.count()));
  lists.front() = std::move(list);
  return concatenated(exchange_lists(std::move(lists), ranks));
}

/// Collective. Of the lists of all ranks, which have the same length, the largest value at each place.
template <class T>
std::vector<T> largest_of_all(const std::vector<T>& list, Ranks& ranks) {
  std::vector<T> largest = list;
  for (const std::vector<T>& of_rank : lists_of_all(list, ranks))
    for (std::size_t i = 0; i < std::min(largest.size(), of_rank.size()); ++i)
      largest[i] = std::max(largest[i], of_rank[i]);
  return largest;
}

}  // namespace

void PartsOfReport::add(const MeshPiece& piece) {
  ++pieces_;
  statistics_ = together(statistics_, statistics(piece.mesh));
  exempt_.add(exempt_triangles(piece.report, piece.mesh, piece.first_triangle));
  if (has_lists_) keep_list(piece);
  report_ = piece.report;
  report_.exempt = {};
}

void PartsOfReport::keep_list(const MeshPiece& piece) {
  for (Exemption exemption : piece.report.exempt) {
    const std::uint64_t number = piece.first_triangle + exemption.triangle;
    exemption.triangle = number < no_index ? static_cast<Index>(number) : no_index;
    list_.push_back(exemption);
  }
}

/// The longest task of a sweep, and the threads of cells, are known to the ranks that did them.
void PartsOfReport::join_tiling(Ranks& ranks) {
  Tiling& tiling = report_.tiling;
  tiling.thread_of_cell = largest_of_all(tiling.thread_of_cell, ranks);
  std::vector<std::uint64_t> tasks;
  for (const Sweep& sweep : tiling.sweeps) tasks.push_back(sweep.largest_task);
  tasks = largest_of_all(tasks, ranks);
  for (std::size_t i = 0; i < tasks.size(); ++i)
    tiling.sweeps[i].largest_task = static_cast<decltype(Sweep::largest_task)>(tasks[i]);
}

void PartsOfReport::join_lists(Ranks& ranks) {
  join_tiling(ranks);
  report_.exempt = all_on_first(std::move(list_), ranks);
  std::ranges::sort(report_.exempt, {}, &Exemption::triangle);
}

/// The numbers are known to all ranks, because the exit status depends on them; the first rank lists triangles.
cli::ExemptTriangles PartsOfReport::join_exempt(Ranks& ranks) {
  cli::ExemptTriangles all;
  for (const auto& counts : concatenated(lists_of_all(std::vector{exempt_.counts}, ranks))) all.add({counts, {}});
  all.add({{}, all_on_first(std::move(exempt_.first), ranks)});
  return all;
}

void PartsOfReport::join(const Made& made, cli::MeshRun& run, Ranks& ranks) {
  if (has_lists_) join_lists(ranks);
  run.exempt = join_exempt(ranks);
  run.report = std::move(report_);
  run.ranks = cli::RanksOfRun{.triangles = all_on_first(std::vector{statistics_.triangles}, ranks),
                              .peak_memory = all_on_first(std::vector{cli::peak_memory()}, ranks),
                              .pieces = sum_of(pieces_, ranks),
                              .divided = made.divided};
  for (const MeshStatistics& of_rank : concatenated(lists_of_all(std::vector{std::exchange(statistics_, {})}, ranks)))
    statistics_ = together(statistics_, of_rank);
  run.statistics = statistics_;
  run.statistics.vertices = made.points;
  run.digest = sum_of(made.digest, ranks);
}

}  // namespace pardel::mpi
