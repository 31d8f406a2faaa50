#include "sweeps.hpp"

#include <algorithm>
#include <utility>

#include "../workers/random.hpp"
#include "circumradius.hpp"

namespace pardel::schemes::cells {
namespace {

using Lists = std::vector<std::vector<Waiting>>;

/// Gives each entry to the cell of its point.
Lists given_to_cells(Refinement& r, const Division& division) {
  Lists lists(division.colour.size());
  for (const Waiting& w : r.waiting)
    if (is_current(r.start.mesh, w))
      if (const auto p = first_point(r.start.mesh, w, r.start.bounds)) lists[division.cell_of(*p)].push_back(w);
  r.waiting.clear();
  return lists;
}

/// The cells of the colour that have entries, in an order that depends on the seed.
std::vector<Index> cells_at_work(const Refinement& r, const Division& division, const Lists& lists, int colour) {
  std::vector<Index> cells;
  for (Index cell = 0; cell < lists.size(); ++cell)
    if (division.colour[cell] == colour && !lists[cell].empty()) cells.push_back(cell);
  std::ranges::sort(cells, {}, [&](Index cell) { return random_number(r.problem.seed ^ random_number(cell)); });
  return cells;
}

void run(const Refinement& r, std::vector<Task>& tasks) {
  const auto is_full = [&] { return r.start.mesh.points.size() > r.problem.most_points; };
  if (r.turns == Turns::one_after_the_other) {
    for (Task& task : tasks)
      while (!is_full() && task.step()) continue;
    return;
  }
  std::vector<Task*> unfinished;
  for (Task& task : tasks) unfinished.push_back(&task);
  while (!unfinished.empty() && !is_full()) std::erase_if(unfinished, [](Task* task) { return !task->step(); });
}

/// Sends a new triangle to the workers that hold it.
void send(const Refinement& r, const Division& division, Index cell, const std::vector<Index>& touching, Index t,
          Phase& phase) {
  std::vector<int> sent = {division.worker[cell]};
  for (const Index other : touching) {
    const int worker = division.worker[other];
    if (std::ranges::find(sent, worker) != sent.end()) continue;
    const auto is_in_box = [&](Index v) { return division.in_box(other, r.start.mesh.points[v]); };
    if (!std::ranges::any_of(r.start.mesh.faces[t].v, is_in_box)) continue;
    phase.send(division.worker[cell], worker, bytes_of_triangle);
    sent.push_back(worker);
  }
}

/// Sends the new triangles of a task. Returns whether the division allows their circumdisks.
bool send_made(Refinement& r, const Division& division, const Task& task, Phase& phase) {
  const LinkedMesh& mesh = r.start.mesh;
  const std::vector<Index> touching = division.touching(task.cell());
  r.seen.resize(mesh.faces.size(), 0);
  bool allowed = true;
  for (const Index t : task.made()) {
    if (!mesh.in_use(t) || r.seen[t] == r.start.account.rounds) continue;
    r.seen[t] = r.start.account.rounds;
    allowed = division.allows(circumcentre(mesh, t), circumradius(mesh, t)) && allowed;
    send(r, division, task.cell(), touching, t, phase);
  }
  return allowed;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Returns whether the next phase may begin in the same division. `insertions` grows.
bool run_phase(Refinement& r, const Division& division, Lists& lists, int colour, std::uint64_t& insertions) {
  const std::size_t points = r.start.mesh.points.size();
  ++r.start.account.rounds;
  std::vector<Task> tasks;
  for (const Index cell : cells_at_work(r, division, lists, colour))
    tasks.emplace_back(r.start.mesh, r.start.bounds, division, cell, std::exchange(lists[cell], {}),
                       static_cast<bool>(r.watch));
  run(r, tasks);

  PhaseRecord record{division, r.start.mesh, r.sweeps, colour, false, r.start.mesh.points.size() - points, {}, {}};
  Phase phase(r.problem.workers);
  for (const Task& task : tasks) {
    const int worker = division.worker[task.cell()];
    phase.work(worker, task.work());
    record.ends_sweep = !send_made(r, division, task, phase) || record.ends_sweep;
    append(lists[task.cell()], task.again());
    for (const auto& [what, to] : task.handed_on()) {
      phase.send(worker, division.worker[to], bytes_of_triangle);
      lists[to].push_back(what);
      if (r.watch) record.handed_on.push_back({task.cell(), to});
    }
    append(r.later, task.later());
    append(r.left_box, task.left_box());
    if (r.watch) record.touched.emplace_back(task.cell(), task.touched());
  }
  phase.end(r.start.account);
  insertions += record.insertions;
  if (r.watch) r.watch(record);
  return !record.ends_sweep;
}

}  // namespace

void assess_all(Refinement& r) {
  const LinkedMesh& mesh = r.start.mesh;
  for (Index t = 0; t < mesh.faces.size(); ++t)
    if (mesh.in_use(t) && needs_work(mesh, t, r.start.bounds)) r.waiting.push_back({known(mesh, t)});
}

std::uint64_t sweep(Refinement& r, const Division& division) {
  Lists lists = given_to_cells(r, division);
  std::uint64_t insertions = 0;
  r.is_outgrown = false;
  for (int colour = 0; colour < division.colours && !r.is_outgrown; ++colour)
    r.is_outgrown = !run_phase(r, division, lists, colour, insertions);
  ++r.sweeps;
  for (const std::vector<Waiting>& list : lists) append(r.waiting, list);
  return insertions;
}

Division sweep_to_fixpoint(Refinement& r, const std::function<Division()>& divide, double growth) {
  Division division = divide();
  for (int idle = 0; idle < 2;) {
    const auto points = static_cast<double>(r.start.mesh.points.size());
    const std::uint64_t insertions = sweep(r, division);
    idle = insertions == 0 ? idle + 1 : 0;
    if (r.waiting.empty() || r.start.mesh.points.size() > r.problem.most_points) break;

    if (r.is_outgrown || static_cast<double>(insertions) > growth * points) division = divide();
  }
  return division;
}

std::uint64_t most_held(const LinkedMesh& mesh, const Division& division, int workers) {
  std::vector<std::uint64_t> held(static_cast<std::size_t>(workers), 0);
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    if (!mesh.in_use(t)) continue;
    std::vector<int> holders;
    for (const Index v : mesh.faces[t].v) {
      const Index home = division.cell_of(mesh.points[v]);
      std::vector<Index> cells = division.touching(home);
      std::erase_if(cells, [&](Index cell) { return !division.in_box(cell, mesh.points[v]); });
      cells.push_back(home);
      for (const Index cell : cells)
        if (std::ranges::find(holders, division.worker[cell]) == holders.end())
          holders.push_back(division.worker[cell]);
    }
    for (const int worker : holders) ++held[static_cast<std::size_t>(worker)];
  }
  return *std::ranges::max_element(held);
}

Result<Outcome> outcome_of(Refinement&& r) {
  if (r.start.mesh.points.size() > r.problem.most_points) return too_many_points(r.problem);
  r.start.account.insertions = r.start.mesh.points.size() - r.problem.pslg.points.size();
  compact(r.start.mesh);
  return Outcome{std::move(r.start.mesh), r.start.account};
}

}  // namespace pardel::schemes::cells
