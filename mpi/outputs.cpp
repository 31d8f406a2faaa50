#include "outputs.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <optional>
#include <span>
#include <system_error>
#include <vector>

#include "../cli/distinct_files.hpp"
#include "../cli/output.hpp"
#include "../core/support/collective.hpp"
#include "../core/support/kept_file.hpp"
#include "../core/support/open_file.hpp"
#include "../core/support/output_file.hpp"
#include "../core/support/this_machine.hpp"
#include "absent_options.hpp"

namespace pardel::mpi {
namespace {

namespace fs = std::filesystem;

/// The file of a piece, in the folder of the .pvtu.
fs::path vtu_of_piece(const fs::path& pvtu, int number) {
  fs::path file = pvtu;
  file.replace_filename(fmt::format("{}_{:04}.vtu", pvtu.stem().string(), number));
  return file;
}

bool is_of_triangle(const fs::path& output) { return mesh_format(output) == MeshFormat::triangle; }

/// The piece of an output that has pieces. `number`: from 0.
fs::path piece_of(const fs::path& output, int number) {
  return output.extension() == ".msh" ? msh_of_piece(output, number + 1) : vtu_of_piece(behind_links(output), number);
}

/// An error if the ranks cannot write this file.
Status check_file(const fs::path& file) {
  if (std::error_code ignored; is_written_directly(file) && !fs::is_directory(file, ignored))
    return Error{ErrorKind::usage,
                 fmt::format("{}: this is not a regular file; choose another name for the output", file.string())};
  return cli::check_folder(file);
}

/// Why ranks do not write an output that 'pardel mesh' writes; the end of a message. Empty for an unknown suffix.
std::string why_not_written(const fs::path& output) {
  if (is_standard_output(output)) return fmt::format(": {}", no_standard_output);
  if (!mesh_format(output)) return {};
  return fmt::format(
      ": a {} holds the whole mesh, which no rank has; write OUT.pvtu, and then use 'pardel convert OUT.pvtu {}'",
      output.extension().string(), output.string());
}

Status check_output(const fs::path& output) {
  const std::string name = output.string();
  const bool is_pvtu = output.extension() == ".pvtu", is_msh = output.extension() == ".msh";
  if (!is_pvtu && !is_msh && !is_of_triangle(output))
    return Error{ErrorKind::usage,
                 fmt::format("the output {} must end in .pvtu, .msh, .node or .ele{}", name, why_not_written(output))};
  if (is_pvtu && behind_links(output).filename().string().find_first_of("<>&\"") != std::string::npos)
    return Error{ErrorKind::usage, fmt::format("the name of the output {} must not contain <, >, & or \"", name)};
  if (std::error_code ignored; is_msh && fs::exists(output, ignored))
    return Error{ErrorKind::usage, fmt::format("{}: this file exists, and would hide the pieces {}, ...; remove it or "
                                               "choose another name",
                                               name, msh_of_piece(output, 1).string())};
  if (is_pvtu) return check_file(output);
  Status fine = Done{};
  if (is_of_triangle(output))
    for (const std::string& file : written_files(output))
      if (fine) fine = check_file(file);
  return fine;
}

/// The earlier .pvtu, which the first rank removes before pieces get their names: it must not name pieces of two
/// meshes, also if a rank is killed then. Without forget() the destructor puts it back.
class KeptIndex {
 public:
  KeptIndex(const fs::path& pvtu, Job& job) : pvtu_(pvtu), job_(job) {
    std::error_code ignored;
    if (job.is_first() && fs::is_regular_file(fs::symlink_status(pvtu, ignored))) kept_.emplace(pvtu);
  }
  /// Collective.
  [[nodiscard]] Status remove() {
    std::error_code failure;
    if (kept_ && fs::remove(pvtu_, failure)) kept_->changed();
    return job_.agree(failure ? Status(Error{ErrorKind::io, fmt::format("{}: {}", pvtu_.string(), failure.message())})
                              : Status(Done{}));
  }
  void forget() {
    if (kept_) kept_->forget();
  }

 private:
  const fs::path& pvtu_;
  Job& job_;
  std::optional<KeptFile> kept_;
};

/// Collective. True if all ranks run on one machine, where the name of this folder stands for the same one.
bool is_one_folder(const fs::path& folder, Job& job) {
  const std::string here = identity_of(folder.empty() ? "." : folder);
  const bool is_that_of_first = text_from_first(here, job.ranks()) == here && !here.empty();
  return job.agree(is_that_of_first ? Status(Done{}) : Error{ErrorKind::io, "another folder"}).ok();
}

/// Collective. An error if a rank does not see the files that the first rank makes for an output. On several machines
/// the first rank makes one for a moment.
Status check_common_folder(const fs::path& output, Job& job) {
  const fs::path file = output.extension() == ".msh" ? msh_of_piece(output, 1) : output;
  if (is_one_folder(behind_links(file).parent_path(), job)) return Done{};
  std::optional<OutputFile> probe;
  std::string made;
  if (job.is_first()) made = probe.emplace(file, OutputFile::Aside::named).written().string();
  const fs::path seen = text_from_first(made, job.ranks());
  Status here = Done{};
  if (std::error_code ignored; !seen.empty() && !fs::exists(seen, ignored))
    here =
        Error{ErrorKind::io, fmt::format("{}: rank 0 has made the file {}, but this rank does not see it; the folder "
                                         "of the output must be the same on all machines",
                                         output.string(), seen.string())};
  if (job.is_first() && !probe->ok()) here = probe->close();
  return job.agree(here);
}

}  // namespace

std::string names_of(std::span<const fs::path> outputs) {
  std::vector<std::string> names;
  for (const fs::path& output : outputs) names.push_back(output.string());
  return fmt::format("{}", fmt::join(names, ", "));
}

Status check_outputs(const ExpectedOutputs& expected, const fs::path& input, const cli::GoalOptions& goal,
                     const Ranks& ranks) {
  std::vector<cli::NamedFile> files;  // the outputs, then the pieces of this rank
  for (const fs::path& output : expected.outputs) {
    if (Status fine = check_output(output); !fine) return fine;
    files.push_back({"-o", output});
  }
  for (const fs::path& output : expected.outputs) {
    if (is_of_triangle(output)) continue;
    for (int number = ranks.rank(); number < expected.pieces; number += ranks.count())
      files.push_back({fmt::format("-o {}:", output.string()), piece_of(output, number), false});
  }
  const std::size_t last_piece = files.size();
  files.push_back({"--json", expected.json});
  const std::array inputs = {cli::NamedFile{{}, input}, cli::NamedFile{{}, goal.sizes, false},
                             cli::NamedFile{{}, goal.sources, false}};
  if (Status fine = cli::check_distinct(files, inputs); !fine) return fine;
  for (const cli::NamedFile& piece : std::span(files).first(last_piece).subspan(expected.outputs.size()))
    if (Status fine = check_file(piece.file); !fine) return fine;
  return ranks.rank() == 0 ? cli::check_folder(expected.json) : Status(Done{});
}

Status check_common_folders(std::span<const fs::path> outputs, Job& job) {
  for (const fs::path& output : outputs)
    if (Status common = check_common_folder(output, job); !common) return common;
  return Done{};
}

PvtuFiles::PvtuFiles(const fs::path& pvtu) : pvtu_(behind_links(pvtu)) {}

Status PvtuFiles::add(const MeshPiece& piece, int number) {
  have_regions_ = have_regions_ || !piece.mesh.region.empty();
  attributes_per_point_ = piece.mesh.attributes_per_point;
  return files_.add(piece.mesh, piece.number.span(), vtu_of_piece(pvtu_, number));
}

Status PvtuFiles::commit(const Status& here, int pieces, Job& job) {
  if (Status written = job.agree(here); !written) return written;
  // A piece without triangles has no regions either.
  const bool have_regions = least_and_most_of(have_regions_ ? 1 : 0, job.ranks()).most > 0;
  KeptIndex old(pvtu_, job);
  if (Status removed = old.remove(); !removed) return removed;
  Status done = files_.commit([&](const Status& placed) {
    if (Status all = job.agree(placed); !all) return all;
    Status index = Done{};
    if (job.is_first()) {
      PiecesOfMesh list{{}, have_regions, attributes_per_point_};
      for (int number = 0; number < pieces; ++number)
        list.files.push_back(vtu_of_piece(pvtu_, number).filename().string());
      index = write_pvtu(list, pvtu_);
    }
    return job.agree(index);
  });
  if (done) old.forget();
  return done;
}

Status write_pieces(const MeshPiece& piece, const Pslg& pslg, const fs::path& output, MshEncoding msh, Job& job) {
  if (output.extension() == ".msh") return write_msh_piece(view_of(piece), output, msh, job.ranks());
  if (is_of_triangle(output))
    return write_triangle_pieces(view_of(piece), pslg, fs::path(output).replace_extension(), job.ranks());
  PvtuFiles files(output);
  return files.commit(files.add(piece, job.ranks().rank()), job.ranks().count(), job);
}

}  // namespace pardel::mpi
