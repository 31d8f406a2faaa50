// The files that several ranks write of one mesh.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "../../../core/digest.hpp"
#include "../../../core/formats.hpp"
#include "../../../distributed/distributed.hpp"
#include "../../../parallel/mesher.hpp"
#include "../../../properties/domains/domains.hpp"
#include "../../../properties/theorems/framework/local_ranks.hpp"
#include "../../temporary_folder.hpp"
#include "square_with_data.hpp"

namespace pardel {
namespace {

using properties::on_ranks;

struct Case {
  std::string name;
  Pslg pslg;
  Goal goal;
  Options options{.threads = 1};
};

/// Names of tests contain it. Without it they would contain the bytes of the case, which differ from run to run.
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

/// Two attributes per point; files list the markers of segments.
Pslg regions_with_data() {
  Pslg pslg = square_with_data(2);
  pslg.has_segment_markers = true;
  return pslg;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"regions", regions_with_data(), {.max_area = 0.002}, {.threads = 1, .cells = {6, 6}}},
      {"points", domains::random_points(1000, 3), {.min_angle_deg = 28}, {.threads = 1, .triangles_per_tile = 100}},
      {"pipe", domains::pipe(), {.max_area = 3e-3}, {.threads = 1, .cells = {7, 8}}},
      {"one_tile", domains::key(), {.max_area = 0.1}, {.threads = 1, .decomposition = Decomposition::none}}};
  return all;
}

/// Makes the mesh on several ranks, and calls write(piece, pslg, ranks) on each. Returns the results of all ranks.
template <class Write>
std::vector<Status> written(const Case& c, int ranks, const Write& write) {
  std::vector<Status> results(static_cast<std::size_t>(ranks), Done{});
  on_ranks(ranks, [&](Ranks& network) {
    const Result<MeshPiece> piece = mesh(std::move(validate(c.pslg)).value(), c.goal, c.options, network);
    results[static_cast<std::size_t>(network.rank())] = piece ? write(*piece, network) : Status(piece.error());
  });
  return results;
}

std::vector<Status> write_triangle(const Case& c, int ranks, const std::filesystem::path& stem) {
  return written(c, ranks, [&](const MeshPiece& piece, Ranks& network) {
    return write_triangle_pieces(view_of(piece), c.pslg, stem, network);
  });
}

std::vector<Status> write_msh(const Case& c, int ranks, const std::filesystem::path& file, MshEncoding encoding) {
  return written(c, ranks, [&](const MeshPiece& piece, Ranks& network) {
    return write_msh_piece(view_of(piece), file, encoding, network);
  });
}

bool all_done(const std::vector<Status>& results) {
  return std::ranges::all_of(results, [](const Status& s) { return s.ok(); });
}

/// What a mesh says about a point, an edge and a triangle, whatever their numbers are.
std::multiset<std::vector<double>> content(const Mesh& mesh, bool with_points) {
  std::multiset<std::vector<double>> all;
  const auto put = [](std::vector<double>& to, Point p) { to.insert(to.end(), {p.x, p.y}); };
  for (std::size_t v = 0; with_points && v < mesh.points.size(); ++v) {
    std::vector<double> about{0};
    put(about, mesh.points[v]);
    about.push_back(mesh.point_markers[v]);
    const auto attributes =
        mesh.point_attributes.span().subspan(v * mesh.attributes_per_point, mesh.attributes_per_point);
    about.insert(about.end(), attributes.begin(), attributes.end());
    all.insert(std::move(about));
  }
  for (const ConstrainedEdge& e : mesh.constrained_edges) {
    std::array ends{mesh.points[e.a], mesh.points[e.b]};
    if (ends[1].x < ends[0].x || (ends[1].x == ends[0].x && ends[1].y < ends[0].y)) std::swap(ends[0], ends[1]);
    std::vector<double> about{1, static_cast<double>(e.marker)};
    for (const Point p : ends) put(about, p);
    all.insert(std::move(about));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::vector<std::array<double, 2>> corners;
    for (const Index v : mesh.triangles[t].v) corners.push_back({mesh.points[v].x, mesh.points[v].y});
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    std::vector<double> about{
        2, mesh.region.empty() || mesh.region[t] == no_index ? 0.0 : mesh.region_attributes[mesh.region[t]]};
    for (const auto& p : corners) about.insert(about.end(), p.begin(), p.end());
    all.insert(std::move(about));
  }
  return all;
}

class WrittenPieces : public testing::TestWithParam<Case> {
 protected:
  TemporaryFolder folder_;
};

TEST_P(WrittenPieces, in_triangles_format_are_one_mesh_whose_bytes_do_not_depend_on_the_number_of_ranks) {
  const Case& c = GetParam();
  std::map<std::string, std::string> expected;
  for (const int ranks : {1, 2, 3, 5, 8}) {
    ASSERT_TRUE(all_done(write_triangle(c, ranks, folder_ / "out"))) << ranks;
    ASSERT_EQ(folder_.names(), "out.ele out.node out.poly ");
    for (const char* file : {"out.ele", "out.node", "out.poly"})
      EXPECT_EQ(expected.try_emplace(file, folder_.read(file)).first->second, folder_.read(file)) << ranks << file;
  }
  const Result<Mesh> read = read_mesh(folder_ / "out.node");
  ASSERT_TRUE(read) << read.error().message;
  const Mesh whole = std::move(mesh(std::move(validate(c.pslg)).value(), c.goal, c.options))->mesh;
  EXPECT_EQ(digest(*read), digest(whole));
  EXPECT_EQ(content(*read, true), content(whole, true));
}

TEST_P(WrittenPieces, in_triangles_format_are_in_the_order_of_numbers) {
  ASSERT_TRUE(all_done(write_triangle(GetParam(), 3, folder_ / "out")));
  const Mesh read = std::move(read_mesh(folder_ / "out.node")).value();
  for (std::size_t v = 0; v < GetParam().pslg.points.size(); ++v) EXPECT_EQ(read.points[v], GetParam().pslg.points[v]);
  const auto least_first = [](const Triangle& t) { return t.v[0] < t.v[1] && t.v[0] < t.v[2]; };
  EXPECT_TRUE(std::ranges::all_of(read.triangles, least_first));
  EXPECT_TRUE(std::ranges::is_sorted(read.triangles, {}, &Triangle::v));
  const auto ends = [](const ConstrainedEdge& e) { return std::pair(std::min(e.a, e.b), std::max(e.a, e.b)); };
  EXPECT_TRUE(std::ranges::is_sorted(read.constrained_edges, {}, ends));
}

TEST_P(WrittenPieces, in_gmshs_format_are_together_the_whole_mesh) {
  const Case& c = GetParam();
  const Mesh whole = std::move(mesh(std::move(validate(c.pslg)).value(), c.goal, c.options))->mesh;
  for (const MshEncoding encoding : {MshEncoding::ascii, MshEncoding::binary})
    for (const int ranks : {1, 2, 5}) {
      ASSERT_TRUE(all_done(write_msh(c, ranks, folder_ / "out.msh", encoding)));
      const Result<Mesh> read = read_mesh(folder_ / "out.msh");
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_EQ(digest(*read), digest(whole));
      EXPECT_EQ(content(*read, false), content(whole, false)) << ranks;
    }
}

/// The sections of an MSH file in ASCII: the lines of each, as numbers.
std::map<std::string, std::vector<std::vector<double>>> sections_of(const std::string& text) {
  std::map<std::string, std::vector<std::vector<double>>> sections;
  std::istringstream in(text);
  std::string line, section;
  while (std::getline(in, line)) {
    if (line.starts_with('$')) {
      section = line;
    } else {
      std::istringstream numbers(line);
      std::vector<double>& to = sections[section].emplace_back();
      for (double number = 0; numbers >> number;) to.push_back(number);
    }
  }
  return sections;
}

/// The blocks of a section: entity by entity (dimension and tag), the rows. Rows of nodes are their tags only.
std::map<std::array<int, 2>, std::vector<std::vector<double>>> blocks_of(const std::vector<std::vector<double>>& lines,
                                                                         bool nodes) {
  std::map<std::array<int, 2>, std::vector<std::vector<double>>> blocks;
  for (std::size_t at = 1; at < lines.size();) {
    const std::vector<double>& head = lines[at++];
    const auto n = static_cast<std::size_t>(head[3]);
    auto& rows = blocks[{static_cast<int>(head[0]), static_cast<int>(head[1])}];
    rows.assign(lines.begin() + static_cast<std::ptrdiff_t>(at), lines.begin() + static_cast<std::ptrdiff_t>(at + n));
    at += nodes ? 2 * n : n;
  }
  return blocks;
}

TEST_P(WrittenPieces, in_gmshs_format_have_global_tags_and_the_triangles_around_them_as_ghosts) {
  constexpr int ranks = 4;
  ASSERT_TRUE(all_done(write_msh(GetParam(), ranks, folder_ / "out.msh", MshEncoding::ascii)));
  using Corners = std::set<double>;
  std::map<double, Corners> triangle;  // of all pieces, by tag
  std::map<double, int> owner;
  std::vector<std::set<double>> own_nodes(ranks), ghosts(ranks);
  std::vector<std::map<double, int>> ghost_owner(ranks);
  std::set<double> tags;
  std::size_t elements = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    auto sections = sections_of(folder_.read("out_" + std::to_string(rank + 1) + ".msh"));
    const auto ghost_entity = static_cast<int>(sections["$PartitionedEntities"][2][0]);
    EXPECT_EQ(sections["$PartitionedEntities"][2][1], rank + 1);
    std::set<double> nodes;
    for (const auto& [entity, rows] : blocks_of(sections["$Nodes"], true))
      for (const auto& row : rows) EXPECT_TRUE(nodes.insert(row[0]).second) << "a node occurs twice";
    for (const auto& [entity, rows] : blocks_of(sections["$Elements"], false))
      for (const auto& row : rows) {
        const Corners corners(row.begin() + 1, row.end());
        EXPECT_TRUE(std::ranges::includes(nodes, corners));
        if (entity == std::array{2, ghost_entity}) {
          ghosts[static_cast<std::size_t>(rank)].insert(row[0]);
          continue;
        }
        EXPECT_TRUE(tags.insert(row[0]).second) << "two elements have the tag " << row[0];
        ++elements;
        if (entity[0] != 2) continue;
        triangle[row[0]] = corners;
        owner[row[0]] = rank + 1;
        own_nodes[static_cast<std::size_t>(rank)].insert(corners.begin(), corners.end());
      }
    const auto& listed = sections["$GhostElements"];
    for (std::size_t i = 1; i < listed.size(); ++i) {
      EXPECT_EQ(listed[i].size(), 4u);
      EXPECT_EQ(listed[i][3], rank + 1);
      ghost_owner[static_cast<std::size_t>(rank)][listed[i][0]] = static_cast<int>(listed[i][1]);
    }
  }
  EXPECT_EQ(*tags.begin(), 1);
  EXPECT_EQ(*tags.rbegin(), static_cast<double>(elements));
  for (int rank = 0; rank < ranks; ++rank) {
    const auto r = static_cast<std::size_t>(rank);
    std::set<double> expected;
    for (const auto& [tag, corners] : triangle) {
      const bool touches = std::ranges::any_of(corners, [&](double v) { return own_nodes[r].contains(v); });
      if (owner[tag] != rank + 1 && touches) expected.insert(tag);
    }
    EXPECT_EQ(ghosts[r], expected);
    EXPECT_EQ(ghost_owner[r].size(), expected.size());
    for (const auto& [tag, from] : ghost_owner[r]) EXPECT_EQ(owner[tag], from);
  }
}

TEST_P(WrittenPieces, in_gmshs_format_have_the_shared_vertices_in_curves_of_several_partitions) {
  constexpr int ranks = 4;
  ASSERT_TRUE(all_done(write_msh(GetParam(), ranks, folder_ / "out.msh", MshEncoding::ascii)));
  std::map<int, std::set<double>> nodes_of_curve;  // by tag
  std::map<int, std::set<int>> partitions_of_curve, files_of_curve;
  std::map<double, std::set<int>> partitions_of_node;  // by their triangles
  for (int partition = 1; partition <= ranks; ++partition) {
    auto sections = sections_of(folder_.read("out_" + std::to_string(partition) + ".msh"));
    const auto& entities = sections["$PartitionedEntities"];
    const auto ghost_entity = static_cast<int>(entities[2][0]);
    const auto nodes = blocks_of(sections["$Nodes"], true);
    for (std::size_t i = 4; i < entities.size(); ++i) {
      const auto& e = entities[i];
      if (e[1] != 0) continue;  // it has a parent
      const auto tag = static_cast<int>(e[0]);
      std::set<double> of_curve;
      for (const auto& row : nodes.at({1, tag})) of_curve.insert(row[0]);
      EXPECT_EQ(nodes_of_curve.try_emplace(tag, of_curve).first->second, of_curve);
      for (int k = 0; k < static_cast<int>(e[3]); ++k)
        partitions_of_curve[tag].insert(static_cast<int>(e[4 + static_cast<std::size_t>(k)]));
      files_of_curve[tag].insert(partition);
    }
    for (const auto& [entity, rows] : blocks_of(sections["$Elements"], false))
      if (entity[0] == 2 && entity[1] != ghost_entity)
        for (const auto& row : rows)
          for (std::size_t k = 1; k < row.size(); ++k) partitions_of_node[row[k]].insert(partition);
  }
  EXPECT_EQ(partitions_of_curve, files_of_curve);
  std::size_t shared = 0;
  for (const auto& [node, partitions] : partitions_of_node) shared += partitions.size() > 1 ? 1 : 0;
  std::size_t on_curves = 0;
  for (const auto& [tag, nodes] : nodes_of_curve) {
    on_curves += nodes.size();
    for (const double node : nodes) EXPECT_EQ(partitions_of_node[node], partitions_of_curve[tag]);
  }
  EXPECT_EQ(on_curves, shared);
}

INSTANTIATE_TEST_SUITE_P(Domains, WrittenPieces, testing::ValuesIn(cases()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(WrittenPieces, are_opened_by_gmsh_without_a_warning) {
  if (std::string(PARDEL_GMSH).empty()) GTEST_SKIP() << "gmsh is not installed";
  const TemporaryFolder folder;
  for (const auto& [mesh, encoding] : {std::pair{&cases().front(), MshEncoding::ascii},
                                       {&cases().front(), MshEncoding::binary},
                                       {&cases().back(), MshEncoding::ascii},  // two pieces are empty
                                       {&cases().back(), MshEncoding::binary}}) {
    ASSERT_TRUE(all_done(write_msh(*mesh, 3, folder / "out.msh", encoding)));
    for (const char* piece : {"out_1.msh", "out_2.msh", "out_3.msh"}) {
      const std::string log = folder / "log", file = folder / piece;
      ASSERT_EQ(std::system(("'" PARDEL_GMSH "' -0 '" + file + "' > '" + log + "' 2>&1").c_str()), 0);
      const std::string said = folder.read("log");
      EXPECT_NE(said.find("3 partitions"), std::string::npos) << said;
      EXPECT_EQ(said.find("Warning"), std::string::npos) << said;
      EXPECT_EQ(said.find("Error"), std::string::npos) << said;
    }
  }
}

TEST(WrittenPieces, get_no_name_if_one_rank_cannot_write) {
  const TemporaryFolder folder;
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto ignored = std::signal(SIGXFSZ, SIG_IGN);
  for (const bool is_msh : {false, true}) {
    // In the common files, the first ranks write to places before the limit, the last one beyond it.
    const std::vector<Status> results = written(cases()[0], 3, [&](const MeshPiece& piece, Ranks& ranks) {
      if (ranks.rank() == 0) {
        const rlimit limit{is_msh ? piece.triangles * 5 : piece.points * 20, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
      }
      std::uint64_t started = 1;
      ranks.add_up({&started, 1});
      return is_msh ? write_msh_piece(view_of(piece), folder / "out.msh", MshEncoding::ascii, ranks)
                    : write_triangle_pieces(view_of(piece), cases()[0].pslg, folder / "out", ranks);
    });
    setrlimit(RLIMIT_FSIZE, &before);
    for (const Status& result : results) {
      ASSERT_FALSE(result.ok());
      EXPECT_EQ(result.error().kind, ErrorKind::io);
      EXPECT_EQ(result.error().message, results.front().error().message);
      EXPECT_NE(result.error().message.find("File too large"), std::string::npos) << result.error().message;
    }
    EXPECT_EQ(folder.names(), "");
  }
  std::signal(SIGXFSZ, ignored);
}

TEST(WrittenPieces, are_refused_where_files_are_not_regular) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/null", folder / "out.ele");
  for (const Status& result : write_triangle(cases()[3], 2, folder / "out")) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(message_of(result, folder),
              "out.ele: cannot be written by several processes, because it is not a regular file");
  }
  EXPECT_EQ(folder.names(), "out.ele ");
}

TEST(WrittenPieces, need_a_folder) {
  const TemporaryFolder folder;
  for (const Status& result : write_triangle(cases()[3], 2, folder / "missing/out")) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(message_of(result, folder),
              "rank 0: missing/out.node: cannot be opened for writing: No such file or directory");
  }
}

TEST(WrittenPieces, of_a_partitioned_mesh_are_all_needed) {
  const TemporaryFolder folder;
  ASSERT_TRUE(all_done(write_msh(cases()[0], 3, folder / "out.msh", MshEncoding::binary)));
  std::filesystem::remove(folder / "out_3.msh");
  EXPECT_EQ(message_of(read_mesh(folder / "out.msh"), folder),
            "out_3.msh: cannot be opened: No such file or directory");
  ASSERT_TRUE(all_done(write_msh(cases()[0], 2, folder / "other.msh", MshEncoding::binary)));
  std::filesystem::rename(folder / "other_2.msh", folder / "out_2.msh");
  EXPECT_EQ(message_of(read_mesh(folder / "out.msh"), folder),
            "out_2.msh: belongs to a mesh with 2 partitions, not 3 as out_1.msh");
}

TEST(WrittenPieces, can_be_read_alone_without_their_ghosts) {
  const TemporaryFolder folder;
  for (const Case* c : {&cases().front(), &cases().back()}) {  // of the last mesh, two pieces are empty
    ASSERT_TRUE(all_done(write_msh(*c, 3, folder / "out.msh", MshEncoding::binary)));
    std::size_t triangles = 0;
    for (const char* piece : {"out_1.msh", "out_2.msh", "out_3.msh"}) {
      const Result<Mesh> read = read_mesh(folder / piece);
      ASSERT_TRUE(read) << read.error().message;
      triangles += read->triangles.size();
      std::vector<char> used(read->points.size(), 0);
      for (const Triangle& t : read->triangles)
        for (const Index v : t.v) used[v] = 1;
      EXPECT_EQ(std::ranges::count(used, 0), 0);
    }
    EXPECT_EQ(triangles, read_mesh(folder / "out.msh")->triangles.size());
  }
}

TEST(WrittenPieces, are_not_empty_if_they_have_entities) {
  const TemporaryFolder folder;
  ASSERT_TRUE(all_done(write_msh(cases().front(), 3, folder / "out.msh", MshEncoding::ascii)));
  const std::string whole = folder.read("out_2.msh");
  for (const char* section : {"$Nodes", "$Elements"}) {
    folder.write("out_2.msh", whole.substr(0, whole.find(section)));
    for (const char* file : {"out.msh", "out_2.msh"}) {
      const Result<Mesh> read = read_mesh(folder / file);
      ASSERT_FALSE(read) << section;
      EXPECT_NE(read.error().message.find("out_2.msh:"), std::string::npos) << read.error().message;
      EXPECT_NE(read.error().message.find(std::string("expected ") + section + ", found the end of the file"),
                std::string::npos)
          << read.error().message;
    }
  }
}

}  // namespace
}  // namespace pardel
