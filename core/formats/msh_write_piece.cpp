// Writes the piece of a mesh that one rank has as Gmsh's MSH 4.1, one file per rank, as Gmsh does with the option
// Mesh.PartitionSplitMeshFiles. All files have the same physical groups and parent entities. The piece of rank r is
// partition r + 1. It has one partitioned entity per group, one for each set of partitions that share vertices, and a
// ghost entity with the triangles of other pieces around it.
#include <algorithm>
#include <deque>
#include <limits>
#include <map>
#include <string>

#include "../support/agree.hpp"
#include "../support/exchange_lists.hpp"
#include "../support/share_of_rank.hpp"
#include "ghost_triangles.hpp"
#include "msh_model.hpp"

namespace pardel {
using namespace files;
namespace {

/// The groups of the whole mesh. Collective.
MshModel shared_model(const Mesh& mesh, Ranks& ranks) {
  MshValues values = values_of(mesh);
  values.markers = distinct(concatenated(lists_of_all(values.markers, ranks)));
  values.attributes = distinct(concatenated(lists_of_all(values.attributes, ranks)));
  return msh_model(mesh, std::move(values));
}

/// The boxes of the groups become those in the whole mesh. Collective.
void unite_boxes(std::vector<MshGroup>& groups, Ranks& ranks) {
  std::vector<MshBox> boxes;
  boxes.reserve(groups.size());
  for (const MshGroup& group : groups) boxes.push_back(group.box);
  for (const std::vector<MshBox>& from : lists_of_all(boxes, ranks))
    for (std::size_t g = 0; g < groups.size(); ++g) groups[g].box.cover(from[g]);
}

/// Tags of partitioned entities of one dimension: positive numbers that are not tags of their parents.
class FreeTags {
 public:
  explicit FreeTags(const std::vector<MshGroup>& parents) {
    for (const MshGroup& parent : parents) taken_.push_back(parent.tag);
    std::ranges::sort(taken_);
  }
  /// Free tag number i, i >= 0.
  [[nodiscard]] int operator[](std::size_t i) const {
    std::size_t tag = i + 1;
    for (const int taken : taken_) {
      if (tag < static_cast<std::size_t>(taken)) break;
      ++tag;
    }
    return static_cast<int>(tag);
  }

 private:
  std::vector<int> taken_;
};

/// Sets of ranks whose pieces have vertices in common.
class Interfaces {
 public:
  using Set = std::vector<int>;
  /// Collective. All ranks get the same numbers for the sets.
  Interfaces(const RanksOfPoints& ranks_of_points, Ranks& ranks) : here_(ranks.rank()) {
    for (const Index v : ranks_of_points.points()) number_.emplace(set_of(ranks_of_points[v]), 0);
    std::vector<int> text;  // each set after its size
    for (const auto& [set, unused] : number_) {
      text.push_back(static_cast<int>(set.size()));
      text.insert(text.end(), set.begin(), set.end());
    }
    std::map<Set, std::size_t> all;
    const std::vector<int> texts = concatenated(lists_of_all(text, ranks));
    for (auto at = texts.begin(); at != texts.end();) {
      const int size = *at++;
      all.emplace(Set(at, at + size), 0);
      at += size;
    }
    std::size_t next = 0;
    for (auto& [set, number] : all) number = next++;
    for (auto& [set, number] : number_) number = all.at(set);
  }
  /// The sets with this rank, and their numbers.
  [[nodiscard]] const std::map<Set, std::size_t>& sets() const { return number_; }
  /// Which of sets() consists of these ranks and this one.
  [[nodiscard]] std::size_t place_of(std::span<const int> others) const {
    return static_cast<std::size_t>(std::distance(number_.begin(), number_.find(set_of(others))));
  }

 private:
  [[nodiscard]] Set set_of(std::span<const int> others) const {
    Set set(others.begin(), others.end());
    set.insert(std::ranges::upper_bound(set, here_), here_);
    return set;
  }
  int here_;
  std::map<Set, std::size_t> number_;
};

/// Vertices have their numbers in the whole mesh, plus 1. Lines and then triangles are numbered rank by rank.
struct TagsOfPiece {
  std::span<const std::uint64_t> number;
  std::uint64_t first_line, first_triangle;
  [[nodiscard]] std::size_t node(Index v) const { return number[v] + 1; }
  [[nodiscard]] std::size_t line(Index i) const { return first_line + i; }
  [[nodiscard]] std::size_t triangle(Index t) const { return first_triangle + t; }
};

/// The least and the largest of the values that are counted.
struct Limits {
  std::size_t count = 0, least = std::numeric_limits<std::size_t>::max(), most = 0;
  void add(std::size_t first, std::size_t n) {
    if (n == 0) return;
    count += n;
    least = std::min(least, first);
    most = std::max(most, first + n - 1);
  }
  void write(MshRows& out, std::size_t blocks) const { out.row(blocks, count, count > 0 ? least : 0, most); }
};

class PieceWriter {
 public:
  /// Collective.
  PieceWriter(const PieceOfMesh& piece, Ranks& ranks)
      : mesh_(piece.mesh),
        partition_(ranks.rank() + 1),
        partitions_(static_cast<std::size_t>(ranks.count())),
        model_(shared_model(mesh_, ranks)),
        on_curve_(model_.curves),
        on_surface_(model_.surfaces),
        ranks_of_points_(piece),
        interfaces_(ranks_of_points_, ranks) {
    const ShareOfRank lines = share_of_rank(mesh_.constrained_edges.size(), ranks);
    const ShareOfRank triangles = share_of_rank(mesh_.triangles.size(), ranks);
    tags_ = {piece.number, lines.before + 1, lines.all + triangles.before + 1};
    ghosts_ = ghost_triangles(piece, ranks_of_points_, tags_.first_triangle, ranks);
    find_ghost_nodes();
    gather_points();
    note_entities();
    unite_boxes(model_.curves, ranks);
    unite_boxes(model_.surfaces, ranks);
  }

  void write(MshRows& out) const {
    out.format();
    write_names(out, model_);
    write_entities(out, model_);
    write_partitioned_entities(out);
    // Gmsh warns if these sections are there and empty.
    if (mesh_.points.empty() && ghost_nodes_.empty()) return;
    write_nodes(out);
    write_elements(out);
    write_ghost_elements(out);
  }

 private:
  struct Entity {
    int dimension, tag, parent_dimension, parent;
    Interfaces::Set partitions;
    MshBox box;
    int physical;  ///< 0: none
    std::span<const Index> points;
  };

  /// The corners of ghost triangles that are not in the piece.
  void find_ghost_nodes() {
    std::map<std::uint64_t, Point> nodes;
    for (const auto& from : ghosts_)
      for (const GhostTriangle& ghost : from)
        for (std::size_t i = 0; i < 3; ++i) nodes.emplace(ghost.number[i], ghost.corners[i]);
    for (const Index v : ranks_of_points_.points()) nodes.erase(tags_.number[v]);
    ghost_nodes_.assign(nodes.begin(), nodes.end());
  }

  /// By curve, surface and interface. Vertices at the border belong to an interface, the same one in all files.
  void gather_points() {
    const std::size_t groups = model_.curves.size() + model_.surfaces.size();
    points_ = gather(mesh_.points.size(), groups + interfaces_.sets().size(), [&](std::size_t i) {
      const auto v = static_cast<Index>(i);
      const std::span<const int> others = ranks_of_points_[v];
      return others.empty() ? std::size_t{model_.entity_of_point[v]} : groups + interfaces_.place_of(others);
    });
  }

  /// The entities that this file uses.
  void note_entities() {
    const auto first = static_cast<std::size_t>(partition_ - 1);
    const std::size_t curves = model_.curves.size(), surfaces = model_.surfaces.size();
    for (std::size_t c = 0; c < curves; ++c)
      if (const MshGroup& g = model_.curves[c]; !model_.lines[c].empty())
        entities_.push_back(
            {1, on_curve_[first * curves + c], 1, g.tag, {partition_}, g.box.finite(), g.tag, points_[c]});
    std::size_t place = curves + surfaces;
    for (const auto& [set, number] : interfaces_.sets()) {
      Interfaces::Set partitions = set;
      for (int& partition : partitions) ++partition;
      MshBox box;
      for (const Index v : points_[place]) box.cover(mesh_.points[v]);
      entities_.push_back(
          {1, on_curve_[partitions_ * curves + number], 0, 0, std::move(partitions), box, 0, points_[place]});
      ++place;
    }
    for (std::size_t s = 0; s < surfaces; ++s)
      if (const MshGroup& g = model_.surfaces[s]; !model_.triangles[s].empty() || !points_[curves + s].empty())
        entities_.push_back(
            {2, on_surface_[first * surfaces + s], 2, g.tag, {partition_}, g.box.finite(), g.tag, points_[curves + s]});
    ghost_entity_ = on_surface_[partitions_ * surfaces + first];
  }

  void write_partitioned_entities(MshRows& out) const {
    const auto of_dimension = [&](int d) {
      return static_cast<std::size_t>(std::ranges::count(entities_, d, &Entity::dimension));
    };
    out.open("PartitionedEntities");
    out.row(partitions_);
    out.row(std::size_t{1});  // ghost entities
    out.row(ghost_entity_, partition_);
    out.row(std::size_t{0}, of_dimension(1), of_dimension(2), std::size_t{0});
    for (const Entity& e : entities_) {
      MshRows::Row row = out.long_row();
      row << e.tag << e.parent_dimension << e.parent << e.partitions.size();
      for (const int partition : e.partitions) row << partition;
      row << e.box.low.x << e.box.low.y << 0.0 << e.box.high.x << e.box.high.y << 0.0;
      row << std::size_t{e.physical != 0};
      if (e.physical != 0) row << e.physical;
      out.write(row << std::size_t{0});
    }
    out.close("PartitionedEntities");
  }

  void write_nodes(MshRows& out) const {
    Limits limits;
    for (Index v = 0; v < mesh_.points.size(); ++v) limits.add(tags_.node(v), 1);
    for (const auto& [number, point] : ghost_nodes_) limits.add(number + 1, 1);
    out.open("Nodes");
    limits.write(out, points_.groups_in_use() + std::size_t{!ghost_nodes_.empty()});
    for (const Entity& e : entities_) write_node_block(out, e.dimension, e.tag, e.points, mesh_, tags_);
    if (!ghost_nodes_.empty()) {
      out.row(2, ghost_entity_, 0, ghost_nodes_.size());
      for (const auto& [number, point] : ghost_nodes_) out.row(std::size_t{number + 1});
      for (const auto& [number, point] : ghost_nodes_) out.row(point.x, point.y, 0.0);
    }
    out.close("Nodes");
  }

  void write_elements(MshRows& out) const {
    Limits limits;
    limits.add(tags_.line(0), mesh_.constrained_edges.size());
    limits.add(tags_.triangle(0), mesh_.triangles.size());
    std::size_t ghosts = 0;
    for (const auto& from : ghosts_) {
      ghosts += from.size();
      for (const GhostTriangle& ghost : from) limits.add(ghost.triangle, 1);
    }
    out.open("Elements");
    limits.write(out, model_.lines.groups_in_use() + model_.triangles.groups_in_use() + std::size_t{ghosts > 0});
    const auto first = static_cast<std::size_t>(partition_ - 1);
    for (std::size_t c = 0; c < model_.curves.size(); ++c)
      write_line_block(out, on_curve_[first * model_.curves.size() + c], model_.lines[c], mesh_, tags_);
    for (std::size_t s = 0; s < model_.surfaces.size(); ++s)
      write_triangle_block(out, on_surface_[first * model_.surfaces.size() + s], model_.triangles[s], mesh_, tags_);
    if (ghosts > 0) out.row(2, ghost_entity_, msh_triangle, ghosts);
    for (const auto& from : ghosts_)
      for (const auto& [triangle, number, corners] : from)
        out.row(std::size_t{triangle}, std::size_t{number[0] + 1}, std::size_t{number[1] + 1},
                std::size_t{number[2] + 1});
    out.close("Elements");
  }

  /// Each ghost element with the partition that has it, and the only partition of this file.
  void write_ghost_elements(MshRows& out) const {
    std::size_t ghosts = 0;
    for (const auto& from : ghosts_) ghosts += from.size();
    if (ghosts == 0) return;
    out.open("GhostElements");
    out.row(ghosts);
    for (std::size_t rank = 0; rank < ghosts_.size(); ++rank)
      for (const GhostTriangle& ghost : ghosts_[rank])
        out.row(std::size_t{ghost.triangle}, static_cast<int>(rank) + 1, std::size_t{1}, partition_);
    out.close("GhostElements");
  }

  const Mesh& mesh_;
  int partition_;
  std::size_t partitions_;
  MshModel model_;
  FreeTags on_curve_, on_surface_;  ///< of curves per partition and group, then interfaces; of surfaces, then ghosts
  RanksOfPoints ranks_of_points_;
  Interfaces interfaces_;
  TagsOfPiece tags_{};
  std::vector<std::vector<GhostTriangle>> ghosts_;
  std::vector<std::pair<std::uint64_t, Point>> ghost_nodes_;  ///< by number
  Gathered points_;
  std::vector<Entity> entities_;
  int ghost_entity_ = 0;
};

}  // namespace

std::filesystem::path msh_of_piece(const std::filesystem::path& file, int partition) {
  std::filesystem::path piece = file;
  return piece.replace_filename(file.stem().string() + "_" + std::to_string(partition) + ".msh");
}

Status write_msh_piece(const PieceOfMesh& piece, const std::filesystem::path& file, MshEncoding encoding,
                       Ranks& ranks) {
  const PieceWriter writer(piece, ranks);
  std::deque<OutputFile> files;
  OutputFile& out = files.emplace_back(msh_of_piece(file, ranks.rank() + 1));
  MshRows rows(out, encoding);
  writer.write(rows);
  if (Status all = agree(out.close(), ranks); !all) return all;
  return commit_all(files, [&](const Status& placed) { return agree(placed, ranks); });
}

}  // namespace pardel
