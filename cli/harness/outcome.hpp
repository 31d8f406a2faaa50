// What became of one case.
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
  missed,   ///< a right mesh of the domain, but a bound (angle, area) does not hold: not every mesher promises one
  wrong,    ///< no right mesh of the domain, or no mesh at all in the file
  crashed,  ///< ended by a signal
  hung,     ///< not done within the time limit
  refused,  ///< the mesher said so by its exit code, or wrote nothing
};
inline constexpr std::size_t verdict_count = 6;
[[nodiscard]] const char* name(Verdict verdict);

/// One kind of what was wrong, for counting: a kind of violation by the checker's name, "unreadable", "SIGSEGV",
/// "time limit", "exit code 3", "no output". Each kind belongs to one verdict.
struct Finding {
  std::string kind;
  std::string message;  ///< one line: the first such violation, what the mesher said, ...
};

struct Outcome {
  Verdict verdict = Verdict::valid;
  std::vector<Finding> findings;     ///< one per kind; none exactly where the case is valid
  std::vector<std::string> details;  ///< of a mesh: the first violations of each kind, a line each
  std::vector<Point> where;          ///< their places

  [[nodiscard]] bool has(const std::string& kind) const;
};

/// The independent checker's word on a mesh of another program: what it does not carry is not judged.
/// Of a wrong mesh, missed bounds are passed over. `delaunay`: edges that are not locally Delaunay are wrong; else they
/// are passed over.
[[nodiscard]] Outcome judge(const Pslg& pslg, const Mesh& mesh, const Goal& goal, bool delaunay);

}  // namespace pardel::harness
