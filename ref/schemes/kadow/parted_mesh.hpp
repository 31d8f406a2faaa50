// A mesh that is divided among workers during its refinement (kadow.hpp).
#pragma once

#include <deque>

#include "../workers/phase.hpp"
#include "start.hpp"

namespace pardel::schemes {

struct PartedMesh {
  LinkedMesh mesh;
  std::vector<int> owner;                  ///< of each face, also of those that are not in use
  std::vector<std::deque<Index>> waiting;  ///< of each worker: triangles that may need work
  std::vector<std::uint64_t> held;         ///< of each worker: triangles
  std::vector<int> levels;                 ///< of each worker: number of cuts of its part
};

[[nodiscard]] PartedMesh parted_mesh(PartedStart start);

/// Does the cavity, with the triangles that were read around it, consist of triangles of one worker?
[[nodiscard]] bool belongs_to(const PartedMesh& parted, const Cavity& cavity, int worker);
/// Was all that was read to find this insertion for a triangle of a worker the worker's own? The cavity of a
/// circumcentre that was rejected has been read, too.
[[nodiscard]] bool is_local(const PartedMesh& parted, const Insertion& insertion, int worker);

/// How many triangles the worker has read of the first cavity for the insertion when it meets an interface: its own
/// triangles that it reaches without leaving its part, and what is across their sides.
[[nodiscard]] std::uint64_t read_before_interface(const PartedMesh& parted, const Insertion& insertion, int worker);

/// Carries out an insertion. Each new triangle belongs to the owner of the old one at the same side of the cavity. The
/// new triangles wait, and so does the one for which the insertion was if it is still there.
void carry_out(PartedMesh& parted, const Insertion& insertion);

/// The owners of the triangles of a cavity, each once.
[[nodiscard]] std::vector<int> owners_of(const PartedMesh& parted, const Cavity& cavity);
/// Unconstrained sides between two triangles of the cavity whose owners differ.
[[nodiscard]] std::uint64_t interfaces_inside(const PartedMesh& parted, const Cavity& cavity);

/// Gives halves of large parts to workers that have none, the largest parts first. Returns the number of divided parts.
std::uint64_t divide_large_parts(PartedMesh& parted, const GivenPointsOptions& options, std::size_t least_inner,
                                 Account& account);

}  // namespace pardel::schemes
