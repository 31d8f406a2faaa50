#include "check_pieces.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "../../core/support/agree.hpp"
#include "../../core/support/collective.hpp"
#include "../../core/support/share_of_rank.hpp"
#include "pieces/border_delaunay.hpp"
#include "pieces/data_of_vertices.hpp"
#include "pieces/faces_in_pieces.hpp"
#include "pieces/merge.hpp"
#include "pieces/numbers.hpp"
#include "pieces/results_in_piece.hpp"
#include "pieces/skeleton.hpp"
#include "stages/verdict.hpp"

namespace pardel {

using namespace checker;

namespace {

/// What all ranks know about the whole mesh.
struct Whole {
  Border border;
  NumberSet special;
  Judgement judgement;
  EdgesOfChains edges_of_chains;
};

class PieceCheck {
 public:
  PieceCheck(const Pslg& pslg, const PiecesOfRank& pieces, const Goal& goal, const CheckOptions& options, Ranks& ranks)
      : task_{pslg, goal, options, ranks},
        ranks_(ranks),
        reader_(pieces, task_),
        found_(options.max_violations),
        certificate_(empty_certificate(pslg, goal)) {
    // All ranks have the same input, so one of them reports what is wrong with it.
    Findings of_others(0);
    if (check_input(pslg, ranks.rank() == 0 ? found_ : of_others)) input_.emplace(pslg, goal);
  }

  Result<Certificate> run() {
    if (Status read = for_each_piece([&](std::size_t i) { return read_first(i); }); !read) return read.error();
    if (Status fits = agree(count(), ranks_); !fits) return fits.error();
    if (Status judged = run_stages(); !judged) return judged.error();
    set_verdict(certificate_, merged(found_, ranks_));
    return std::move(certificate_);
  }

 private:
  /// Calls visit(i) for the pieces of this rank, until one of them fails. Collective.
  template <class Visit>
  Status for_each_piece(const Visit& visit) {
    Status here = Done{};
    for (std::size_t i = 0; i < reader_.count() && here; ++i) here = visit(i);
    reader_.close();
    return agree(here, ranks_);
  }

  /// Tests the triangles of a piece, and keeps what the other pieces need.
  Status read_first(std::size_t i) {
    Findings not_yet_described(0);
    const Result<Piece*> piece = reader_.open(i, {}, not_yet_described);
    if (!piece) return piece.error();
    read_.pieces.push_back(kept_piece(**piece, input_ ? &*input_ : nullptr, read_.settled));
    numbers_.count((*piece)->number());
    if (read_.pieces.back().has_geometry) numbers_.add((*piece)->number(), *(*piece)->adjacency);
    return Done{};
  }

  /// Counts triangles and listed edges, which determines their names.
  Status count() {
    std::uint64_t triangles = 0, listed = 0;
    for (const KeptPiece& piece : read_.pieces) {
      triangles += piece.triangles;
      listed += piece.listed_edges;
    }
    const ShareOfRank of_triangles = share_of_rank(triangles, ranks_), of_listed = share_of_rank(listed, ranks_);
    certificate_.triangles = of_triangles.all;
    certificate_.constrained_edges = of_listed.all;
    if (task_.options.foreign)
      certificate_.not_checked = not_checked(task_.pslg, {.regions = somewhere(&KeptPiece::has_regions),
                                                          .attributes = somewhere(&KeptPiece::has_attributes),
                                                          .markers = somewhere(&KeptPiece::has_markers),
                                                          .edges = of_listed.all > 0});
    if (std::max(of_triangles.all, of_listed.all) >= no_index)
      return Error{ErrorKind::resources, "the mesh has more triangles than can be checked at once"};
    auto triangle = static_cast<Index>(of_triangles.before), edge = static_cast<Index>(of_listed.before);
    for (const KeptPiece& piece : read_.pieces) {
      read_.first_triangle.push_back(triangle);
      read_.first_listed_edge.push_back(edge);
      triangle += static_cast<Index>(piece.triangles);
      edge += static_cast<Index>(piece.listed_edges);
    }
    return Done{};
  }

  /// True if it is true for all pieces of all ranks.
  bool everywhere(bool KeptPiece::*property) {
    return sum_of(std::ranges::all_of(read_.pieces, property) ? 0 : 1, ranks_) == 0;
  }

  /// True if it is true for a piece of some rank.
  bool somewhere(bool KeptPiece::*property) {
    return sum_of(std::ranges::any_of(read_.pieces, property) ? 1 : 0, ranks_) > 0;
  }

  Status run_stages() {
    const bool geometry = everywhere(&KeptPiece::has_geometry);
    if (!geometry || !input_) {
      const Result<std::uint64_t> points = count_points(numbers_, ranks_);
      if (!points) return points.error();
      certificate_.vertices = *points;
      return for_each_piece([&](std::size_t i) { return describe_unusable(i); });
    }
    const bool labels = everywhere(&KeptPiece::has_labels);
    if (Status right = compare_points(); !right) return right;
    if (Status right = check_data_of_vertices(read_, certificate_.vertices, ranks_); !right) return right;
    Border border(read_, certificate_.vertices, ranks_);
    NumberSet special = special_numbers(read_, border, ranks_);
    Judgement judgement = judge_skeleton(special, labels);
    // Where no edges are listed, a vertex of a chain is special only because the chain passes it.
    for (const NumberedChainEdge& edge : judgement.chains)
      for (const std::uint64_t end : {edge.from, edge.to}) special.insert(end);
    EdgesOfChains edges(judgement);
    const Whole whole{std::move(border), std::move(special), std::move(judgement), std::move(edges)};

    const bool have_regions = somewhere(&KeptPiece::has_regions);
    std::optional<FacesOfPieces> faces;
    if (!task_.pslg.regions.empty() && (task_.goal.region_caps || (labels && have_regions))) {
      if (have_regions) reader_.expect_regions();
      faces.emplace();
      if (Status added = for_each_piece([&](std::size_t i) { return add_faces(i, whole, *faces); }); !added)
        return added;
      faces->unite(whole.border, ranks_);
    }
    std::uint64_t open = 0;
    const auto check = [&](std::size_t i) { return check_last(i, whole, faces ? &*faces : nullptr, labels, open); };
    if (Status checked = for_each_piece(check); !checked) return checked;
    measure(whole, labels, open);
    return Done{};
  }

  /// Opens a piece for another time.
  Result<Piece*> open_again(std::size_t i, Findings& found) {
    Numbering names;
    names.first_triangle = read_.first_triangle[i];
    names.first_listed_edge = read_.first_listed_edge[i];
    Result<Piece*> piece = reader_.open(i, names, found);
    if (!piece) return piece;
    const KeptPiece& known = read_.pieces[i];
    if ((*piece)->mesh().triangles.size() != known.triangles || (*piece)->mesh().points.size() != known.points ||
        (*piece)->mesh().constrained_edges.size() != known.listed_edges ||
        (*piece)->sanity.geometry != known.has_geometry)
      return Error{ErrorKind::io, "a piece has changed since it was read for the first time"};
    return piece;
  }

  /// Describes why the parts of a piece cannot be used.
  Status describe_unusable(std::size_t i) {
    if (!read_.pieces[i].is_described) return Done{};
    Findings all(found_.limit());
    const Result<Piece*> piece = open_again(i, all);
    if (!piece) return piece.error();
    Findings found(found_.limit());
    (void)check_sanity((*piece)->subject, (*piece)->scanned, found);
    found_.append(std::move(found));
    return Done{};
  }

  /// Compares the points of the pieces, and counts those of the whole mesh.
  Status compare_points() {
    std::vector<NumberedPoint> border;
    for (const KeptPiece& piece : read_.pieces)
      for (const KeptVertex& vertex : piece.part.vertices)
        if (vertex.is_at_border) border.push_back({vertex.number, vertex.at});
    const auto find = [&](const std::vector<std::uint64_t>& numbers) { return find_points(numbers); };
    const Result<std::uint64_t> points = check_numbers(numbers_, border, find, ranks_);
    if (!points) return points.error();
    certificate_.vertices = *points;
    numbers_ = {};
    return Done{};
  }

  /// The vertices with these numbers. The triangles around them are kept from now on.
  Result<std::vector<NumberedPoint>> find_points(const std::vector<std::uint64_t>& numbers) {
    std::vector<NumberedPoint> points;
    for (const std::uint64_t number : numbers) read_.settled.erase(number);
    for (std::size_t i = 0; i < reader_.count(); ++i) {
      Findings described_later(0);
      const Result<Piece*> piece = open_again(i, described_later);
      if (!piece) return piece.error();
      KeptPart& part = read_.pieces[i].part;
      part = part_to_keep(**piece, input_->places, input_->free, input_->ranges, read_.settled, numbers);
      for (const KeptVertex& vertex : part.vertices)
        if (std::ranges::binary_search(numbers, vertex.number)) points.push_back({vertex.number, vertex.at});
    }
    reader_.close();
    return points;
  }

  Judgement judge_skeleton(const NumberSet& special, bool labels) {
    const bool counter_clockwise = everywhere(&KeptPiece::is_counter_clockwise);
    const std::optional<Skeleton> skeleton = gather_skeleton(read_, special, ranks_);
    Ranks::Bytes message;
    const NumberSet settled = settled_inputs(read_, task_.pslg.points.size(), ranks_);
    if (skeleton)
      message = judge(*skeleton, settled, task_, input_->domain, labels, counter_clockwise, found_).message();
    return Judgement::read(from_first(message, ranks_));
  }

  Status add_faces(std::size_t i, const Whole& whole, FacesOfPieces& faces) {
    Findings described_later(0);
    const Result<Piece*> piece = open_again(i, described_later);
    if (!piece) return piece.error();
    const Chains chains = chains_in_piece(**piece, whole.judgement, SpecialVertices(**piece, whole.special));
    faces.add(joined_triangles(**piece, input_->domain, chains), read_.pieces[i].part, chains);
    return Done{};
  }

  /// Checks what depends on other pieces. Adds the number of triangles with tests that only these leave open to `open`.
  Status check_last(std::size_t i, const Whole& whole, const FacesOfPieces* faces, bool labels, std::uint64_t& open) {
    const auto check_border = [&] {
      open += check_border_delaunay(read_.pieces[i].part, read_.first_triangle[i], whole.border.of(i),
                                    whole.edges_of_chains, task_.goal, found_);
    };
    if (read_.pieces[i].is_clear && faces == nullptr && whole.judgement.suspects.empty()) return check_border(), Done{};
    const Result<Piece*> opened = open_again(i, found_);
    if (!opened) return opened.error();
    Piece& piece = **opened;
    const std::vector<std::pair<Index, int>> earlier = earlier_neighbours(i, whole.border);
    piece.subject.names.earlier_neighbours = earlier;
    check_again(piece, i, whole, faces, labels, check_border);
    piece.subject.names.earlier_neighbours = {};
    return Done{};
  }

  template <class CheckBorder>
  void check_again(const Piece& piece, std::size_t i, const Whole& whole, const FacesOfPieces* faces, bool labels,
                   const CheckBorder& check_border) {
    const Domain& domain = input_->domain;
    const SpecialVertices special(piece, whole.special);
    const Chains chains = chains_in_piece(piece, whole.judgement, special);
    const InputVertices inputs = input_vertices_in_piece(piece, whole.judgement, special);
    check_holes(piece.subject, domain, chains, whole.judgement.suspects, found_);
    std::vector<Index> faces_here;
    if (faces != nullptr) faces_here = faces->faces_of(i, joined_triangles(piece, domain, chains));
    if (labels) check_regions(piece.subject, domain, faces_here, found_);
    check_delaunay(piece.subject, *piece.adjacency, chains, piece.scanned, found_);
    check_border();
    check_goal(piece.subject, domain, *piece.adjacency, chains, inputs, faces_here, input_->wanted, piece.scanned,
               found_, justified_);
  }

  /// The sides across which a triangle with a smaller number lies in another piece.
  std::vector<std::pair<Index, int>> earlier_neighbours(std::size_t i, const Border& border) const {
    const std::span<const Across> across = border.of(i);
    const std::vector<KeptSide>& sides = read_.pieces[i].part.sides;
    std::vector<std::pair<Index, int>> earlier;
    for (std::size_t s = 0; s < sides.size(); ++s)
      if (across[s].exists() && across[s].triangle < read_.first_triangle[i] + sides[s].triangle)
        earlier.emplace_back(sides[s].triangle, sides[s].side);
    std::ranges::sort(earlier);
    return earlier;
  }

  void measure(const Whole& whole, bool labels, std::uint64_t open) {
    Digest digest;
    for (std::size_t i = 0; i < read_.pieces.size(); ++i) {
      const KeptPiece& piece = read_.pieces[i];
      add_measures(certificate_, piece.measures, read_.first_triangle[i]);
      digest = digest + piece.digest;
      open += piece.open;
    }
    merge_measures(certificate_, ranks_);
    certificate_.justified = merged(justified_, ranks_);
    certificate_.area = whole.judgement.area;
    certificate_.decided_exactly = sum_of(open, ranks_);
    if (labels) certificate_.digest = sum_of(digest, ranks_);
  }

  Task task_;
  Ranks& ranks_;
  PieceReader reader_;
  std::optional<InputOfPieces> input_;
  PiecesRead read_;
  NumbersOfRank numbers_;
  Findings found_;
  std::vector<Justified> justified_;
  Certificate certificate_;
};

}  // namespace

Result<Certificate> check(const Pslg& pslg, const PiecesOfRank& pieces, const Goal& goal, const CheckOptions& options,
                          Ranks& ranks) {
  return PieceCheck(pslg, pieces, goal, options, ranks).run();
}

}  // namespace pardel
