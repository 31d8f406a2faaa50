// Reads rasters: selects the reader by the suffix of the file.
#include <cmath>

#include "../formats.hpp"
#include "raster_readers.hpp"
#include "text_reader.hpp"

namespace pardel {

Status files::check_place(const Raster& raster, const std::string& name) {
  const Point high = raster.high();  // computed from low(), so low() is finite if high() is
  if (std::isfinite(high.x) && std::isfinite(high.y)) return Done{};
  return Error{ErrorKind::invalid_input, name + ": the raster extends beyond the range of a double"};
}

namespace {

Result<Raster> raster_in(const std::filesystem::path& file, StopSignal* stop) {
  const auto text = files::read_file(file, stop);
  if (!text) return text.error();
  const std::string suffix = file.extension().string();
  if (suffix != ".npy" && suffix != ".NPY") return files::parse_asc(*text, file.string(), stop);
  std::filesystem::path world = file;
  world.replace_extension(".wld");
  const auto place = files::read_file(world);
  if (!place) {
    return Error{ErrorKind::invalid_input, file.string() + ": the array needs a world file that says where it lies (" +
                                               place.error().message + ")"};
  }
  return files::parse_npy(*text, file.string(), *place, world.string());
}

}  // namespace

Result<Raster> read_raster(const std::filesystem::path& file, const GoOn& go_on) {
  return stoppable(go_on, [&](StopSignal* stop) { return raster_in(file, stop); });
}

}  // namespace pardel
