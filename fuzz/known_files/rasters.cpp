// Lists of numbers, and rasters. Places and steps of rasters have few bits, so that a reader computes them exactly.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "../../core/support/shortest.hpp"
#include "formats.hpp"
#include "values.hpp"

namespace pardel::fuzz {

using generators::Random;

KnownFile any_list(Random& random, bool may_be_negative) {
  std::vector<double> values(static_cast<std::size_t>(random.between(1, 5)));
  const int first = random.between(0, 1);
  std::string lines = std::to_string(values.size()) + "\n";
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool is_none = may_be_negative && random.chance(4);
    values[i] = is_none ? std::numeric_limits<double>::infinity() : any_positive_number(random);
    lines += std::to_string(static_cast<std::size_t>(first) + i) + " " + (is_none ? "-1" : shortest(values[i])) + "\n";
  }
  return {lines, values};
}

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// A raster without values.
Raster any_place(Random& random) {
  Raster raster;
  raster.columns = static_cast<Index>(random.between(1, 4));
  raster.rows = static_cast<Index>(random.between(1, 4));
  raster.first = {random.between(-40, 40) * 0.25, random.between(-40, 40) * 0.25};
  raster.step_x = std::ldexp(random.between(1, 9), random.between(-3, 3));
  raster.step_y = std::ldexp(random.between(1, 9), random.between(-3, 3));
  raster.values.resize(std::size_t{raster.columns} * raster.rows);
  return raster;
}

std::string word(Random& random, const char* upper, const char* lower) { return random.chance(4) ? lower : upper; }

}  // namespace

KnownFile any_grid(Random& random) {
  Raster raster = any_place(random);
  const bool square = random.chance(2), corner = random.chance(2), names_missing = random.chance(2);
  if (square) raster.step_y = raster.step_x;
  const double half = corner ? 0.5 : 0, missing = names_missing ? random.between(-9, 9) : -9999;
  std::string grid = word(random, "NCOLS ", "ncols ") + std::to_string(raster.columns) + "\n" +
                     word(random, "NROWS ", "nrows ") + std::to_string(raster.rows) + "\n" +
                     (corner ? "XLLCORNER " : "XLLCENTER ") + shortest(raster.first.x - half * raster.step_x) + "\n" +
                     (corner ? "yllcorner " : "yllcenter ") + shortest(raster.first.y - half * raster.step_y) + "\n";
  grid += square ? "CELLSIZE " + shortest(raster.step_x) + "\n"
                 : "DX " + shortest(raster.step_x) + "\nDY " + shortest(raster.step_y) + "\n";
  if (names_missing) grid += "NODATA_VALUE " + shortest(missing) + "\n";
  for (std::size_t row = raster.rows; row-- > 0;)
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const double given = random.chance(4) ? missing : any_number(random);
      raster.values[row * raster.columns + column] = given == missing ? no_value : given;
      grid += shortest(given) + (column + 1 < raster.columns || random.chance(4) ? " " : "\n");
    }
  return {grid, raster};
}

namespace {

/// Appends the number as a Stored, and returns what the file has then.
template <class Stored>
double append_as(std::string& bytes, double value, bool big_endian) {
  const auto stored = static_cast<Stored>(value);
  std::string number(reinterpret_cast<const char*>(&stored), sizeof stored);
  if (big_endian) std::ranges::reverse(number);
  bytes += number;
  return static_cast<double>(stored);
}

struct NumberType {
  const char* name;
  double (*append)(std::string& bytes, double value, bool big_endian);
  bool is_whole;
};
constexpr NumberType types[] = {{"f8", append_as<double>, false},       {"f4", append_as<float>, false},
                                {"i1", append_as<std::int8_t>, true},   {"i2", append_as<std::int16_t>, true},
                                {"i4", append_as<std::int32_t>, true},  {"i8", append_as<std::int64_t>, true},
                                {"u1", append_as<std::uint8_t>, true},  {"u2", append_as<std::uint16_t>, true},
                                {"u4", append_as<std::uint32_t>, true}, {"u8", append_as<std::uint64_t>, true}};

}  // namespace

KnownFile any_array(Random& random) {
  Raster raster = any_place(random);
  const NumberType& type = types[random.below(std::size(types))];
  const bool big_endian = random.chance(4), columns_first = random.chance(4);
  const char order = type.name[1] == '1' ? '|' : big_endian ? '>' : '<';
  std::string header = std::string("{'descr': '") + order + type.name +
                       "', 'fortran_order': " + (columns_first ? "True" : "False") + ", 'shape': (" +
                       std::to_string(raster.rows) + ", " + std::to_string(raster.columns) + "), }";
  header.resize(117, ' ');
  header += '\n';
  std::string array =
      std::string("\x93NUMPY\x01\x00", 8) + std::string{static_cast<char>(header.size()), '\0'} + header;
  for (std::size_t k = 0; k < raster.values.size(); ++k) {
    const std::size_t row = columns_first ? k % raster.rows : k / raster.columns;  // the first one is the northernmost
    const std::size_t column = columns_first ? k / raster.rows : k % raster.columns;
    double value = random.between(0, 100);
    if (!type.is_whole && random.chance(2)) value = random.chance(4) ? no_value : random.uniform(-1, 1);
    raster.values[(raster.rows - 1 - row) * raster.columns + column] = type.append(array, value, big_endian);
  }
  const double north = raster.first.y + (raster.rows - 1) * raster.step_y;
  const std::string world = shortest(raster.step_x) + "\n0\n0\n" + shortest(-raster.step_y) + "\n" +
                            shortest(raster.first.x) + "\n" + shortest(north) + "\n";
  return {"== lengths.wld\n" + world + "\n== lengths.npy\n" + array, raster};
}

}  // namespace pardel::fuzz
