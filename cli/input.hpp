// The input of the program: a domain, or a mesh with the domain that it covers.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../parallel/validate.hpp"

namespace pardel::cli {

/// A Pslg as read, not validated.
struct Domain {
  Pslg pslg;
  std::string name;  ///< of the file
};
[[nodiscard]] Result<Domain> read_domain(const std::filesystem::path& file);

/// False where the point section of a .poly is empty: its points are in the .node file of the same name.
[[nodiscard]] bool has_own_points(const std::filesystem::path& poly);

/// A mesh to refine. Its domain comes from the .poly of the same name where the mesh is in Triangle's files and that
/// .poly has as many points as the mesh; otherwise from the mesh's constrained edges and boundary.
struct CoarseMesh {
  Mesh mesh;
  std::vector<double> max_areas;  ///< one cap per triangle, or empty
  Domain domain;
};
[[nodiscard]] Result<CoarseMesh> read_coarse_mesh(const std::filesystem::path& file);

/// Reads one cap per triangle of coarse.mesh from a .area file.
[[nodiscard]] Status read_caps(CoarseMesh& coarse, const std::filesystem::path& area);

/// Makes the segments of the domain the constrained edges of the mesh, with their indices. So the vertices of the
/// refined mesh refer to segments of the domain.
void adopt_segments(CoarseMesh& coarse);

/// Validates the domain. Its problems become an `invalid_input` error with one line per problem.
[[nodiscard]] Result<ValidPslg> validated(Domain domain, const ValidateOptions& options);

struct MaybeRepaired {
  ValidPslg domain;
  std::optional<Pslg> original;  ///< the Pslg as read, where it had to be repaired
  std::vector<Index> point_map;  ///< then: point of the original -> point of the domain
};
/// Validates the domain, and repairs it where it is invalid. Every change is a line on stderr. Where the repair fails,
/// the problems of the domain become an `invalid_input` error with one line per problem.
[[nodiscard]] Result<MaybeRepaired> validated_or_repaired(Domain domain, const ValidateOptions& options);

/// All problems of a domain as one message, numbered as in its file.
[[nodiscard]] Error problems_error(const Domain& domain, std::span<const Problem> problems);

/// The same error with the name of the input in front of the message, if it is an error of the input.
[[nodiscard]] Error with_name(const Error& error, const std::string& name);

}  // namespace pardel::cli
