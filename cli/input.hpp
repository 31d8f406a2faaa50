// The input of the program: a domain, or a mesh with the domain that it covers.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "../parallel/repair.hpp"
#include "../parallel/validate.hpp"
#include "../parallel/warnings.hpp"
#include "follow_edges.hpp"
#include "problems_text.hpp"
#include "refusal.hpp"
#include "size_field.hpp"

namespace pardel::cli {

/// Error: `usage` if more than one of the inputs is standard input.
[[nodiscard]] Status check_standard_input(std::span<const std::filesystem::path> inputs);

/// A Pslg as read, not validated.
struct Domain {
  Pslg pslg;
  std::string name;                      ///< the name of the file
  NumbersInFile points{};                ///< as Mesh::numbers; empty: they count from Pslg::first_id on
  bool has_unnumbered_segments = false;  ///< in the file, the segments have no numbers
};
/// The numbers in the file, for messages. They refer to the domain.
[[nodiscard]] NumbersInMessages numbers_of(const Domain& domain);
[[nodiscard]] Result<Domain> read_domain(const std::filesystem::path& file);

/// False if the point section of the .poly is empty; the points are then in the .node file of the same name.
[[nodiscard]] bool has_own_points(const std::filesystem::path& poly);

/// The domain of a mesh that was read from `file`. If the mesh is in Triangle's files and a .poly of the same name
/// exists with as many points as the mesh, or with none of its own, this .poly is the domain. Otherwise the domain is
/// made of the mesh's constrained edges and boundary.
[[nodiscard]] Result<Pslg> domain_with(const std::filesystem::path& file, const Mesh& mesh);

/// A mesh to refine, and its domain as domain_with() returns it.
struct CoarseMesh {
  Mesh mesh;
  std::vector<double> max_areas;  ///< one cap per triangle, or empty
  Domain domain;
  FollowedEdges followed{};
  std::string note_about_poly{};  ///< why a .poly beside the mesh is not its domain
};
/// Errors: those of read_mesh(); `invalid_input` if there is no domain, and those of follow_edges() and
/// check_boundary().
[[nodiscard]] Result<CoarseMesh> read_coarse_mesh(const std::filesystem::path& file);

/// The thing that a run meshes: a valid domain, or a mesh to refine.
using Source = std::variant<ValidPslg, CoarseMesh>;
/// The domain itself, or the domain of the mesh.
[[nodiscard]] const Pslg& pslg_of(const Source& source);

/// Reads one cap per triangle of coarse.mesh from a .area file.
[[nodiscard]] Status read_caps(CoarseMesh& coarse, const std::filesystem::path& area);

/// The segments as constrained edges of a mesh that has the points of the Pslg.
[[nodiscard]] std::vector<ConstrainedEdge> segments_as_edges(const Pslg& pslg);

/// Replaces the constrained edges of the mesh by the segments of the domain, with the indices of the segments. The
/// vertices of the refined mesh then refer to segments of the domain.
void adopt_segments(CoarseMesh& coarse);

/// Validates the domain. Its problems become a refusal whose message has one line per problem.
[[nodiscard]] Result<ValidPslg, Refusal> validated(Domain domain, const ValidateOptions& options);

struct MaybeRepaired {
  ValidPslg domain;
  std::optional<Pslg> original;  ///< the Pslg as read, if it had to be repaired
  std::vector<Index> point_map;  ///< if repaired: maps points of the original to points of the domain
  std::vector<std::string> log;  ///< if repaired: one line per change, to be printed
};
/// Repairs the domain if it is invalid or has gaps smaller than the snapping distance. If the repair fails, its error
/// is the refusal of a valid domain; for an invalid one the refusal has one line per problem, too. `hull_option`: see
/// advice().
[[nodiscard]] Result<MaybeRepaired, Refusal> validated_or_repaired(Domain domain, const RepairOptions& options,
                                                                   int threads = 1,
                                                                   std::string_view hull_option = option_of_hull);

/// Validates the domain, or repairs it if `repair` is true.
[[nodiscard]] Result<MaybeRepaired, Refusal> valid_domain(Domain domain, bool repair, const RepairOptions& options,
                                                          int threads);

/// Error: `usage` if the sizes are those of points, and a repair has changed the points.
[[nodiscard]] Status check_sizes_of(const MaybeRepaired& repaired, const SizeField& sizes);

/// Finds the warnings of a domain, prints them on stderr, one line each, and returns them. Gaps are not among them.
std::vector<Warning> print_warnings(const ValidPslg& domain, const std::string& name,
                                    std::string_view program = "pardel");

/// The problems of a domain as a refusal. The message numbers them as in the file and lists ten of each kind. If a
/// command or an option can help, the message names it.
[[nodiscard]] Refusal refusal_of(const Domain& domain, std::span<const Problem> problems);
/// The same after a repair that failed for the reason `why`, which the message also states.
[[nodiscard]] Refusal refusal_of(const Domain& domain, std::span<const Problem> problems, const Error& why,
                                 std::string_view hull_option = option_of_hull);

/// Puts the name of the input before the message of an error in the input. Other errors do not change.
[[nodiscard]] Error with_name(const Error& error, const std::string& name);

}  // namespace pardel::cli
