// One reader per format of rasters. Messages use `name` as the file name.
#pragma once

#include <string>
#include <string_view>

#include "../raster.hpp"
#include "../result.hpp"
#include "../support/stop_signal.hpp"

namespace pardel::files {

/// Fails if the rectangle of the raster is beyond the range of a double.
[[nodiscard]] Status check_place(const Raster& raster, const std::string& name);
[[nodiscard]] Result<Raster> parse_asc(std::string_view text, const std::string& name, StopSignal* stop = nullptr);
/// `world`: the text of the world file, `world_name` its name.
[[nodiscard]] Result<Raster> parse_npy(std::string_view bytes, const std::string& name, std::string_view world,
                                       const std::string& world_name);

}  // namespace pardel::files
