#include "domain_or_mesh.hpp"

#include <string>
#include <utility>

#include "../core/formats.hpp"
#include "read_geojson.hpp"

namespace pardel::cli {
namespace {

Result<std::variant<Pslg, Mesh>> either(Result<Pslg> drawn) {
  if (!drawn) return drawn.error();
  return std::variant<Pslg, Mesh>(std::move(*drawn));
}

}  // namespace

Result<std::variant<Pslg, Mesh>> read_domain_or_mesh(const std::filesystem::path& file) {
  if (is_geojson(file)) return either(read_geojson(file));
  if (file.has_extension()) return read_pslg_or_mesh(file);
  const Result<std::string> text = read_text(file);
  if (!text) return text.error();
  return looks_like_json(*text) ? either(parse_drawn_domain(*text, file.string())) : parse_pslg_or_mesh(*text, file);
}

}  // namespace pardel::cli
