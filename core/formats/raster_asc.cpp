// Reads ESRI ASCII grids.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "../formats.hpp"
#include "raster_readers.hpp"
#include "text_reader.hpp"

namespace pardel {
namespace files {
namespace {

/// The numbers of the header by their names, in lower case.
using Header = std::map<std::string, double>;

bool is_name(std::string_view field) { return !field.empty() && std::isalpha(static_cast<unsigned char>(field[0])); }

std::string lower(std::string_view name) {
  std::string text(name);
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Reads the lines that begin with a name. The first other line is the first row of values.
Header read_header(TextReader& in) {
  Header header;
  while (in.next_line() && is_name(in.rest().substr(0, 1))) {
    const std::string name = lower(in.word());
    header[name] = in.number("the value of " + name);
  }
  return header;
}

/// The number with one of two names. Fails if there is none.
double either(TextReader& in, const Header& header, const std::string& name, const std::string& other) {
  for (const std::string& key : {name, other})
    if (const auto found = header.find(key); found != header.end()) return found->second;
  in.fail("the header of the grid has neither " + name + " nor " + other);
  return 1;
}

Index count(TextReader& in, const Header& header, const std::string& name) {
  const auto found = header.find(name);
  if (found == header.end()) {
    in.fail("the header of the grid has no " + name);
    return 1;
  }
  const double value = found->second;
  if (value >= 1 && value < no_index && value == std::floor(value)) return static_cast<Index>(value);
  in.fail(name + " must be a whole number greater than 0");
  return 1;
}

double step(TextReader& in, const Header& header, const std::string& name) {
  const double value = either(in, header, "cellsize", name);
  if (!(value > 0)) in.fail("the size of a cell must be greater than 0");
  return value;
}

/// The first grid point in one direction. A corner is half a step before it.
double first(TextReader& in, const Header& header, const std::string& axis, double step) {
  if (const auto centre = header.find(axis + "llcenter"); centre != header.end()) return centre->second;
  return either(in, header, axis + "llcorner", axis + "llcenter") + 0.5 * step;
}

void read_values(TextReader& in, double missing, Raster& raster) {
  const std::size_t n = std::size_t{raster.columns} * raster.rows;
  if (!in.room_for(n, text_bytes(1), "values")) return;
  raster.values.resize(n);
  for (Index row = raster.rows; row-- > 0;)
    for (Index column = 0; column < raster.columns && !in.failed(); ++column) {
      if (!in.has_field() && !in.next_field()) {
        in.fail("expected " + std::to_string(n) + " values, found the end of the file");
        return;
      }
      const double value = in.number("a value of the grid");
      raster.values[std::size_t{row} * raster.columns + column] = value == missing ? NAN : value;
    }
}

}  // namespace

Result<Raster> parse_asc(std::string_view text, const std::string& name) {
  TextReader in(text, name);
  const Header header = read_header(in);
  Raster raster;
  raster.columns = count(in, header, "ncols");
  raster.rows = count(in, header, "nrows");
  raster.step_x = step(in, header, "dx");
  raster.step_y = step(in, header, "dy");
  raster.first = {first(in, header, "x", raster.step_x), first(in, header, "y", raster.step_y)};
  const auto missing = header.find("nodata_value");
  read_values(in, missing == header.end() ? -9999 : missing->second, raster);
  if (in.failed()) return in.error();
  return raster;
}

}  // namespace files

Result<Raster> read_raster(const std::filesystem::path& file) {
  const auto text = files::read_file(file);
  if (!text) return text.error();
  if (file.extension() != ".npy") return files::parse_asc(*text, file.string());
  std::filesystem::path world = file;
  world.replace_extension(".wld");
  const auto place = files::read_file(world);
  if (!place) {
    return Error{place.error().kind, file.string() + ": the array needs a world file that says where it lies (" +
                                         place.error().message + ")"};
  }
  return files::parse_npy(*text, file.string(), *place, world.string());
}

}  // namespace pardel
