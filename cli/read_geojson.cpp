#include "read_geojson.hpp"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>

#include "../core/support/byte_order_mark.hpp"
#include "place_seeds.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;

bool is_geojson(const fs::path& file) { return file.extension() == ".geojson" || file.extension() == ".json"; }

Result<DrawnDomain> read_drawing(const fs::path& file, LengthProperty lengths) {
  const auto failure = [&](const char* what) {
    return Error{ErrorKind::io, fmt::format("{}: {}: {}", file.string(), what, std::strerror(errno))};
  };
  std::ifstream in(file, std::ios::binary);
  if (!in) return failure("cannot be opened");
  std::string text;
  for (std::array<char, 1 << 16> chunk; in.read(chunk.data(), chunk.size()), in.gcount() > 0;)
    text.append(chunk.data(), static_cast<std::size_t>(in.gcount()));
  if (in.bad()) return failure("cannot be read");
  return parse_geojson(without_byte_order_mark(text), file.string(), lengths);
}

Result<Pslg> read_geojson(const fs::path& file) {
  Result<DrawnDomain> drawn = read_drawing(file, LengthProperty::ignored);
  if (!drawn) return drawn.error();
  return place_seeds(std::move(*drawn));
}

}  // namespace pardel::cli
