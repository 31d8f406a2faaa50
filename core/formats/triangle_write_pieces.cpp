// Writes Triangle's files of a mesh in pieces: one set of files for the whole mesh, written by all ranks together.
#include <array>
#include <functional>
#include <utility>

#include "../formats.hpp"
#include "../support/agree.hpp"
#include "../support/share_of_rank.hpp"
#include "share_of_file.hpp"
#include "shared_text.hpp"
#include "triangle_records.hpp"

namespace pardel {
using namespace files;
namespace {

namespace fs = std::filesystem;

constexpr int base = 1;

/// Text that only the first rank writes.
TextPart only_first(const Ranks& ranks, std::function<void(Bytes&)> put) {
  return {ranks.rank() == 0 ? std::size_t{1} : 0, [put = std::move(put)](Bytes& to, std::size_t) { put(to); }};
}

/// The records of both sections of a file: put(to, number, i) appends record i of this rank, which has this number in
/// the file. `records`: per section.
template <class Put>
class Numbered {
 public:
  /// Collective.
  Numbered(const std::array<ShareOfFile::Records, ShareOfFile::sections>& records, Ranks& ranks, Put put)
      : records_(records), put_(std::move(put)) {
    for (std::size_t s = 0; s < records.size(); ++s) {
      const ShareOfRank share = share_of_rank(records[s].count, ranks);
      first_number_[s] = all_ + share.before;
      all_ += share.all;
    }
  }
  [[nodiscard]] std::uint64_t all() const { return all_; }
  [[nodiscard]] TextPart part(std::size_t section) const {
    return {records_[section].count, [this, section](Bytes& to, std::size_t i) {
              put_(to, first_number_[section] + i + base, records_[section].first + i);
            }};
  }

 private:
  std::array<ShareOfFile::Records, ShareOfFile::sections> records_;
  std::array<std::uint64_t, ShareOfFile::sections> first_number_{};
  std::uint64_t all_ = 0;
  Put put_;
};

}  // namespace

Status write_triangle_pieces(const PieceOfMesh& piece, const Pslg& pslg, const fs::path& stem, Ranks& ranks) {
  const Mesh& mesh = piece.mesh;
  const ShareOfFile share(piece, ranks);
  if (Status all = agree(share.complete(), ranks); !all) return all;
  std::uint64_t ranks_with_regions = mesh.region.empty() ? 0 : 1;  // a rank without triangles has no regions
  ranks.add_up({&ranks_with_regions, 1});
  const bool regions = ranks_with_regions > 0;

  const Numbered points({share.points(0), share.points(1)}, ranks, [&](Bytes& to, std::uint64_t number, std::size_t i) {
    put_point(to, number, share.point(i), share.attributes(i), &share.marker(i));
  });
  const Numbered triangles({share.triangles(0), share.triangles(1)}, ranks,
                           [&](Bytes& to, std::uint64_t number, std::size_t i) {
                             const auto v = share.corners(i);
                             to.numbers(number, v[0] + base, v[1] + base, v[2] + base);
                             if (regions) {
                               const Index region = share.region(i);
                               to << ' ' << (region == no_index ? 0.0 : mesh.region_attributes[region]);
                             }
                             to << '\n';
                           });
  const Numbered edges({share.edges(0), share.edges(1)}, ranks, [&](Bytes& to, std::uint64_t number, std::size_t i) {
    const ShareOfFile::Edge& e = share.edge(i);
    put_edge(to, number, e.a + base, e.b + base, &e.marker);
  });

  const std::array names{fs::path(stem) += ".node", fs::path(stem) += ".ele", fs::path(stem) += ".poly"};
  SharedFiles files(names, ranks);
  const auto write = [&](std::size_t file, std::function<void(Bytes&)> head, const auto& records,
                         std::function<void(Bytes&)> end) {
    const std::array parts{only_first(ranks, std::move(head)), records.part(0), records.part(1),
                           only_first(ranks, std::move(end))};
    write_shared_text(files, file, parts, ranks);
  };
  const auto nothing = [](Bytes&) {};
  const std::size_t k = mesh.attributes_per_point;
  write(
      0, [&](Bytes& to) { put_point_header(to, points.all(), k, true); }, points, nothing);
  write(
      1, [&](Bytes& to) { put_triangle_header(to, triangles.all(), 3, regions); }, triangles, nothing);
  write(
      2,
      [&](Bytes& to) {
        put_point_header(to, 0, k, true);
        put_edge_header(to, edges.all(), true);
      },
      edges, [&](Bytes& to) { put_holes_and_regions(to, pslg, base); });
  return files.commit();
}

}  // namespace pardel
