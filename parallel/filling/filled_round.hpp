// One round of filling, that is one attempt to refine a domain around patches with all its sweeps, and the choice
// between the meshes with and without patches.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "../scheduling/refine_domain.hpp"
#include "filling.hpp"

namespace pardel::engine {

/// A domain to fill.
struct ToFill {
  const Pslg& pslg;
  bool convex_hull;
  std::vector<double> edges;  ///< as for Filling::make(): the longest that keep the goal
  /// In how many pieces the mesh is made. Limits on memory and on the number of triangles hold for one piece.
  std::uint64_t pieces = 1;
};

/// One round: a filling, and the domain without its patches, which refine() refines. Rounds (rounds.hpp) chooses the
/// patches of each round.
class FilledRound {
 public:
  /// `edges`, `pieces`: those with which the filling was made.
  FilledRound(Filling filling, const Criteria& criteria, std::span<const double> edges, const Options& options,
              std::uint64_t pieces);

  /// Refines the domain around the patches. Errors: as from refine_by_sweeps().
  [[nodiscard]] Status refine(const InputData& input, ProgressMonitor& progress);
  /// True if the refinement has made more vertices than it ever needs beside patches that fit.
  [[nodiscard]] bool has_run_away() const { return may_run_away_ && counts_.budget_reached; }
  /// The triangles that are left because of a patch.
  [[nodiscard]] const std::vector<TriangleId>& stuck() const { return stuck_; }
  [[nodiscard]] const Triangulation& triangulation() const { return domain_.triangulation; }
  /// The numbers of triangles: of those to lay, and of all.
  [[nodiscard]] std::uint64_t laid() const { return filling_.triangles(); }
  [[nodiscard]] std::uint64_t triangles() const { return domain_.triangulation.slots.size() + filling_.triangles(); }

  void write_report(const Threads& threads, Report& report);
  /// The mesh with the patches; only once.
  [[nodiscard]] Result<Mesh> take_mesh(const InputData& input, const Threads& threads) {
    return laid_into(std::move(domain_), input, threads);
  }
  /// The mesh around the patches; only once.
  [[nodiscard]] Mesh take_mesh_around(const InputData& input, const Threads& threads);
  [[nodiscard]] Filling take_filling() { return std::move(filling_); }

 private:
  [[nodiscard]] Result<Mesh> laid_into(DomainTriangulation&& domain, const InputData& input,
                                       const Threads& threads) const;

  Filling filling_;
  DomainTriangulation domain_;
  Criteria criteria_;
  Options options_;
  RefineCounts counts_;
  std::vector<TriangleId> stuck_;
  std::uint64_t pieces_;
  bool may_run_away_ = false;
};

/// The first round after which no triangle is stuck; nothing if the patches have to be given up. Writes the number of
/// restarts to the report. `coarse`: the triangulation of the Pslg. Errors: as from refine_by_sweeps().
[[nodiscard]] Result<std::optional<FilledRound>> successful_round(const ToFill& what, const DomainTriangulation& coarse,
                                                                  const Criteria& criteria, const InputData& input,
                                                                  const Options& options, ProgressMonitor& progress,
                                                                  Report& report);

/// A mesh that can be chosen.
struct Candidate {
  bool goal_met;
  std::uint64_t triangles;
};
/// True if a refinement without patches may make a better mesh than the one with patches. Where patches are small, they
/// can make more triangles than they save.
[[nodiscard]] bool may_be_worse(const Candidate& filled, std::uint64_t laid);
[[nodiscard]] bool is_better(const Candidate& refined, const Candidate& filled);

}  // namespace pardel::engine
