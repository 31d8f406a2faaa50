#include "speculation.hpp"

#include <algorithm>
#include <utility>

namespace pardel::schemes {
namespace {

/// Of a message that asks for a lock, refuses or releases one, or takes one away.
constexpr std::uint64_t bytes_of_request = 8;

}  // namespace

Speculation::Speculation(Start start, const Problem& problem, Precedence precedence, Locked locked)
    : mesh_(std::move(start.mesh)),
      bounds_(std::move(start.bounds)),
      account_(start.account),
      territory_(mesh_, bounds_, problem.workers),
      precedence_(precedence),
      locked_(locked),
      workers_(place(problem.workers)),
      inputs_(mesh_.points.size()) {
  account_.before = account_.critical;
  for (SpeculativeWorker& worker : workers_) worker.clock = account_.before;
  marks_.resize(mesh_.faces.size());
  for (Index t = 0; t < mesh_.faces.size(); ++t) {
    marks_[t].owner = territory_.owner(mesh_, t);
    add_if_bad(marks_[t].owner, t, account_.before);
  }
}

/// A bad triangle goes to the queue of its owner, with a message if `from` is another worker.
void Speculation::add_if_bad(int from, Index t, std::uint64_t ready) {
  if (!needs_work(mesh_, t, bounds_)) return;
  const int owner = marks_[t].owner;
  workers_[place(owner)].queue.push_back({t, ready});
  ++pending_;
  if (owner == from) return;
  ++counts_.handed_on;
  ++account_.messages;
  account_.bytes += bytes_of_triangle;
}

/// Worker w, with an insertion of this age, meets a triangle that another worker holds. Does it take the lock away?
bool Speculation::wins(std::uint64_t age, int w, int holder) const {
  const SpeculativeAttempt& other = *workers_[place(holder)].attempt;
  if (other.writes > 0) return false;
  switch (precedence_) {
    case Precedence::lower_worker:
      return w < holder;
    case Precedence::older_insertion:
      return age < other.task.age;
    case Precedence::nobody:
      break;
  }
  return false;
}

int Speculation::would_set_back(int w) const {
  const SpeculativeWorker& me = workers_[place(w)];
  const SpeculativeTask& task = me.attempt ? me.attempt->task : me.queue.front();
  const Index next = me.attempt ? me.attempt->next : task.triangle;
  const int other = next == no_index ? no_worker : holder(next);
  if (other == no_worker || other == w) return no_worker;
  const std::uint64_t age = task.age == 0 ? begun_ + 1 : task.age;  // an insertion gets its age when it begins
  return wins(age, w, other) ? other : w;
}

/// Nave, Chrisochoides and Chew: a lock on a triangle of another worker's part is a request and an answer.
bool Speculation::take_lock(int w, Index t) {
  SpeculativeWorker& me = workers_[place(w)];
  LockMark& mark = marks_[t];
  if (mark.holder == w) return true;
  if (mark.owner != w) {
    ++counts_.remote_asks;
    account_.messages += 2;
    account_.bytes += bytes_of_request + bytes_of_triangle;
  }
  if (mark.holder != no_worker) {
    const int other = mark.holder;
    if (!wins(me.attempt->task.age, w, other)) return false;
    workers_[place(other)].clock = std::max(workers_[place(other)].clock, me.clock);
    ++counts_.taken_away;
    ++account_.messages;
    account_.bytes += bytes_of_request;
    set_back(other);
  }
  mark.holder = w;
  me.clock = std::max(me.clock, mark.freed + 1);
  me.held.push_back(t);
  return true;
}

/// Releases the locks on all triangles but those.
void Speculation::release(int w, const std::vector<Index>& except, bool changed) {
  SpeculativeWorker& me = workers_[place(w)];
  std::erase_if(me.held, [&](Index t) {
    if (std::ranges::find(except, t) != except.end()) return false;
    LockMark& mark = marks_[t];
    mark.holder = no_worker;
    mark.freed = me.clock;
    if (mark.owner != w) {
      ++counts_.remote_ends;
      ++account_.messages;
      account_.bytes += changed ? bytes_of_triangle : bytes_of_request;
    }
    return true;
  });
}

/// Another worker is in the way. Nothing was written, so without its locks the insertion leaves no trace.
void Speculation::set_back(int w) {
  SpeculativeWorker& me = workers_[place(w)];
  ++account_.set_backs;
  account_.wasted += me.attempt->steps;
  release(w, {}, false);
  me.queue.push_back(me.attempt->task);
  me.attempt.reset();
}

/// The triangle needs no work, or its point cannot be inserted because of rounding.
void Speculation::give_up(int w) {
  release(w, {}, false);
  workers_[place(w)].attempt.reset();
  --pending_;
}

/// The search for a cavity begins: that of p, or of the point p that splits a side.
void Speculation::aim(int w, Point p, std::vector<Index> starts, Side split) {
  SpeculativeAttempt& attempt = *workers_[place(w)].attempt;
  attempt.expansion = Expansion(p, std::move(starts));
  attempt.split = split;
}

void Speculation::step(int w) {
  SpeculativeWorker& me = workers_[place(w)];
  if (!me.attempt) {
    me.attempt.emplace();
    me.attempt->task = me.queue.front();
    me.queue.pop_front();
    me.attempt->next = me.attempt->task.triangle;
    me.clock = std::max(me.clock, me.attempt->task.ready);
    if (me.attempt->task.age == 0) me.attempt->task.age = ++begun_;
  }
  ++counts_.steps;
  ++account_.work;
  ++me.clock;
  ++me.attempt->steps;
  if (me.attempt->writes > 0) return write(w);
  const Index next = me.attempt->next;
  // Locked::cavity, which is too weak, reads the triangles around the cavity without locks.
  const bool only_read = me.attempt->has_read && locked_ == Locked::cavity && !me.attempt->expansion.joins(mesh_, next);
  if (!only_read && !take_lock(w, next)) return set_back(w);
  if (!me.attempt->has_read) return read_first(w);
  me.attempt->expansion.visit(mesh_, next);
  expand(w);
}

/// The triangle for which the insertion is.
void Speculation::read_first(int w) {
  SpeculativeAttempt& attempt = *workers_[place(w)].attempt;
  const Index t = attempt.task.triangle;
  attempt.has_read = true;
  if (!mesh_.in_use(t) || !needs_work(mesh_, t, bounds_)) return give_up(w);
  if (const auto side = encroached_side(mesh_, t)) {
    aim(w, bounds_.small_angles().split_point(mesh_, *side), triangles_at(mesh_, *side), *side);
  } else {
    const Point p = circumcentre(mesh_, t);
    if (!circumdisk_contains(mesh_, t, p)) return give_up(w);
    aim(w, p, {t}, {});
  }
  expand(w);
}

/// Names the triangle of the next step.
void Speculation::expand(int w) {
  SpeculativeAttempt& attempt = *workers_[place(w)].attempt;
  attempt.next = attempt.expansion.next(mesh_);
  if (attempt.next == no_index) complete(w);
}

/// The cavity is known. Only now does the worker know whether its circumcentre encroaches.
void Speculation::complete(int w) {
  SpeculativeAttempt& attempt = *workers_[place(w)].attempt;
  attempt.cavity = attempt.expansion.cavity(mesh_);
  const Point p = attempt.expansion.point();
  if (attempt.split.triangle == no_index) {
    if (const auto side = blocking_side(mesh_, attempt.cavity, p)) {
      ++counts_.late;
      account_.wasted += std::exchange(attempt.steps, 0);
      std::vector<Index> starts = triangles_at(mesh_, *side);
      release(w, starts, false);
      aim(w, bounds_.small_angles().split_point(mesh_, *side), std::move(starts), *side);
      return expand(w);
    }
  } else {
    const auto [a, b] = ends(mesh_, attempt.split);
    if (p == mesh_.points[a] || p == mesh_.points[b]) return give_up(w);
  }
  if (!can_be_connected(mesh_, attempt.cavity, p, attempt.split)) return give_up(w);
  attempt.writes = attempt.cavity.boundary.size();
}

/// The mesh changes at the last of the steps that write. Then all locks are released, and new bad triangles queue.
void Speculation::write(int w) {
  SpeculativeWorker& me = workers_[place(w)];
  if (--me.attempt->writes > 0) return;
  const Index t = me.attempt->task.triangle;
  const bool remains = !me.attempt->cavity.contains(t);
  const std::vector<Index> made =
      carry_out(mesh_, {t, me.attempt->expansion.point(), me.attempt->split, me.attempt->cavity});
  release(w, {}, true);
  marks_.resize(mesh_.faces.size());
  for (const Index m : made) {
    marks_[m].owner = territory_.owner(mesh_, m);
    marks_[m].freed = me.clock;
    add_if_bad(w, m, me.clock);
  }
  // A triangle whose circumcentre was given up is still there.
  if (remains) {
    me.queue.push_back({t, me.clock});
    ++pending_;
  }
  me.attempt.reset();
  --pending_;
}

Outcome Speculation::outcome() && {
  for (const SpeculativeWorker& worker : workers_) account_.critical = std::max(account_.critical, worker.clock);
  account_.insertions = mesh_.points.size() - inputs_;
  compact(mesh_);
  account_.most_held = most_owned(mesh_, territory_);
  return {std::move(mesh_), account_};
}

}  // namespace pardel::schemes
