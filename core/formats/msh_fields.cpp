#include "msh_fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace pardel::files {
namespace {

/// The text without quotation marks around it.
std::string_view unquoted(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

struct FieldHeader {
  std::string name;
  double time = 0;
  std::size_t integers = 0, components = 0, records = 0;
};

FieldHeader read_field_header(TextReader& in) {
  FieldHeader header;
  in.expect_line("the number of strings");
  for (std::size_t i = 0, n = in.count("the number of strings"); i < n && in.expect_line("a line of the list"); ++i)
    if (i == 0) header.name = unquoted(in.rest_of_line());
  in.expect_line("the number of numbers");
  for (std::size_t i = 0, n = in.count("the number of numbers"); i < n && in.expect_line("a line of the list"); ++i)
    if (i == 0) header.time = in.any_number("the time");
  in.expect_line("the number of integers");
  std::array<std::size_t, 3> integers{};
  header.integers = in.count("the number of integers");
  for (std::size_t i = 0; i < header.integers && in.expect_line("an integer"); ++i) {
    const std::size_t value = in.count("an integer");
    if (i < integers.size()) integers[i] = value;
  }
  header.components = integers[1];
  header.records = integers[2];
  return header;
}

/// A field of more components than a tensor has.
bool is_wide(std::size_t components) {
  constexpr std::size_t usual = 9;
  return components > usual;
}

/// The table of all values costs much more memory than the section has bytes.
bool is_wasteful(const FieldHeader& header, std::size_t places) {
  return is_wide(header.components) && 2 * header.records < places;
}

/// The text without control characters, which a line cannot hold.
std::string on_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
  return text;
}

/// Whether a point or a triangle has a value.
bool is_present(const Field& field, std::size_t i) {
  const auto values = field.values.span().subspan(i * field.components, field.components);
  return std::ranges::any_of(values, [](double value) { return !std::isnan(value); });
}

void write_field(MshRows& out, const Field& field, std::size_t step, const std::function<std::size_t(Index)>& tag) {
  const bool of_points = field.place == Field::Place::points;
  const std::size_t places = field.values.size() / field.components;
  std::vector<Index> present;
  for (std::size_t i = 0; i < places; ++i)
    if (is_wide(field.components) || is_present(field, i)) present.push_back(static_cast<Index>(i));
  const std::string_view section = of_points ? "NodeData" : "ElementData";
  out.open(section);
  out.text(Bytes() << "1\n\"" << on_one_line(field.name) << "\"\n1\n"
                   << field.time << "\n3\n"
                   << step << '\n'
                   << field.components << '\n'
                   << present.size() << '\n');
  out.rows_of_values(present.size(), field.components, [&](std::size_t i) {
    return std::pair(static_cast<int>(tag(present[i])), &field.values[present[i] * field.components]);
  });
  out.close(section);
}

}  // namespace

void MshTriangles::add(std::size_t tag, Index triangle) {
  if (!runs_.empty()) {
    Run& last = runs_.back();
    if (tag == last.tag + last.n && triangle == last.first + last.n) {
      ++last.n;
      return;
    }
  }
  runs_.push_back({tag, 1, triangle});
}

void MshTriangles::sort() { std::ranges::sort(runs_, {}, &Run::tag); }

Index MshTriangles::find(std::size_t tag) const {
  const auto beyond = std::ranges::upper_bound(runs_, tag, {}, &Run::tag);
  if (beyond == runs_.begin()) return no_index;
  const Run& run = *(beyond - 1);
  return tag - run.tag < run.n ? run.first + static_cast<Index>(tag - run.tag) : no_index;
}

std::optional<Field> read_msh_field(TextReader& in, MshSource& source, const MshPlaces& places, LeftOut& left_out) {
  const bool of_points = places.place == Field::Place::points;
  const std::string_view record = of_points ? "node" : "element";
  const std::string a_tag = of_points ? "a node's tag" : "an element's tag";
  const std::string a_value = of_points ? "a value at a node" : "a value in an element";
  FieldHeader header = read_field_header(in);
  // In binary, the tag takes four bytes only.
  if (in.failed() || header.integers < 3 || header.components == 0 || header.components > any_tag ||
      !source.room_for(header.records, header.components, of_points ? "values at nodes" : "values in elements")) {
    in.fail("expected the number of values per " + std::string(record) + " and the number of " + std::string(record) +
            "s");
    return {};
  }
  const bool is_read = !is_wasteful(header, places.count);
  if (!is_read) left_out.add("the field " + in_quotes(header.name) + ", which has very many values at few places");
  Field field{std::move(header.name), places.place, header.components, {}, header.time};
  if (is_read) field.values.resize(places.count * field.components, std::numeric_limits<double>::quiet_NaN());
  source.open_section();
  for (std::size_t i = 0; i < header.records && source.record(record, i, header.records); ++i) {
    const Index place = places.of_tag(static_cast<std::size_t>(source.integer(a_tag, 1, any_tag)));
    if (place == no_index && !of_points) left_out.add("values in elements that are not triangles");
    for (std::size_t k = 0; k < field.components && !in.failed(); ++k) {
      const double value = source.any_number(a_value);
      if (is_read && place != no_index) field.values[place * field.components + k] = value;
    }
  }
  if (in.failed() || !is_read) return {};
  return field;
}

void write_fields(MshRows& out, const std::vector<Field>& fields, const std::function<std::size_t(Index)>& point_tag,
                  const std::function<std::size_t(Index)>& triangle_tag) {
  for (auto field = fields.begin(); field != fields.end(); ++field) {
    const auto is_step = [&](const Field& other) { return other.name == field->name && other.place == field->place; };
    const auto step = static_cast<std::size_t>(std::count_if(fields.begin(), field, is_step));
    write_field(out, *field, step, field->place == Field::Place::points ? point_tag : triangle_tag);
  }
}

}  // namespace pardel::files
