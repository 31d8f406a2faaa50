// Reads the bytes as a .poly file. The reader must accept or reject them without a crash. If an accepted Pslg is
// written and read again, it must be the same.
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <string>

#include "../core/formats.hpp"
#include "fuzz_one.hpp"

namespace pardel::fuzz {
namespace {

bool same(double a, double b) { return a == b || (a != a && b != b); }
bool same(Point a, Point b) { return same(a.x, b.x) && same(a.y, b.y); }
bool same(int a, int b) { return a == b; }
bool same(const Segment& a, const Segment& b) { return a == b; }
bool same(const Region& a, const Region& b) {
  return same(a.seed, b.seed) && same(a.attribute, b.attribute) && same(a.max_area, b.max_area);
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!same(a[i], b[i])) return false;
  return true;
}

/// Compares two Pslgs; NaN equals NaN. The reader accepts every number; validate() checks the ranges.
bool same(const Pslg& a, const Pslg& b) {
  return same(a.points, b.points) && a.attributes_per_point == b.attributes_per_point &&
         same(a.point_attributes, b.point_attributes) && same(a.point_markers, b.point_markers) &&
         same(a.segments, b.segments) && a.has_segment_markers == b.has_segment_markers && same(a.holes, b.holes) &&
         same(a.regions, b.regions);
}

std::filesystem::path scratch_file() {
  return std::filesystem::temp_directory_path() / ("pardel-fuzz-" + std::to_string(getpid()) + ".poly");
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const std::string text(bytes.begin(), bytes.end());
  const Result<Pslg> parsed = parse_poly(text, "input.poly");
  if (!parsed) {
    if (parsed.error().message.find("input.poly") == std::string::npos)
      fail("a message without the file's name: " + parsed.error().message);
    return 0;
  }
  const std::filesystem::path file = scratch_file();
  for (const int base : {0, 1}) {
    if (const Status written = write_poly(*parsed, file, base); !written) fail(written.error().message);
    const Result<Pslg> again = read_pslg(file);
    std::filesystem::remove(file);
    if (!again) fail("the written file is rejected: " + again.error().message);
    if (!same(*parsed, *again)) fail("the written file reads back differently");
  }
  return 0;
}

}  // namespace pardel::fuzz
