// Reads ESRI ASCII grids.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "raster_readers.hpp"
#include "text_reader.hpp"

namespace pardel::files {
namespace {

/// The numbers of the header by their names, in lower case.
using Header = std::map<std::string, double>;

/// True if a name begins here.
bool is_name(std::string_view field) { return !field.empty() && std::isalpha(static_cast<unsigned char>(field[0])); }

std::string lower(std::string_view name) {
  std::string text(name);
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_nan(std::string_view text) { return text.size() >= 3 && lower(text.substr(0, 3)) == "nan"; }

/// A number of the grid, or of NODATA_VALUE. It can be NaN.
double number_or_nan(TextReader& in, std::string_view what) {
  if (!in.has_field() || !is_nan(in.rest())) return in.number(what);
  in.word();
  return NAN;
}

double header_number(TextReader& in, const std::string& name) {
  if (name == "ncols" || name == "nrows")
    return static_cast<double>(in.integer("the value of " + name, 1, no_index - 1));
  if (name == "nodata_value") return number_or_nan(in, "the value of " + name);
  const double value = in.number("the value of " + name);
  const bool is_step = name == "cellsize" || name == "dx" || name == "dy";
  if (is_step && !(value > 0)) in.fail("the size of a cell must be greater than 0");
  return value;
}

/// Reads the lines that begin with a name. The first other line is the first row of values.
Header read_header(TextReader& in) {
  Header header;
  while (in.next_line() && is_name(in.rest()) && !is_nan(in.rest())) {
    const std::string name = lower(in.word());
    if (header.contains(name)) in.fail(name + " is given twice");
    header[name] = header_number(in, name);
  }
  return header;
}

/// The number with exactly one of two names. Fails if there is none, or if there are both.
double either(TextReader& in, const Header& header, const std::string& name, const std::string& other) {
  const auto first = header.find(name), second = header.find(other);
  if (first != header.end() && second != header.end())
    in.fail("the header of the grid has both " + name + " and " + other);
  if (first == header.end() && second == header.end())
    in.fail("the header of the grid has neither " + name + " nor " + other);
  return first != header.end() ? first->second : second != header.end() ? second->second : 1;
}

Index count(TextReader& in, const Header& header, const std::string& name) {
  if (const auto found = header.find(name); found != header.end()) return static_cast<Index>(found->second);
  in.fail("the header of the grid has no " + name);
  return 1;
}

/// The first grid point in one direction. A corner is half a step before it.
double first(TextReader& in, const Header& header, const std::string& axis, double step) {
  const std::string centre = axis + "llcenter";
  const double value = either(in, header, axis + "llcorner", centre);
  return header.contains(centre) ? value : value + 0.5 * step;
}

bool has_another_value(TextReader& in) { return in.has_field() || in.next_field(); }

void read_values(TextReader& in, double missing, Raster& raster) {
  const std::size_t n = std::size_t{raster.columns} * raster.rows;
  if (!in.room_for(n, text_bytes(1), "values")) return;
  raster.values.resize(n);
  for (Index row = raster.rows; row-- > 0;)
    for (Index column = 0; column < raster.columns && !in.failed(); ++column) {
      if (!has_another_value(in))
        return in.fail("expected " + std::to_string(n) + " values, found the end of the file");
      const double value = number_or_nan(in, "a value of the grid");
      raster.values[std::size_t{row} * raster.columns + column] = value == missing ? NAN : value;
    }
  if (!in.failed() && has_another_value(in))
    in.fail("expected the end of the file after " + std::to_string(n) + " values, found " + in_quotes(in.word()));
}

}  // namespace

Result<Raster> parse_asc(std::string_view text, const std::string& name, StopSignal* stop) {
  TextReader in(text, name, stop);
  const Header header = read_header(in);
  Raster raster;
  raster.columns = count(in, header, "ncols");
  raster.rows = count(in, header, "nrows");
  raster.step_x = either(in, header, "cellsize", "dx");
  raster.step_y = either(in, header, "cellsize", "dy");
  raster.first = {first(in, header, "x", raster.step_x), first(in, header, "y", raster.step_y)};
  const auto missing = header.find("nodata_value");
  read_values(in, missing == header.end() ? -9999 : missing->second, raster);
  if (in.failed()) return in.error();
  if (Status finite = check_place(raster, name); !finite) return finite.error();
  return raster;
}

}  // namespace pardel::files
