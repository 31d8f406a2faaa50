// SMS's 2DM, as SMS, TUFLOW FV and BASEMENT read it. A line is a card: MESH2D, NUM_MATERIALS_PER_ELEM N, E3T ID A B C
// MATERIAL, ND ID X Y Z, NS A B ... -Z [ID]: a nodestring, which goes on over several lines until a negative number.
// Other cards that are no elements are ignored. Nodes may follow the elements that refer to them.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>

#include "../formats.hpp"
#include "../neighbours.hpp"
#include "chains.hpp"
#include "mesh_readers.hpp"
#include "msh_model.hpp"
#include "msh_source.hpp"
#include "triangle_sections.hpp"

namespace pardel {
using namespace files;
namespace {

constexpr std::int64_t largest_number = std::numeric_limits<std::int32_t>::max();

/// Cards of elements: E and a digit, as in E4Q.
bool is_element(std::string_view card) {
  return card.size() >= 2 && card[0] == 'E' && card[1] >= '0' && card[1] <= '9';
}

/// Reads the text twice: first the nodes, then what refers to them.
class TwoDmReader {
 public:
  TwoDmReader(std::string_view text, const std::string& name, StopSignal* stop)
      : text_(text), name_(name), stop_(stop) {}

  Result<Mesh> read() {
    TextReader nodes = each_card([&](TextReader& in, std::string_view card) {
      if (card == "ND") read_node(in);
    });
    if (nodes.failed()) return nodes.error();
    sort_nodes(nodes);
    if (nodes.failed()) return nodes.error();
    TextReader rest = each_card([&](TextReader& in, std::string_view card) {
      if (card == "NS") return read_nodestring(in);
      end_nodestring(in);
      if (card == "E3T") return read_triangle(in);
      if (card == "NUM_MATERIALS_PER_ELEM")
        materials_ = in.integer("the number of materials per element", 0, largest_number);
      if (is_element(card)) in.fail("elements of type " + in_quotes(card) + " are not read, only triangles (E3T)");
    });
    take_numbers_of_triangles(rest);
    if (rest.failed()) return rest.error();
    if (materials_ > 0) set_regions(mesh_, attributes_.span());
    rebuild_neighbours(mesh_.triangles, mesh_.points.size(), stop_);
    return std::move(mesh_);
  }

 private:
  /// Calls read(in, card) for each line after the first one.
  template <class Read>
  TextReader each_card(const Read& read) {
    TextReader in(text_, name_, stop_);
    in.expect_line("MESH2D");
    in.expect_word("MESH2D");
    while (in.next_line()) read(in, in.word());
    if (!in.failed()) end_nodestring(in);
    return in;
  }

  void read_node(TextReader& in) {
    const auto id = static_cast<std::size_t>(in.integer("a node's number", 1, largest_number));
    const double x = in.number("an x coordinate");
    const double y = in.number("a y coordinate");
    nodes_.add(id, {x, y});
    heights_.push_back({id, in.has_field() ? in.number("a z coordinate") : 0});
  }

  void sort_nodes(TextReader& in) {
    nodes_.sort();
    std::ranges::sort(heights_);
    if (const std::size_t id = nodes_.repeated()) in.fail("two nodes have the number " + std::to_string(id));
    if (nodes_.size() > max_points) in.fail("has more nodes than a mesh can hold");
    mesh_.points.resize(nodes_.size());
    mesh_.attributes_per_point = nodes_.size() > 0 ? 1 : 0;
    mesh_.point_attributes.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      mesh_.points[i] = nodes_[i];
      mesh_.point_attributes[i] = heights_[i].second;
    }
    mesh_.first_id = {1};
    mesh_.numbers = nodes_.numbers();
  }

  Index node(TextReader& in, std::int64_t id) {
    const Index index = nodes_.find(static_cast<std::size_t>(id));
    if (index == no_index) in.fail("there is no node " + std::to_string(id));
    return index;
  }

  void read_triangle(TextReader& in) {
    numbers_.push_back(static_cast<std::uint64_t>(in.integer("an element's number", 1, largest_number)));
    Triangle triangle;
    for (Index& corner : triangle.v) corner = node(in, in.integer("a node's number", 1, largest_number));
    mesh_.triangles.push_back(triangle);
    attributes_.push_back(
        materials_ > 0 ? static_cast<double>(in.integer("a material", -largest_number, largest_number)) : 0);
    if (!can_be_a_mesh(mesh_.triangles.size())) in.fail("has more triangles than a mesh can hold");
  }

  void take_numbers_of_triangles(TextReader& in) {
    if (std::ranges::is_sorted(numbers_, std::ranges::less_equal())) {  // nearly all files
      if (numbers_.empty() || numbers_.back() == numbers_.size()) return;
    } else {
      std::vector<std::uint64_t> sorted = numbers_;
      std::ranges::sort(sorted);
      const auto twice = std::ranges::adjacent_find(sorted);
      if (twice != sorted.end()) in.fail("two triangles have the number " + std::to_string(*twice));
    }
    mesh_.numbers.of_triangles = std::move(numbers_);
  }

  void read_nodestring(TextReader& in) {
    while (in.has_field()) {
      const std::int64_t id = in.integer("a node's number", -largest_number, largest_number);
      nodestring_.push_back(node(in, std::abs(id)));
      if (in.failed()) return;
      if (id < 0) return finish_nodestring(in.word());
    }
  }

  /// A nodestring without a name has its number as its marker, and so has one with a name that is no marker.
  void finish_nodestring(std::string_view name) {
    ++nodestrings_;
    int marker = nodestrings_;
    if (int value = 0;
        std::from_chars(name.data(), name.data() + name.size(), value).ptr == name.data() + name.size() &&
        !name.empty())
      marker = value;
    for (std::size_t i = 0; i + 1 < nodestring_.size(); ++i)
      mesh_.constrained_edges.push_back({nodestring_[i], nodestring_[i + 1], no_index, marker});
    nodestring_.clear();
  }

  void end_nodestring(TextReader& in) {
    if (!nodestring_.empty()) in.fail("the nodestring before this line has no end, a negative number");
  }

  std::string_view text_;
  const std::string& name_;
  StopSignal* stop_;
  MshNodes nodes_;
  std::vector<std::pair<std::size_t, double>> heights_;  ///< z of each node, with its number
  std::int64_t materials_ = 1;                           ///< per element
  std::vector<std::uint64_t> numbers_;                   ///< of the triangles
  Array<double> attributes_;                             ///< the materials of the triangles
  Chain nodestring_;                                     ///< the part that has been read
  int nodestrings_ = 0;
  Mesh mesh_;
};

/// The number of the material of each triangle.
Array<int> materials_of(const Mesh& mesh, const MshModel& model) {
  Array<int> materials(mesh.triangles.size());
  for (std::size_t s = 0; s < model.surfaces.size(); ++s)
    for (const Index t : model.triangles[s]) materials[t] = model.surfaces[s].tag;
  return materials;
}

/// A nodestring in lines of ten nodes.
void put_nodestring(Bytes& to, const Chain& chain, int marker) {
  constexpr std::size_t per_line = 10;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    if (i % per_line == 0) to << (i > 0 ? "\nNS" : "NS");
    const std::int64_t id = std::int64_t{chain[i]} + 1;
    to << ' ' << (i + 1 < chain.size() ? id : -id);
  }
  to << ' ' << marker << '\n';
}

}  // namespace

Result<Mesh> files::parse_2dm(std::string_view text, const std::string& name, StopSignal* stop) {
  return TwoDmReader(text, name, stop).read();
}

Status write_2dm(const Mesh& mesh, const std::filesystem::path& file, const GoOn& go_on) {
  OutputFile out(file, go_on);
  const MshModel model = msh_model(mesh, values_of(mesh));
  const Array<int> materials = materials_of(mesh, model);
  out.write("MESH2D\nNUM_MATERIALS_PER_ELEM 1\n");
  write_records(out, mesh.triangles.size(), [&](Bytes& to, std::size_t t) {
    const auto& v = mesh.triangles[t].v;
    (to << "E3T ")
            .numbers(t + 1, std::uint64_t{v[0]} + 1, std::uint64_t{v[1]} + 1, std::uint64_t{v[2]} + 1, materials[t])
        << '\n';
  });
  const std::size_t k = mesh.attributes_per_point;
  write_records(out, mesh.points.size(), [&](Bytes& to, std::size_t i) {
    const Point& p = mesh.points[i];
    (to << "ND ").numbers(i + 1, p.x, p.y, k > 0 ? mesh.point_attributes[i * k] : 0.0) << '\n';
  });
  for (std::size_t c = 0; c < model.curves.size(); ++c) {
    std::vector<EdgeEnds> edges;
    for (const Index e : model.lines[c]) edges.push_back({mesh.constrained_edges[e].a, mesh.constrained_edges[e].b});
    if (edges.empty()) continue;
    const int marker = mesh.constrained_edges[model.lines[c][0]].marker;
    const std::vector<Chain> chains = chains_of(edges);
    write_records(out, chains.size(), [&](Bytes& to, std::size_t i) { put_nodestring(to, chains[i], marker); });
  }
  return out.commit();
}

}  // namespace pardel
