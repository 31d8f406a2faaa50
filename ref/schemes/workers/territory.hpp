// Who owns which part of the plane: a division among workers with equal shares of the expected work.
//
// Source: M. J. Berger and S. H. Bokhari, "A partitioning strategy for nonuniform problems on multiprocessors", 1987
// (recursive bisection of coordinates).
#pragma once

#include <vector>

#include "../rules/bounds.hpp"

namespace pardel::schemes {

class Territory {
 public:
  /// Divides the domain of the mesh so that the parts have about the same number of triangles of the wanted size, and
  /// of triangles of the mesh where no size is wanted. Precondition: workers >= 1. O(n log workers) time.
  Territory(const LinkedMesh& mesh, const Bounds& bounds, int workers);

  /// The worker that owns p, from 0 to workers - 1. O(log workers) time.
  [[nodiscard]] int owner(Point p) const;
  /// The worker that owns the centroid of t.
  [[nodiscard]] int owner(const LinkedMesh& mesh, Index t) const;
  [[nodiscard]] int workers() const { return workers_; }

  /// A piece of the line x = `at` (or y = `at`), where the other coordinate is from `low` to `high`.
  struct Line {
    bool in_x;
    double at, low, high;
  };
  /// The borders between the parts of a box. Each ends at earlier ones or at the box.
  [[nodiscard]] std::vector<Line> borders(Point low, Point high) const;

 private:
  struct Sample {
    Point p;
    double weight;
  };
  /// Below `at` lies the child `low`, else the child `high`. A child below 0 is the worker -child - 1.
  struct Cut {
    bool in_x;
    double at;
    int low, high;
  };
  /// Divides the samples among workers `first` to `first` + `count` - 1. Returns the child.
  int divide(std::vector<Sample>& samples, std::size_t from, std::size_t to, int first, int count);

  void add_borders(int child, Point low, Point high, std::vector<Line>& lines) const;

  int workers_;
  int root_;
  std::vector<Cut> cuts_;
};

/// The largest number of triangles in use that one worker owns.
[[nodiscard]] std::uint64_t most_owned(const LinkedMesh& mesh, const Territory& territory);

}  // namespace pardel::schemes
