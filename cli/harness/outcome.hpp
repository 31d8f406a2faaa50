// The outcome of one case.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "../../core/goal.hpp"
#include "../../core/mesh.hpp"
#include "../../core/pslg.hpp"

namespace pardel::harness {

enum class Verdict : std::uint8_t {
  valid,
  missed,   ///< a correct mesh of the domain that misses a bound on angle or area; not every mesher guarantees these
  wrong,    ///< the output is not a correct mesh of the domain, or cannot be read
  crashed,  ///< ended by a signal
  hung,     ///< not finished within the time limit
  refused,  ///< the mesher exited with an error, or wrote no file
};
inline constexpr std::size_t verdict_count = 6;
[[nodiscard]] const char* name(Verdict verdict);

/// One kind of failure: the checker's name of a violation, "unreadable", "SIGSEGV", "time limit", "exit code 3" or
/// "no output". Each kind belongs to one verdict.
struct Finding {
  std::string kind;
  std::string message;  ///< one line: the first such violation, or a line of the mesher's output
};

struct Outcome {
  Verdict verdict = Verdict::valid;
  std::vector<Finding> findings;     ///< one per kind; empty if and only if the case is valid
  std::vector<std::string> details;  ///< the first violations of each kind, a line each
  std::vector<Point> where;          ///< the places of the violations

  [[nodiscard]] bool has(const std::string& kind) const;
};

/// Checks a mesh of another program with the independent checker. Parts that the mesh does not have are not checked. If
/// the mesh is wrong, missed bounds are ignored. `delaunay`: an edge that is not locally Delaunay makes the mesh wrong;
/// otherwise such edges are ignored.
[[nodiscard]] Outcome judge(const Pslg& pslg, const Mesh& mesh, const Goal& goal, bool delaunay);

}  // namespace pardel::harness
