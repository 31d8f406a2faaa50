// Reads Gmsh's MSH: versions 4.1 and 2.x, in ASCII and binary. Triangles become the mesh, lines become its
// constrained edges. A physical group named `region X` or `marker N` gives the attribute X or the marker N; a group
// `domain` means no region; any other group gives its tag, and its name is kept. Vertices are in the order of their
// tags; z is ignored. $NodeData and $ElementData are fields. Of a partitioned mesh, ghost elements and the lines on
// interfaces of partitions are left out. Of elements of second order the corners are read.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "../neighbours.hpp"
#include "group_names.hpp"
#include "mesh_readers.hpp"
#include "middles.hpp"
#include "msh_fields.hpp"
#include "msh_rows.hpp"
#include "msh_source.hpp"
#include "triangle_sections.hpp"

namespace pardel::files {
namespace {

constexpr double no_region = std::numeric_limits<double>::quiet_NaN();

/// A type of elements. Its first nodes are the corners, the others middles of edges.
struct ElementType {
  std::int64_t dimension = 0;
  std::size_t corners = 0;  ///< 0 for types that a plane mesh of triangles cannot contain
  std::size_t nodes = 0;
};
ElementType element_type(std::int64_t type) {
  constexpr int point = 15;
  if (type == msh_line) return {1, 2, 2};
  if (type == msh_triangle) return {2, 3, 3};
  if (type == msh_line_of_3) return {1, 2, 3};
  if (type == msh_triangle_of_6) return {2, 3, 6};
  return type == point ? ElementType{0, 1, 1} : ElementType{};
}

class MshReader {
 public:
  /// `partition`: of the file that is read, 0 for a file of a whole mesh.
  MshReader(std::string_view text, const std::string& name, int partition, StopSignal* stop)
      : in_(text, name, stop), source_(in_), partition_(partition), stop_(stop) {}

  Result<MshPiece> read() {
    in_.expect_line("$MeshFormat");
    if (const std::string_view word = in_.word(); word != "$MeshFormat") {
      in_.fail("expected $MeshFormat, found " + in_quotes(word));
    }
    read_format();
    while (in_.next_line()) read_section(in_.word());
    const bool may_be_empty = partitions_ > 1 && !has_partitioned_entities_;
    if (!in_.failed() && !has_nodes_ && !may_be_empty) in_.fail("expected $Nodes, found the end of the file");
    if (!in_.failed() && !has_elements_ && (has_nodes_ || !may_be_empty))
      in_.fail("expected $Elements, found the end of the file");
    if (in_.failed()) return in_.error();
    mesh_.points.resize(nodes_.size());
    Array<std::uint64_t> number(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      mesh_.points[i] = nodes_[i];
      number[i] = nodes_.tag(i) - 1;
    }
    mesh_.first_id = {1};
    mesh_.numbers = nodes_.numbers();
    if (!is_middle_.empty()) leave_out_middles(number);
    const auto has_region = [](double attribute) { return !std::isnan(attribute); };
    if (std::any_of(attributes_.begin(), attributes_.end(), has_region)) set_regions(mesh_, attributes_.span());
    rebuild_neighbours(mesh_.triangles, mesh_.points.size(), stop_);
    return MshPiece{{std::move(mesh_), std::move(number)}, partitions_};
  }

 private:
  void leave_out_middles(Array<std::uint64_t>& number) {
    is_middle_.resize(mesh_.points.size());
    const std::vector<Index> kept = remove_middles(mesh_, std::move(is_middle_));
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (kept[i] != no_index) number[kept[i]] = number[i];
    number.resize(mesh_.points.size());
  }

  void read_format() {
    in_.expect_line("the version of the format");
    version_ = in_.number("the version of the format");
    const bool binary = in_.integer("0 for ASCII or 1 for binary", 0, 1) == 1;
    in_.integer("the size of a number, 8", 8, 8);
    const bool version_2 = version_ >= 2 && version_ < 3;
    if (!version_2 && version_ != 4.1) in_.fail("expected version 4.1 or 2.x of the format");
    if (binary) {
      source_.set_binary();
      source_.open_section();
      if (source_.integer("the number 1 as bytes", std::numeric_limits<int>::min(), std::numeric_limits<int>::max()) !=
          1) {
        in_.fail("the file was written in another byte order than this machine's");
      }
    }
    expect_end("$EndMeshFormat");
  }

  void read_section(std::string_view section) {
    if (section == "$PhysicalNames") return read_names();
    if (section == "$Entities" && version_ > 4) return read_entities();
    if (section == "$PartitionedEntities" && version_ > 4) return read_partitioned_entities();
    if (section == "$Nodes") return version_ > 4 ? read_nodes() : read_nodes_2(false);
    if (section == "$ParametricNodes" && version_ < 4) return read_nodes_2(true);
    if (section == "$Elements") return version_ > 4 ? read_elements() : read_elements_2();
    if (section == "$NodeData" && has_nodes_)
      return read_field(section,
                        {Field::Place::points, nodes_.size(), [&](std::size_t tag) { return nodes_.find(tag); }});
    if (section == "$ElementData" && has_elements_)
      return read_field(section, {Field::Place::triangles, mesh_.triangles.size(),
                                  [&](std::size_t tag) { return triangles_.find(tag); }});
    if (!section.starts_with('$')) return in_.fail("expected a section, found " + in_quotes(section));
    if (!is_of_mesh(section)) mesh_.left_out.add("the section " + std::string(section));
    const std::string end = "$End" + std::string(section.substr(1));
    const std::size_t at = in_.rest().find("\n" + end);
    if (at == std::string_view::npos) return in_.fail("the section " + in_quotes(section) + " does not end");
    in_.skip(at + 1 + end.size());
  }

  /// Sections that are not read, and whose content the mesh has anyway, or does not need.
  static bool is_of_mesh(std::string_view section) {
    return section == "$GhostElements" || section == "$Entities" || section == "$PartitionedEntities";
  }

  void read_field(std::string_view section, const MshPlaces& places) {
    if (std::optional<Field> field = read_msh_field(in_, source_, places, mesh_.left_out); field)
      mesh_.fields.push_back(std::move(*field));
    expect_end("$End" + std::string(section.substr(1)));
  }

  void expect_end(std::string_view name) {
    in_.expect_line(name);
    if (const std::string_view word = in_.word(); word != name) {
      in_.fail("expected " + std::string(name) + ", found " + in_quotes(word));
    }
  }

  /// Reads `dimension tag "name"` per line. These lines are text in ASCII and in binary files.
  void read_names() {
    in_.expect_line("the number of physical names");
    const std::size_t n = in_.count("the number of physical names");
    for (std::size_t i = 0; i < n && in_.expect_record("physical name", i, n); ++i) {
      const std::int64_t dimension = in_.integer("a dimension", 0, 3);
      const std::int64_t tag = in_.integer("a physical tag", -any_marker_high, any_marker_high);
      std::string_view name = in_.rest_of_line();
      if (name.size() >= 2 && name.front() == '"' && name.back() == '"') name = name.substr(1, name.size() - 2);
      note_group(dimension, tag, name);
    }
    expect_end("$EndPhysicalNames");
  }

  void note_group(std::int64_t dimension, std::int64_t tag, std::string_view name) {
    if (dimension == 0 || dimension == 3) return mesh_.left_out.add("the names of physical points and volumes");
    const auto of = dimension == 2 ? GroupName::Of::region : GroupName::Of::marker;
    value_[{dimension, tag}] = value_of_group(of, name, static_cast<double>(tag)).value;
    if (tag < 1 || !is_group_name(of, name)) return;
    std::erase_if(mesh_.names, [&](const GroupName& other) { return other.of == of && other.value == tag; });
    mesh_.names.push_back({of, static_cast<int>(tag), std::string(name)});
  }

  void read_entities() {
    source_.open_section();
    read_entities_by_dimension([](int, std::int64_t) {});
    expect_end("$EndEntities");
  }

  /// The number of partitions, the ghost entities, and entities that also have a parent and the partitions to which
  /// they belong.
  void read_partitioned_entities() {
    source_.open_section();
    source_.row("the number of partitions");
    partitions_ = source_.size("the number of partitions");
    source_.row("the number of ghost entities");
    const std::size_t ghosts = source_.size("the number of ghost entities");
    for (std::size_t i = 0; i < ghosts && !in_.failed(); ++i) {
      source_.row("a ghost entity");
      const std::int64_t tag = source_.integer("an entity's tag", any_marker_low, any_marker_high);
      source_.integer("a partition", 1, any_marker_high);
      left_out_.insert({2, tag});
    }
    read_entities_by_dimension([&](int dimension, std::int64_t tag) {
      has_partitioned_entities_ = true;
      const std::int64_t parent_dimension = source_.integer("the dimension of a parent", 0, 3);
      source_.integer("a parent's tag", any_marker_low, any_marker_high);
      const std::size_t count = source_.size("the number of partitions of an entity");
      std::int64_t least = any_marker_high;
      for (std::size_t k = 0; k < count && !in_.failed(); ++k)
        least = std::min(least, source_.integer("a partition", 1, any_marker_high));
      // What several files have is taken from the first of them.
      const bool is_elsewhere = partition_ != 0 && count > 1 && least != partition_;
      if (dimension == 1 && (parent_dimension != 1 || is_elsewhere)) left_out_.insert({dimension, tag});
    });
    expect_end("$EndPartitionedEntities");
  }

  /// Per entity: its tag, what read_more(dimension, tag) reads, a point or a box, its physical tags and, except for
  /// points, the entities on its boundary.
  template <class ReadMore>
  void read_entities_by_dimension(const ReadMore& read_more) {
    source_.row("the numbers of entities");
    std::array<std::size_t, 4> n{};
    for (std::size_t& count : n) count = source_.size("a number of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (std::size_t i = 0; i < n[dimension] && !in_.failed(); ++i) {
        source_.row("an entity");
        const std::int64_t tag = source_.integer("an entity's tag", any_marker_low, any_marker_high);
        read_more(dimension, tag);
        for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) source_.number("an entity's coordinate");
        const std::size_t physicals = source_.size("the number of physical tags");
        for (std::size_t k = 0; k < physicals && !in_.failed(); ++k) {
          const std::int64_t physical = source_.integer("a physical tag", -any_marker_high, any_marker_high);
          if (k == 0) physical_[{dimension, tag}] = std::abs(physical);  // a negative tag means: reversed in the group
          if (k == 1) mesh_.left_out.add("all physical groups of an entity but the first");
        }
        if (dimension == 0) continue;
        const std::size_t bounds = source_.size("the number of bounding entities");
        for (std::size_t k = 0; k < bounds && !in_.failed(); ++k) {
          source_.integer("a bounding entity", any_marker_low, any_marker_high);
        }
      }
    }
  }

  void read_nodes() {
    source_.open_section();
    source_.row("the numbers of node blocks and nodes");
    const std::size_t blocks = source_.size("the number of node blocks");
    const std::size_t n = source_.size("the number of nodes");
    source_.size("the least tag");
    source_.size("the greatest tag");
    if (n > max_points) in_.fail("announces more nodes than a mesh can hold");
    Array<std::size_t> tags;
    std::size_t found = 0;
    for (std::size_t b = 0; b < blocks && !in_.failed(); ++b) {
      source_.row("a node block");
      const std::int64_t dimension = source_.integer("a dimension", 0, 3);
      const std::int64_t entity = source_.integer("an entity's tag", any_marker_low, any_marker_high);
      const bool is_ghost = dimension == 2 && left_out_.contains({dimension, entity});
      const bool parametric = source_.integer("0 or 1", 0, 1) == 1;
      const std::size_t in_block = source_.size("the number of nodes in the block");
      if (!source_.room_for(in_block, 4, "nodes")) return;
      found += in_block;
      tags.clear();
      for (std::size_t i = 0; i < in_block && !in_.failed(); ++i) {
        source_.row("a node's tag");
        tags.push_back(node_tag());
      }
      for (std::size_t i = 0; i < in_block && !in_.failed(); ++i) {
        source_.row("a node's coordinates");
        const Point point = read_point();
        if (!is_ghost) nodes_.add(tags[i], point);
        if (parametric) read_parameters(dimension);
      }
    }
    finish_nodes(n, found);
  }

  void read_parameters(std::int64_t n) {
    for (std::int64_t k = 0; k < n; ++k) source_.number("a node's parameter");
    if (n > 0) mesh_.left_out.add("parameters of nodes");
  }

  std::size_t node_tag() {
    const std::size_t tag = source_.size("a node's tag");
    if (tag == 0) in_.fail("expected a node's tag greater than 0");
    return tag;
  }

  Point read_point() {
    const double x = source_.number("an x coordinate");
    const double y = source_.number("a y coordinate");
    source_.number("a z coordinate");
    return {x, y};
  }

  void finish_nodes(std::size_t announced, std::size_t found, std::string_view end = "$EndNodes") {
    has_nodes_ = true;
    nodes_.sort();
    if (found != announced) {
      in_.fail("expected " + std::to_string(announced) + " nodes, found " + std::to_string(found));
    }
    if (const std::size_t tag = nodes_.repeated()) in_.fail("two nodes have the tag " + std::to_string(tag));
    expect_end(end);
  }

  void read_elements() {
    source_.open_section();
    source_.row("the numbers of element blocks and elements");
    const std::size_t blocks = source_.size("the number of element blocks");
    const std::size_t n = source_.size("the number of elements");
    source_.size("the least tag");
    source_.size("the greatest tag");
    std::size_t found = 0;
    for (std::size_t b = 0; b < blocks && !in_.failed(); ++b) {
      source_.row("an element block");
      const std::int64_t dimension = source_.integer("a dimension", 0, 3);
      const std::int64_t entity = source_.integer("an entity's tag", any_marker_low, any_marker_high);
      const ElementType type = read_type();
      const std::size_t in_block = source_.size("the number of elements in the block");
      if (!source_.room_for(in_block, 1 + type.nodes, "elements")) return;
      const bool is_left_out = left_out_.contains({dimension, entity});
      const auto physical = physical_.find({dimension, entity});
      const double value = physical == physical_.end() ? no_region : group_value(dimension, physical->second);
      for (std::size_t i = 0; i < in_block && !in_.failed(); ++i) {
        source_.row("an element");
        const std::size_t tag = source_.size("an element's tag");
        if (is_left_out) {
          for (std::size_t k = 0; k < type.nodes; ++k) source_.size("a node's tag");
        } else {
          read_corners(tag, type, value);
        }
      }
      found += in_block;
    }
    finish_elements(n, found);
  }

  ElementType read_type() {
    const std::int64_t number = source_.integer("an element's type", 1, any_marker_high);
    const ElementType type = element_type(number);
    if (type.corners == 0) {
      in_.fail("an element is of type " + std::to_string(number) +
               ", neither a line (1) nor a triangle (2) nor a point (15)");
    }
    return type;
  }

  double group_value(std::int64_t dimension, std::int64_t physical) const {
    const auto named = value_.find({dimension, physical});
    return named != value_.end() ? named->second : static_cast<double>(physical);
  }

  /// Reads the nodes of the element with this tag, whose attribute or marker is `value`.
  void read_corners(std::size_t element, const ElementType& type, double value) {
    std::array<Index, 6> v{};
    for (std::size_t i = 0; i < type.nodes; ++i) {
      const std::size_t tag = version_ > 4
                                  ? source_.size("a node's tag")
                                  : static_cast<std::size_t>(source_.integer("a node's tag", 0, any_marker_high));
      v[i] = nodes_.find(tag);
      if (v[i] == no_index) in_.fail("there is no node " + std::to_string(tag));
    }
    if (in_.failed()) return;
    if (type.nodes > type.corners) is_middle_.resize(nodes_.size());
    for (std::size_t i = type.corners; i < type.nodes; ++i) {
      const auto node = [&](std::size_t k) { return NumberedNode{nodes_.tag(v[k]), nodes_[v[k]]}; };
      const std::size_t from = i - type.corners;
      const std::string fault = why_curved(node(i), node(from), node((from + 1) % type.corners));
      if (!fault.empty()) return in_.fail("element " + std::to_string(element) + ": " + fault);
      is_middle_[v[i]] = 1;
    }
    if (type.corners == 3) {
      triangles_.add(element, static_cast<Index>(mesh_.triangles.size()));
      mesh_.triangles.push_back({{v[0], v[1], v[2]}, {no_index, no_index, no_index}});
      attributes_.push_back(value);
    } else if (type.corners == 2) {
      mesh_.constrained_edges.push_back({v[0], v[1], no_index, std::isnan(value) ? 0 : static_cast<int>(value)});
    }
  }

  void finish_elements(std::size_t announced, std::size_t found) {
    has_elements_ = true;
    triangles_.sort();
    if (found != announced) {
      in_.fail("expected " + std::to_string(announced) + " elements, found " + std::to_string(found));
    }
    if (!can_be_a_mesh(mesh_.triangles.size())) in_.fail("more triangles than a mesh can hold");
    expect_end("$EndElements");
  }

  /// Version 2: `tag x y z`, in $ParametricNodes also `dimension entity` and as many parameters as a curve (1) or a
  /// surface (2) has. The number of nodes is text, also in binary files.
  void read_nodes_2(bool parametric) {
    in_.expect_line("the number of nodes");
    const std::size_t n = in_.count("the number of nodes");
    if (n > max_points) in_.fail("announces more nodes than a mesh can hold");
    source_.open_section();
    for (std::size_t i = 0; i < n && source_.record("node", i, n); ++i) {
      const auto tag = static_cast<std::size_t>(source_.integer("a node's tag", 1, any_marker_high));
      nodes_.add(tag, read_point());
      if (!parametric) continue;
      const std::int64_t dimension = source_.integer("the dimension of a node's entity", 0, 3);
      source_.integer("an entity's tag", any_marker_low, any_marker_high);
      read_parameters(dimension < 3 ? dimension : 0);
    }
    finish_nodes(n, nodes_.size(), parametric ? "$EndParametricNodes" : "$EndNodes");
  }

  /// Version 2: `tag type number-of-tags tags... corners`. In binary files, type and number of tags are given once for
  /// several elements: `type number-of-elements number-of-tags`, then for each element `tag tags... corners`.
  void read_elements_2() {
    in_.expect_line("the number of elements");
    const std::size_t n = in_.count("the number of elements");
    source_.open_section();
    std::size_t found = 0;
    while (found < n && source_.record("element", found, n)) found += read_block_2();
    finish_elements(n, found);
  }

  /// Reads one element or, in a binary file, several. Returns their number, at least 1.
  std::size_t read_block_2() {
    std::int64_t tag = source_.binary() ? 0 : source_.integer("an element's tag", 0, any_marker_high);
    const ElementType type = read_type();
    const std::int64_t in_block =
        source_.binary() ? source_.integer("the number of elements in the block", 1, any_marker_high) : 1;
    const std::int64_t tags = source_.integer("the number of tags", 0, any_marker_high);
    for (std::int64_t i = 0; i < in_block && !in_.failed(); ++i) {
      if (source_.binary()) tag = source_.integer("an element's tag", 0, any_marker_high);
      read_element_2(static_cast<std::size_t>(tag), type, tags);
    }
    return static_cast<std::size_t>(in_block);
  }

  /// The first tag is the physical group, 0 for none.
  void read_element_2(std::size_t element, const ElementType& type, std::int64_t tags) {
    std::int64_t physical = 0;
    for (std::int64_t k = 0; k < tags && !in_.failed(); ++k) {
      const std::int64_t tag = source_.integer("a tag", -any_marker_high, any_marker_high);
      if (k == 0) physical = std::abs(tag);
    }
    read_corners(element, type, physical == 0 ? no_region : group_value(type.dimension, physical));
  }

  using Key = std::pair<std::int64_t, std::int64_t>;  ///< dimension and tag

  TextReader in_;
  MshSource source_;
  int partition_;
  StopSignal* stop_;
  std::size_t partitions_ = 1;
  bool has_partitioned_entities_ = false;
  double version_ = 0;
  std::map<Key, double> value_;           ///< the values of curves and surfaces that have a name
  std::map<Key, std::int64_t> physical_;  ///< the first physical group of each entity
  std::set<Key> left_out_;                ///< entities whose elements are not read
  MshNodes nodes_;
  MshTriangles triangles_;
  bool has_nodes_ = false;
  bool has_elements_ = false;
  Array<double> attributes_;     ///< one per triangle
  std::vector<char> is_middle_;  ///< per node: 1 for the middle of an edge; empty if there are none
  Mesh mesh_;
};

}  // namespace

Result<Mesh> parse_msh(std::string_view text, const std::string& name, StopSignal* stop) {
  Result<MshPiece> whole = MshReader(text, name, 0, stop).read();
  if (!whole) return whole.error();
  return std::move(whole->mesh);
}

Result<MshPiece> parse_msh_piece(std::string_view text, const std::string& name, int partition, StopSignal* stop) {
  return MshReader(text, name, partition, stop).read();
}

}  // namespace pardel::files
