// What the program reads: a domain, or a mesh with the domain that it covers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../parallel/validate.hpp"

namespace pardel::cli {

struct Domain {
  Pslg pslg;
  std::string name;  ///< of the file
  int base = 1;      ///< number of the first point in the file, for messages
};
[[nodiscard]] Result<Domain> read_domain(const std::filesystem::path& file);

/// Number of the first vertex in a .poly or .node file: 0 or 1. 1 where the file cannot be read.
[[nodiscard]] int number_base(const std::filesystem::path& file);

/// False where the point section of a .poly is empty: its points are in the .node beside it.
[[nodiscard]] bool has_own_points(const std::filesystem::path& poly);

/// A mesh, the cap of each triangle (empty: none) and the domain: the .poly beside Triangle's files, or
/// else the mesh's constrained edges and boundary.
struct Coarse {
  Mesh mesh;
  std::vector<double> max_areas;
  Domain domain;
};
[[nodiscard]] Result<Coarse> read_coarse(const std::filesystem::path& file);

/// One cap per triangle of coarse.mesh, from a .area file.
[[nodiscard]] Status read_caps(Coarse& coarse, const std::filesystem::path& area);

/// Makes the segments of the domain the constrained edges of the mesh, so that what is refined from it knows
/// which segment a vertex was put on.
void adopt_segments(Coarse& coarse);

/// A valid Pslg stays as it is; otherwise it becomes what repair() makes of it, after a line on stderr for
/// everything that was done.
struct Mended {
  Domain domain;
  std::optional<Pslg> original;  ///< as it was, where it changed
  std::vector<Index> point_map;  ///< then: original point -> point
};
[[nodiscard]] Result<Mended> mend(Domain domain, bool convex_hull);

/// All problems of an invalid Pslg as one message, numbered as in the file.
[[nodiscard]] Error problems_error(const Domain& domain, const std::vector<Problem>& problems);

/// An error of the mesher, which knows no file and numbers from 0, in the terms of the file.
[[nodiscard]] Error as_in_file(const Error& error, const Domain& domain, bool convex_hull);

}  // namespace pardel::cli
