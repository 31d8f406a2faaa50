#include "parse_geojson.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "../core/support/stop_signal.hpp"

namespace pardel::cli {
namespace {

using nlohmann::json;

/// Collections within collections, at most so deep.
constexpr int most_levels = 16;

/// The place of a value in the file. It is only made text for a message.
struct Place {
  const Place* parent = nullptr;
  const char* key = nullptr;  ///< null: an element of an array
  std::size_t index = 0;

  [[nodiscard]] Place operator/(const char* name) const { return {this, name, 0}; }
  [[nodiscard]] Place operator[](std::size_t i) const { return {this, nullptr, i}; }
  [[nodiscard]] std::string text() const {
    if (parent == nullptr) return {};
    const std::string before = parent->text();
    if (key == nullptr) return fmt::format("{}[{}]", before, index);
    return before.empty() ? key : before + "." + key;
  }
};

/// A failure in the file, which ends the reading.
struct WrongFile {
  std::string message;
};

[[noreturn]] void fail_with(const Place& place, const std::string& expected, const std::string& found) {
  const std::string where = place.text();
  throw WrongFile{fmt::format("{}{}expected {}, found {}", where, where.empty() ? "" : ": ", expected, found)};
}

[[noreturn]] void fail(const Place& place, const std::string& expected, const json& found) {
  constexpr std::size_t longest = 40;
  std::string text = found.is_structured() ? std::string(found.type_name())
                                           : found.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  fail_with(place, expected, text);
}

/// The value of a key; null if the object lacks it.
const json& value_of(const json& object, const char* key) {
  static const json none;
  const auto found = object.find(key);
  return found == object.end() ? none : *found;
}

/// The bytes of the text for the parser. They ask whether to go on.
class AskingBytes {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  AskingBytes(const char* at, StopSignal* stop) : at_(at), ask_(stop) {}
  reference operator*() const { return *at_; }
  AskingBytes& operator++() {
    ask_();
    ++at_;
    return *this;
  }
  friend bool operator==(const AskingBytes& a, const AskingBytes& b) { return a.at_ == b.at_; }

 private:
  const char* at_;
  SparseAsk ask_;
};

class Shapes {
 public:
  Shapes(LengthProperty lengths, StopSignal* stop) : lengths_(lengths), ask_(stop) {}

  void read(const json& object, const Place& place, const ShapeProperties& properties, int level) {
    if (!object.is_object()) fail(place, "a GeoJSON object", object);
    const json& type_value = value_of(object, "type");
    if (!type_value.is_string()) fail(place / "type", "the type of a GeoJSON object", type_value);
    const auto& type = type_value.get_ref<const std::string&>();
    if (level > most_levels) fail(place, fmt::format("at most {} collections in each other", most_levels), object);
    const json& coordinates = value_of(object, "coordinates");
    const Place at = place / "coordinates";
    if (type == "FeatureCollection")
      return each(value_of(object, "features"), place / "features", "features",
                  [&](const json& one, const Place& p) { read(one, p, {}, level + 1); });
    if (type == "GeometryCollection")
      return each(value_of(object, "geometries"), place / "geometries", "geometries",
                  [&](const json& one, const Place& p) { read(one, p, properties, level + 1); });
    if (type == "Feature") return read_feature(object, place, level);
    if (type == "Point") return read_point(coordinates, at, properties);
    if (type == "MultiPoint")
      return each(coordinates, at, "positions",
                  [&](const json& one, const Place& p) { read_point(one, p, properties); });
    if (type == "LineString") return read_line(coordinates, at, properties);
    if (type == "MultiLineString")
      return each(coordinates, at, "lines", [&](const json& one, const Place& p) { read_line(one, p, properties); });
    if (type == "Polygon") return read_polygon(coordinates, at, properties);
    if (type == "MultiPolygon")
      return each(coordinates, at, "polygons",
                  [&](const json& one, const Place& p) { read_polygon(one, p, properties); });
    fail(place / "type", "the type of a GeoJSON object", type_value);
  }

  [[nodiscard]] DrawnDomain take() && { return std::move(drawing_).take(); }

 private:
  template <class Read>
  void each(const json& array, const Place& place, const char* what, const Read& read) {
    if (!array.is_array()) fail(place, fmt::format("an array of {}", what), array);
    for (std::size_t i = 0; i < array.size(); ++i) {
      ask_();
      read(array[i], place[i]);
    }
  }

  /// A feature without a geometry draws nothing.
  void read_feature(const json& feature, const Place& place, int level) {
    const json& geometry = value_of(feature, "geometry");
    const ShapeProperties properties = properties_of(value_of(feature, "properties"), place / "properties");
    if (!geometry.is_null()) read(geometry, place / "geometry", properties, level + 1);
  }

  [[nodiscard]] ShapeProperties properties_of(const json& object, const Place& place) const {
    ShapeProperties properties;
    if (object.is_null()) return properties;
    if (!object.is_object()) fail(place, "an object of properties", object);
    if (const json& marker = value_of(object, "marker"); !marker.is_null()) {
      const double value = marker.is_number() ? marker.get<double>() : 0.5;
      if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max())
        fail(place / "marker", "a whole number of 32 bits", marker);
      properties.marker = static_cast<int>(value);
      properties.has_marker = true;
    }
    if (const json& hole = value_of(object, "hole"); !hole.is_null()) {
      if (!hole.is_boolean()) fail(place / "hole", "true or false", hole);
      properties.is_hole = hole.get<bool>();
    }
    if (const json& attribute = value_of(object, "attribute"); !attribute.is_null()) {
      if (!attribute.is_number()) fail(place / "attribute", "a number", attribute);
      properties.attribute = attribute.get<double>();
    }
    if (const json& area = value_of(object, "max_area"); !area.is_null()) {
      if (!area.is_number() || !(area.get<double>() > 0)) fail(place / "max_area", "an area greater than 0", area);
      properties.max_area = area.get<double>();
    }
    if (lengths_ == LengthProperty::ignored) return properties;
    if (const json& length = value_of(object, "length"); !length.is_null()) {
      if (!length.is_number() || !(length.get<double>() > 0)) fail(place / "length", "a length greater than 0", length);
      properties.length = length.get<double>();
    }
    return properties;
  }

  /// A third number, a height, is ignored.
  static Point position(const json& value, const Place& place) {
    if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number())
      fail(place, "a position, two numbers", value);
    return {value[0].get<double>() + 0.0, value[1].get<double>() + 0.0};  // -0 becomes 0
  }

  std::vector<Point> points(const json& positions, const Place& place) {
    std::vector<Point> all;
    each(positions, place, "positions", [&](const json& one, const Place& p) { all.push_back(position(one, p)); });
    return all;
  }

  void read_point(const json& value, const Place& place, const ShapeProperties& properties) {
    drawing_.add_point(position(value, place), properties);
  }

  void read_line(const json& positions, const Place& place, const ShapeProperties& properties) {
    const std::vector<Point> line = points(positions, place);
    if (line.size() < 2) fail(place, "at least two positions of a line", positions);
    drawing_.add_line(line, properties);
  }

  void read_polygon(const json& rings, const Place& place, const ShapeProperties& properties) {
    std::vector<std::vector<Point>> open;
    each(rings, place, "rings", [&](const json& positions, const Place& ring_place) {
      std::vector<Point> ring = points(positions, ring_place);
      if (ring.size() < 4) fail(ring_place, "at least four positions of a ring", positions);
      if (!(ring.front() == ring.back()))
        fail(ring_place[ring.size() - 1], "the first position of the ring, which closes it", positions.back());
      ring.pop_back();
      if (!open.empty() && lies_outside(ring, open.front()))
        fail_with(ring_place, "a hole inside the first ring of the polygon", "a ring outside it");
      open.push_back(std::move(ring));
    });
    drawing_.add_polygon(std::move(open), properties);
  }

  LengthProperty lengths_;
  SparseAsk ask_;
  Drawing drawing_;
};

/// `NAME:LINE:COLUMN`, both from 1 on. `at`: the number of bytes before the place.
std::string place_in_text(std::string_view text, const std::string& name, std::size_t at) {
  const std::string_view before = text.substr(0, std::min(at, text.size()));
  const std::size_t line_begin = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("{}:{}:{}", name, std::ranges::count(before, '\n') + 1, before.size() - line_begin + 1);
}

/// What the library says after its own place, which counts otherwise.
std::string reason_of(const json::exception& error) {
  const std::string_view what = error.what();
  const std::size_t at = what.find(": ");
  return std::string(at == std::string_view::npos ? what : what.substr(at + 2));
}

Result<DrawnDomain> shapes_in(std::string_view text, const std::string& name, LengthProperty lengths,
                              StopSignal* stop) {
  const auto invalid = [](const std::string& message) { return Error{ErrorKind::invalid_input, message}; };
  const char* const begin = text.data();
  try {
    Shapes shapes(lengths, stop);
    shapes.read(json::parse(AskingBytes(begin, stop), AskingBytes(begin + text.size(), nullptr)), Place{}, {}, 0);
    return std::move(shapes).take();
  } catch (const WrongFile& wrong) {
    return invalid(name + ": " + wrong.message);
  } catch (const json::parse_error& error) {
    return invalid(place_in_text(text, name, error.byte > 0 ? error.byte - 1 : 0) + ": " + reason_of(error));
  } catch (const json::out_of_range& error) {  // a number such as 1e999, in quotation marks at the end
    const std::string_view what = error.what();
    const std::size_t end = what.rfind('\''), first = end == std::string_view::npos ? end : what.rfind('\'', end - 1);
    if (first == std::string_view::npos) return invalid(name + ": " + std::string(what));
    const std::string_view number = what.substr(first + 1, end - first - 1);
    return invalid(place_in_text(text, name, text.find(number)) + ": the number " + std::string(number) +
                   " is too large for a double");
  }
}

}  // namespace

Result<DrawnDomain> parse_geojson(std::string_view text, const std::string& name, LengthProperty lengths,
                                  const std::function<bool()>& go_on) {
  return stoppable(go_on, [&](StopSignal* stop) { return shapes_in(text, name, lengths, stop); });
}

}  // namespace pardel::cli
