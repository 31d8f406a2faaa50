// Reads a domain, writes its mesh in several formats, and reads one of the files back.
//   read_and_write_files DOMAIN.poly FOLDER
#include <cstdio>
#include <filesystem>
#include <pardel/pardel.hpp>

namespace {

int failed(const pardel::Error& error) {
  std::fprintf(stderr, "%s\n", error.message.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: read_and_write_files DOMAIN.poly FOLDER\n"), 2;
  const std::filesystem::path folder = argv[2];

  const auto domain = pardel::read_pslg(argv[1]);
  if (!domain) return failed(domain.error());
  const auto meshed = pardel::mesh(*domain, {.min_angle_deg = 30});
  if (!meshed) return failed(meshed.error());

  // The format follows the suffix. An output file appears under its name only when it is complete.
  for (const char* name : {"mesh.vtu", "mesh.msh", "mesh.node", "mesh.off", "mesh.svg"}) {
    const pardel::Status written = pardel::write_mesh(meshed->mesh, *domain, folder / name);
    if (!written) return failed(written.error());
  }

  // Numbers are written so that they read back to the same doubles. The digest ignores the order of triangles.
  const auto again = pardel::read_mesh(folder / "mesh.vtu");
  if (!again) return failed(again.error());
  std::printf("%zu triangles; the mesh read from the file is the same: %s\n", again->triangles.size(),
              pardel::digest(*again) == pardel::digest(meshed->mesh) ? "yes" : "no");
}
