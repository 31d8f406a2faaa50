// Domains in GeoJSON (RFC 7946).
#pragma once

#include <filesystem>

#include "../core/pslg.hpp"
#include "../core/result.hpp"

namespace pardel::cli {

/// True for .geojson and .json.
[[nodiscard]] bool is_geojson(const std::filesystem::path& file);

/// Reads a domain as parse_geojson() and place_seeds() describe it. Points count from 0, in the order of the file.
/// Errors: `io`; those of parse_geojson().
[[nodiscard]] Result<Pslg> read_geojson(const std::filesystem::path& file);

}  // namespace pardel::cli
