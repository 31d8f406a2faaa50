// pardel-cgal POLY OUT MIN_ANGLE [MAX_AREA]: CGAL's Mesh_2 as a program. The suffix of OUT determines the format.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <charconv>
#include <cstring>
#include <optional>

#include "../core/formats.hpp"
#include "cgal_mesh_2.hpp"

namespace pardel::bench {
namespace {

std::optional<double> number(const char* text) {
  double value = 0;
  const char* end = text + std::strlen(text);
  const auto [stop, error] = std::from_chars(text, end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

int fail(const Error& error) {
  fmt::print(stderr, "error: {}\n", error.message);
  return 5;
}

int run(const char* poly, const char* out, const Goal& goal) {
  const Result<Pslg> pslg = read_pslg(poly);
  if (!pslg) return fail(pslg.error());
  const Constrained cdt = refined(*pslg, ShapeAndArea(goal));
  const Mesh mesh = plain(cdt, [](auto face) { return face->is_in_domain(); });
  if (Status written = write_mesh(mesh, *pslg, out); !written) return fail(written.error());
  return 0;
}

}  // namespace
}  // namespace pardel::bench

int main(int argc, char** argv) {
  pardel::Goal goal;
  const auto angle = argc > 3 ? pardel::bench::number(argv[3]) : std::nullopt;
  const auto area = argc > 4 ? pardel::bench::number(argv[4]) : goal.max_area;
  if (argc < 4 || argc > 5 || !angle || !area) {
    fmt::print(stderr, "usage: pardel-cgal POLY OUT MIN_ANGLE [MAX_AREA]\n");
    return 2;
  }
  goal.min_angle_deg = *angle;
  goal.max_area = *area;
  return pardel::bench::run(argv[1], argv[2], goal);
}
