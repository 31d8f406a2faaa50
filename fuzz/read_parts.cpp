// Reads the bytes as a .poly, perhaps with its .node (file_bundle.hpp), or as what stands for such a file
// (known_files/): once as a whole, and once by several ranks, each of which reads a part of the points and of the
// segments. Together the ranks must have the same domain, or all have the same error.
#include <optional>
#include <string>
#include <vector>

#include "../core/formats.hpp"
#include "../properties/theorems/framework/local_ranks.hpp"
#include "file_bundle.hpp"
#include "fuzz_one.hpp"
#include "known_files/known_file.hpp"

namespace pardel::fuzz {
namespace {

using Part = Result<PartOfPslg>;

std::vector<Part> read_by(int count, const std::filesystem::path& file) {
  std::vector<Part> parts(static_cast<std::size_t>(count), Part(PartOfPslg{}));
  properties::on_ranks(
      count, [&](Ranks& ranks) { parts[static_cast<std::size_t>(ranks.rank())] = read_part_of_pslg(file, ranks); });
  return parts;
}

template <class T>
void append(std::vector<T>& all, const std::vector<T>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

Pslg together(const std::vector<Part>& parts) {
  const PartOfPslg& first = *parts.front();
  Pslg all = first.rest;
  all.attributes_per_point = first.points.attributes_per_point;
  for (const Part& part : parts) {
    const PartOfPslg& read = *part;
    if (read.rest != first.rest) fail("the ranks have read different holes or regions");
    if (read.points.first != all.points.size()) fail("the points of a rank do not follow those before it");
    if (read.segments.first != all.segments.size()) fail("the segments of a rank do not follow those before it");
    append(all.segments, read.segments.segments);
    append(all.points, read.points.points);
    append(all.point_attributes, read.points.point_attributes);
    append(all.point_markers, read.points.point_markers);
  }
  return all;
}

void compare(const Result<Pslg>& whole, const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    if (part.ok() != parts.front().ok()) fail("only some ranks have an error");
    if (!part && part.error().message != parts.front().error().message) fail("the ranks have different errors");
  }
  const Part& first = parts.front();
  if (!first) {
    if (whole) fail("only ranks have an error: " + first.error().message);
    if (whole.error().message != first.error().message)
      fail("another error: " + first.error().message + "; instead of: " + whole.error().message);
    return;
  }
  if (!whole) fail("only one process has an error: " + whole.error().message);
  if (together(parts) != *whole) fail("ranks have read another domain");
}

}  // namespace

int fuzz_one(std::span<const std::uint8_t> bytes) {
  const std::optional<KnownFile> known = known_file_of(bytes, "domain.poly");
  if (known) bytes = {reinterpret_cast<const std::uint8_t*>(known->bytes.data()), known->bytes.size()};
  const Scratch scratch;
  for (const NamedText& file : files_of(bytes, "domain.poly")) scratch.write(file);
  const std::filesystem::path path = file_to_read(scratch, "domain.poly");
  compare(read_pslg(path), read_by(static_cast<int>(bytes.size() % 5) + 1, path));
  return 0;
}

}  // namespace pardel::fuzz
