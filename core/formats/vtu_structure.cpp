// The elements of a VTU file: where each array is, and how it is written.
#include <algorithm>
#include <bit>
#include <charconv>

#include "text_reader.hpp"
#include "vtu_arrays.hpp"

namespace pardel::files {
namespace {

/// The integer in the text; -1 if the text is not an integer; `otherwise` if the text is empty.
std::int64_t whole(std::string_view text, std::int64_t otherwise) {
  if (text.empty()) return otherwise;
  std::int64_t value = 0;
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc() && stop == text.data() + text.size() && value >= 0 ? value : -1;
}

bool is_section(std::string_view name) {
  return name == "Points" || name == "Cells" || name == "CellData" || name == "PointData" || name == "FieldData";
}

}  // namespace

Error VtuFile::error_at(std::size_t at, const std::string& message) const {
  const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n');
  return {ErrorKind::invalid_input, name_ + ":" + std::to_string(line) + ": " + message};
}

std::optional<Error> VtuFile::read_root(const XmlTag& tag, std::size_t at) {
  constexpr std::string_view native = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  if (tag["type"] != "UnstructuredGrid") {
    return error_at(at, "expected type=\"UnstructuredGrid\", found " + in_quotes(tag["type"]));
  }
  if (!tag["byte_order"].empty() && tag["byte_order"] != native) {
    return error_at(at, "expected byte_order=\"" + std::string(native) + "\", found " + in_quotes(tag["byte_order"]));
  }
  compressed_ = !tag["compressor"].empty();
  if (compressed_ && tag["compressor"] != "vtkZLibDataCompressor") {
    return error_at(at, "expected no compressor or vtkZLibDataCompressor, found " + in_quotes(tag["compressor"]));
  }
  if (tag["header_type"] == "UInt64") header_bytes_ = 8;
  found_root_ = true;
  return std::nullopt;
}

std::optional<Error> VtuFile::read_piece(const XmlTag& tag, std::size_t at) {
  const std::int64_t points = whole(tag["NumberOfPoints"], -1);
  const std::int64_t cells = whole(tag["NumberOfCells"], -1);
  if (points < 0) return error_at(at, "expected the number of points, found " + in_quotes(tag["NumberOfPoints"]));
  if (cells < 0) return error_at(at, "expected the number of cells, found " + in_quotes(tag["NumberOfCells"]));
  pieces_.push_back({static_cast<std::size_t>(points), static_cast<std::size_t>(cells)});
  return std::nullopt;
}

/// Sets `at` to the end of the content of the array.
std::optional<Error> VtuFile::read_array(const XmlTag& tag, std::string_view section, std::size_t& at) {
  const std::int64_t components = whole(tag["NumberOfComponents"], 1);
  const std::int64_t offset = whole(tag["offset"], 0);
  if (components < 1)
    return error_at(at, "expected a number of components, found " + in_quotes(tag["NumberOfComponents"]));
  if (offset < 0) return error_at(at, "expected an offset, found " + in_quotes(tag["offset"]));
  VtuArray array{pieces_.empty() ? 0 : pieces_.size() - 1,
                 section,
                 tag["Name"],
                 tag["type"],
                 tag["format"],
                 static_cast<std::size_t>(components),
                 static_cast<std::size_t>(offset),
                 tag.end,
                 tag.end};
  if (!tag.closed) {
    const std::size_t close = text_.find("</DataArray", tag.end);
    if (close == std::string_view::npos) return error_at(at, "this DataArray does not end");
    // VTK writes inner elements (InformationKey) after the values, other programs before them.
    const std::size_t inner = text_.find('<', tag.end);
    const bool values_first = text_.find_first_not_of(xml_blanks, tag.end) < inner;
    array.begin = values_first ? tag.end : std::max(tag.end, text_.rfind('>', close) + 1);
    array.end = values_first ? inner : close;
    at = close;
  } else {
    at = tag.end;
  }
  arrays_.push_back(array);
  return std::nullopt;
}

std::optional<Error> VtuFile::read_appended(const XmlTag& tag, std::size_t at) {
  appended_raw_ = tag["encoding"] == "raw";
  appended_ = text_.find('_', tag.end);
  if (appended_ == std::string_view::npos) return error_at(at, "expected appended data, found none");
  ++appended_;
  return std::nullopt;
}

Result<VtuFile> VtuFile::parse(std::string_view text, const std::string& name, StopSignal* stop) {
  VtuFile file;
  file.stop_ = stop;
  file.text_ = text;
  file.name_ = name;
  std::string_view section;
  for (std::size_t at = next_xml_tag(text, 0); at != std::string_view::npos; at = next_xml_tag(text, at)) {
    const XmlTag tag = xml_tag_at(text, at);
    std::size_t end = tag.end;
    std::optional<Error> error;
    if (tag.name == "VTKFile") {
      error = file.read_root(tag, at);
    } else if (tag.name == "Piece") {
      error = file.read_piece(tag, at);
    } else if (tag.name == "DataArray") {
      end = at;
      error = file.read_array(tag, section, end);
    } else if (tag.name == "AppendedData") {
      error = file.read_appended(tag, at);
      end = text.size();  // the rest is not XML
    } else if (is_section(tag.name)) {
      section = tag.name;
    }
    if (error) return *error;
    at = end;
  }
  if (!file.found_root_)
    return file.error_at(0, "expected a VTK file (<VTKFile type=\"UnstructuredGrid\" ...>), found none");
  if (file.pieces_.empty()) return file.error_at(0, "expected a <Piece>, found none");
  return file;
}

const VtuArray* VtuFile::find(std::size_t piece, std::string_view section, std::string_view name) const {
  for (const VtuArray& array : arrays_) {
    if ((array.piece == piece || section == "FieldData") && array.section == section &&
        (name.empty() || array.name == name))
      return &array;
  }
  return nullptr;
}

}  // namespace pardel::files
