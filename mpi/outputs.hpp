// The output files of a mesh in pieces.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "../cli/goal_options.hpp"
#include "../core/formats.hpp"
#include "../distributed/distributed.hpp"
#include "job.hpp"

namespace pardel::mpi {

/// The names for messages: "out.pvtu, out.msh".
[[nodiscard]] std::string names_of(std::span<const std::filesystem::path> outputs);

struct ExpectedOutputs {
  std::span<const std::filesystem::path> outputs;
  int pieces;                    ///< of all ranks; rank r of R writes the pieces r, r + R, ...
  std::filesystem::path json{};  ///< the report, which the first rank writes; empty: none
};

/// Errors: `usage` if a suffix is not .pvtu, .msh, .node or .ele, or if an output or a piece of this rank would replace
/// or hide another file; `io` if a folder is not writable, or if a piece of this rank cannot get its name. `goal`: has
/// the names of files with sizes.
[[nodiscard]] Status check_outputs(const ExpectedOutputs& expected, const std::filesystem::path& input,
                                   const cli::GoalOptions& goal, const Ranks& ranks);

/// Collective, after check_outputs(). An error if a rank does not see the files that the first rank makes in the
/// folders of the outputs: then the ranks are on machines that have no folder in common.
[[nodiscard]] Status check_common_folders(std::span<const std::filesystem::path> outputs, Job& job);

/// The files of OUT.pvtu. A rank can write several pieces.
class PvtuFiles {
 public:
  /// If OUT.pvtu is a symbolic link, the pieces come into the folder of the file that it leads to.
  explicit PvtuFiles(const std::filesystem::path& pvtu);
  /// Writes OUT_NUMBER.vtu, under another name.
  [[nodiscard]] Status add(const MeshPiece& piece, int number);
  /// Collective. Writes OUT.pvtu, and gives the files of all ranks their names, or none if a rank has failed. `here`:
  /// the outcome of add(). `pieces`: their number on all ranks.
  [[nodiscard]] Status commit(const Status& here, int pieces, Job& job);

 private:
  std::filesystem::path pvtu_;
  VtuPieces files_;
  bool have_regions_ = false;
  std::size_t attributes_per_point_ = 0;
};

/// Collective. The suffix sets the format. Each rank writes its own file of OUT.pvtu and OUT.msh, and its part of
/// OUT.node, OUT.ele and OUT.poly. The files get their names when all ranks have finished.
[[nodiscard]] Status write_pieces(const MeshPiece& piece, const Pslg& pslg, const std::filesystem::path& output,
                                  MshEncoding msh, Job& job);

}  // namespace pardel::mpi
