// The books of one number of workers, of which a run in rounds keeps several: who works for a candidate, and what that
// costs.
#pragma once

#include "../rules/ruppert.hpp"
#include "../workers/phase.hpp"
#include "../workers/territory.hpp"

namespace pardel::schemes {

class Ledger {
 public:
  /// `start`: the account before the first round.
  Ledger(const LinkedMesh& mesh, const Bounds& bounds, int workers, const Account& start)
      : territory_(mesh, bounds, workers), account_(start), phase_(workers) {}

  [[nodiscard]] int workers() const { return territory_.workers(); }

  /// The owner of the point finds the insertion. The owners of the cavity's triangles send them.
  void find(const LinkedMesh& mesh, const Insertion& insertion, std::uint64_t work) {
    const int worker = territory_.owner(insertion.point);
    phase_.work(worker, work);
    for (const Index t : insertion.cavity.triangles) phase_.send(territory_.owner(mesh, t), worker, bytes_of_triangle);
  }
  /// What was found is not used.
  void waste(std::uint64_t work) { phase_.declare_wasted(work); }
  /// The owner of the point finds the insertion anew, in the same phase.
  void find_again(const Insertion& insertion, std::uint64_t work) {
    phase_.work(territory_.owner(insertion.point), work);
  }
  /// The owner of the point carries the insertion out, and sends the new triangles to their owners.
  void carry_out(const LinkedMesh& mesh, const Insertion& insertion, const std::vector<Index>& made) {
    const int worker = territory_.owner(insertion.point);
    phase_.work(worker, insertion.work());
    for (const Index t : made) phase_.send(worker, territory_.owner(mesh, t), bytes_of_triangle);
    ++account_.insertions;
  }
  void set_back() { ++account_.set_backs; }
  void end_phase() {
    phase_.end(account_);
    phase_ = Phase(territory_.workers());
  }
  /// After a choice with decisions that wait for each other.
  void end_choice(std::uint64_t depth) { account_.barriers += depth; }
  void end_round() { ++account_.rounds; }

  /// The account at the end of the run.
  [[nodiscard]] Account close(const LinkedMesh& mesh) {
    account_.most_held = most_owned(mesh, territory_);
    return account_;
  }

 private:
  Territory territory_;
  Account account_;
  Phase phase_;
};

}  // namespace pardel::schemes
