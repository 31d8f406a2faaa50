#include "read_geojson.hpp"

#include <utility>

#include "../core/formats.hpp"
#include "place_seeds.hpp"

namespace pardel::cli {
namespace fs = std::filesystem;

bool is_geojson(const fs::path& file) { return file.extension() == ".geojson" || file.extension() == ".json"; }

bool looks_like_json(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '{';
}

Result<DrawnDomain> read_drawing(const fs::path& file, LengthProperty lengths, const GoOn& go_on) {
  const Result<std::string> text = read_text(file, go_on);
  if (!text) return text.error();
  return parse_geojson(*text, file.string(), lengths, go_on);
}

Result<Pslg> parse_drawn_domain(std::string_view text, const std::string& name, const GoOn& go_on) {
  Result<DrawnDomain> drawn = parse_geojson(text, name, LengthProperty::ignored, go_on);
  if (!drawn) return drawn.error();
  return place_seeds(std::move(*drawn));
}

Result<Pslg> read_geojson(const fs::path& file, const GoOn& go_on) {
  const Result<std::string> text = read_text(file, go_on);
  if (!text) return text.error();
  return parse_drawn_domain(*text, file.string(), go_on);
}

}  // namespace pardel::cli
