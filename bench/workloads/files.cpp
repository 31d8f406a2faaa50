// The check of a mesh, and readers and writers of meshes. The mesh is that of the workload `refinement`.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "../../core/formats.hpp"
#include "../../parallel/mesher.hpp"
#include "../../properties/checker/check.hpp"
#include "../../properties/domains/domains.hpp"
#include "temporary_folder.hpp"
#include "workload.hpp"

namespace pardel::workloads {
namespace {

/// The mesh of the pipe, or nothing if it cannot be made.
std::shared_ptr<const Mesh> made_mesh(const Pslg& pslg, const Goal& goal) {
  Result<Meshed> made = mesh(pslg, goal, {.threads = 1});
  return made ? std::make_shared<const Mesh>(std::move(made.value().mesh)) : nullptr;
}
Goal goal_of(const Setup& setup) { return {.max_area = setup.pick(1.54e-4, 6.8e-6)}; }

Job check_pipe(const Setup& setup) {
  const Pslg pslg = domains::pipe();
  const Goal goal = goal_of(setup);
  const std::shared_ptr<const Mesh> made = made_mesh(pslg, goal);
  return {.work = [=] { return made && check(pslg, *made, goal).valid; },
          .mesh = [made]() -> const Mesh& { return *made; }};
}

bool write_node(const Mesh& mesh, const TemporaryFolder& folder) {
  return write_triangle_files(mesh, {}, folder / "m", {}).ok();
}
bool write_vtu_file(const Mesh& mesh, const TemporaryFolder& folder) { return write_vtu(mesh, folder / "m.vtu").ok(); }
bool write_msh_file(const Mesh& mesh, const TemporaryFolder& folder) {
  return write_msh(mesh, folder / "m.msh", MshEncoding::binary).ok();
}
bool write_msh_text(const Mesh& mesh, const TemporaryFolder& folder) {
  return write_msh(mesh, folder / "m.msh", MshEncoding::ascii).ok();
}
bool write_off_file(const Mesh& mesh, const TemporaryFolder& folder) { return write_off(mesh, folder / "m.off").ok(); }

using Write = bool (*)(const Mesh&, const TemporaryFolder&);

template <Write write>
Job writing(const Setup& setup) {
  const std::shared_ptr<const Mesh> made = made_mesh(domains::pipe(), goal_of(setup));
  const auto folder = std::make_shared<TemporaryFolder>();
  return {.work = [=] { return made && write(*made, *folder); }, .mesh = [made]() -> const Mesh& { return *made; }};
}

/// Reads the file that `write` writes.
Job reading(const Setup& setup, Write write, const char* name) {
  const std::shared_ptr<const Mesh> made = made_mesh(domains::pipe(), goal_of(setup));
  const auto folder = std::make_shared<TemporaryFolder>();
  const bool written = made && write(*made, *folder);
  const auto read = std::make_shared<std::optional<Result<Mesh>>>();
  return {.work =
              [=] {
                if (!written) return false;
                read->emplace(read_mesh(*folder / name));
                return (*read)->ok();
              },
          .mesh = [read]() -> const Mesh& { return ***read; }};
}
Job read_node(const Setup& setup) { return reading(setup, write_node, "m.node"); }
Job read_vtu(const Setup& setup) { return reading(setup, write_vtu_file, "m.vtu"); }
Job read_msh(const Setup& setup) { return reading(setup, write_msh_file, "m.msh"); }
Job read_msh_text(const Setup& setup) { return reading(setup, write_msh_text, "m.msh"); }
Job read_off(const Setup& setup) { return reading(setup, write_off_file, "m.off"); }

/// Writes a mesh as text and as VTU, and reads both.
Job text_and_vtu(const Setup& setup) {
  const std::shared_ptr<const Mesh> made = made_mesh(domains::pipe(), goal_of(setup));
  return {.work =
              [made] {
                const TemporaryFolder folder;
                return made && write_node(*made, folder) && write_vtu_file(*made, folder) &&
                       read_mesh(folder / "m.node").ok() && read_mesh(folder / "m.vtu").ok();
              },
          .mesh = [made]() -> const Mesh& { return *made; }};
}

constexpr Workload list[] = {
    {"check", true, true, check_pipe},
    {"files", true, true, text_and_vtu},
    {"write_node", false, true, writing<write_node>},
    {"read_node", false, true, read_node},
    {"write_vtu", false, true, writing<write_vtu_file>},
    {"read_vtu", false, true, read_vtu},
    {"write_msh", false, true, writing<write_msh_file>},
    {"read_msh", false, true, read_msh},
    {"write_msh_text", false, true, writing<write_msh_text>},
    {"read_msh_text", false, true, read_msh_text},
    {"write_off", false, true, writing<write_off_file>},
    {"read_off", false, true, read_off},
};

}  // namespace

std::span<const Workload> of_files() { return list; }

}  // namespace pardel::workloads
