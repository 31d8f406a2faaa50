// Domains and other drawings in GeoJSON (RFC 7946).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "../core/formats.hpp"
#include "../core/pslg.hpp"
#include "../core/result.hpp"
#include "parse_geojson.hpp"

namespace pardel::cli {

/// True for .geojson and .json.
[[nodiscard]] bool is_geojson(const std::filesystem::path& file);

/// True if the text begins like GeoJSON, and so like no other input: with "{", perhaps after blanks.
[[nodiscard]] bool looks_like_json(std::string_view text);

/// The domain in a text, as read_geojson() reads it. `name`: of the file, for messages.
[[nodiscard]] Result<Pslg> parse_drawn_domain(std::string_view text, const std::string& name, const GoOn& go_on = {});

/// Reads the shapes of a file. Errors: `io`; those of parse_geojson().
[[nodiscard]] Result<DrawnDomain> read_drawing(const std::filesystem::path& file, LengthProperty lengths,
                                               const GoOn& go_on = {});

/// Reads a domain as parse_geojson() and place_seeds() describe it. Points count from 0, in the order of the file.
/// Errors: those of read_drawing().
[[nodiscard]] Result<Pslg> read_geojson(const std::filesystem::path& file, const GoOn& go_on = {});

}  // namespace pardel::cli
