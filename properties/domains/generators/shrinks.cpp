// Makes simpler domains. Every step maps the domain to an image: points move, merge or disappear, segments join the
// images of their ends, and each seed gets a new place in the image of its face.
#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

#include "lattice/determinants.hpp"
#include "lattice/faces.hpp"
#include "lattice_domain.hpp"

namespace pardel::generators {
namespace {

class Shrinker {
 public:
  explicit Shrinker(const LatticeDomain& domain) : domain_(domain), faces_(domain) {
    for (const LatticePoint hole : domain.holes) face_of_hole_.push_back(faces_.containing(hole));
    for (const LatticeRegion& region : domain.regions) face_of_region_.push_back(faces_.containing(region.seed));
  }

  std::vector<LatticeDomain> all() {
    drop_holes();
    drop_regions();
    drop_segments();
    drop_points();
    coarsen();
    use_plain_numbers();
    return std::move(simpler_);
  }

 private:
  /// Describes the image of every part of the domain.
  struct Image {
    std::vector<Index> point;          ///< per point: its image; no_index if the point disappears
    std::vector<LatticePoint> places;  ///< new places of all points
    std::vector<char> keeps_segment, keeps_hole, keeps_region;
  };

  [[nodiscard]] Image identity() const {
    Image image{std::vector<Index>(domain_.points.size()), domain_.points,
                std::vector<char>(domain_.segments.size(), true), std::vector<char>(domain_.holes.size(), true),
                std::vector<char>(domain_.regions.size(), true)};
    std::iota(image.point.begin(), image.point.end(), Index{0});
    return image;
  }

  void drop_holes() {
    for (std::size_t h = 0; h < domain_.holes.size(); ++h) {
      Image image = identity();
      for (std::size_t other = 0; other < domain_.holes.size(); ++other)
        if (face_of_hole_[other] == face_of_hole_[h]) image.keeps_hole[other] = false;
      const Image seed_only = image;
      for (Index s = 0; s < domain_.segments.size(); ++s)
        if (borders_inside(s, face_of_hole_[h])) image.keeps_segment[s] = false;
      drop_points_left_alone(image);
      propose(image);
      propose(seed_only);
    }
  }

  void drop_regions() {
    for (std::size_t r = 0; r < domain_.regions.size(); ++r) {
      Image image = identity();
      image.keeps_region[r] = false;
      propose(image);
    }
  }

  void drop_segments() {
    Image bare = identity();
    for (Index s = 0; s < domain_.segments.size(); ++s)
      if (is_inside(s)) bare.keeps_segment[s] = false;
    Image alone = bare;
    drop_points_left_alone(alone);
    propose(alone);
    propose(bare);
    for (Index s = 0; s < domain_.segments.size(); ++s) {
      Image image = identity();
      image.keeps_segment[s] = false;
      propose(image);
    }
  }

  /// Removes points without segments, and merges one end of every segment into the other, so that contours stay closed.
  void drop_points() {
    for (Index p = 0; p < domain_.points.size(); ++p) {
      Image image = identity();
      image.point[p] = no_index;
      if (domain_.segments.empty() || faces_.around(p).empty()) propose(image);
    }
    for (const Segment& s : domain_.segments)
      for (const auto& [gone, kept] : {std::pair(s.a, s.b), std::pair(s.b, s.a)}) {
        Image image = identity();
        image.point[gone] = kept;
        propose(image);
      }
  }

  void coarsen() {
    for (const LatticePoint by : {LatticePoint{2, 2}, {2, 1}, {1, 2}}) {
      Image image = identity();
      for (LatticePoint& p : image.places) p = {p.x / by.x, p.y / by.y};
      propose(image);
    }
  }

  void use_plain_numbers() {
    if (domain_.offset != LatticePoint{}) simpler_.emplace_back(domain_).offset = {};
    if (domain_.exponent != 0) simpler_.emplace_back(domain_).exponent = 0;
    for (const Decorations& fewer : generators::shrinks(domain_.decorations))
      simpler_.emplace_back(domain_).decorations = fewer;
    LatticeDomain plain = domain_;
    for (Segment& s : plain.segments) s.marker = 0;
    for (LatticeRegion& region : plain.regions) region = {region.seed};
    if (plain != domain_) simpler_.push_back(plain);
  }

  /// True if the segment lies between this face and another face that is not the exterior.
  [[nodiscard]] bool borders_inside(Index segment, Index face) const {
    const Index left = faces_.left_of(2 * segment), right = faces_.left_of(2 * segment + 1);
    return (left == face || right == face) && is_inside(segment);
  }
  [[nodiscard]] bool is_inside(Index segment) const {
    return faces_.left_of(2 * segment) != LatticeFaces::exterior &&
           faces_.left_of(2 * segment + 1) != LatticeFaces::exterior;
  }

  /// Removes the points that lose all their segments.
  void drop_points_left_alone(Image& image) const {
    for (const bool kept : {false, true})
      for (std::size_t s = 0; s < domain_.segments.size(); ++s)
        if (static_cast<bool>(image.keeps_segment[s]) == kept)
          for (const Index p : {domain_.segments[s].a, domain_.segments[s].b}) image.point[p] = kept ? p : no_index;
  }

  /// Adds the image of the domain if it is valid and has a smaller weight.
  void propose(const Image& image) {
    LatticeDomain result;
    result.family = domain_.family;
    result.offset = domain_.offset;
    result.exponent = domain_.exponent;
    result.decorations = domain_.decorations;
    std::vector<Index> index(domain_.points.size(), no_index);
    for (Index p = 0; p < index.size(); ++p) {
      if (image.point[p] != p) continue;
      index[p] = static_cast<Index>(result.points.size());
      result.points.push_back(image.places[p]);
    }
    const auto image_of = [&](Index p) { return image.point[p] == no_index ? no_index : index[image.point[p]]; };
    std::set<std::pair<Index, Index>> known;
    for (std::size_t s = 0; s < domain_.segments.size(); ++s) {
      const Segment& segment = domain_.segments[s];
      const Index a = image_of(segment.a), b = image_of(segment.b);
      if (image.keeps_segment[s] && a != no_index && b != no_index && a != b && known.insert(std::minmax(a, b)).second)
        result.segments.push_back({a, b, segment.marker});
    }
    if (!is_valid(result)) return;
    const bool something_remains = put_seeds(image, image_of, result);
    if (something_remains && weight(result) < weight(domain_)) simpler_.push_back(std::move(result));
  }

  /// Gives every seed a place in the image of its face: the face on the left of the image of one of the half-edges of
  /// the old face. A seed without such a half-edge disappears. False if holes would remove every face.
  template <class ImageOf>
  bool put_seeds(const Image& image, const ImageOf& image_of, LatticeDomain& result) const {
    if (domain_.holes.empty() && domain_.regions.empty()) return true;
    LatticeFaces faces(result.points, result.segments);
    const auto image_of_face = [&](Index old_face) {
      for (Index h = 0; h < faces_.half_edges(); ++h) {
        if (faces_.left_of(h) != old_face) continue;
        const HalfEdge wanted{image_of(faces_.ends(h).a), image_of(faces_.ends(h).b)};
        for (Index g = 0; g < faces.half_edges(); ++g)
          if (faces.ends(g) == wanted && faces.left_of(g) != LatticeFaces::exterior) return g;
      }
      return no_index;
    };
    std::set<Index> taken;
    for (std::size_t h = 0; h < domain_.holes.size(); ++h) {
      const Index at = image.keeps_hole[h] ? image_of_face(face_of_hole_[h]) : no_index;
      if (at == no_index || !taken.insert(faces.left_of(at)).second) continue;
      result.holes.push_back(faces.seed_left_of(at));
    }
    for (std::size_t r = 0; r < domain_.regions.size(); ++r) {
      const Index at = image.keeps_region[r] ? image_of_face(face_of_region_[r]) : no_index;
      if (at == no_index || !taken.insert(faces.left_of(at)).second) continue;
      LatticeRegion& region = result.regions.emplace_back(domain_.regions[r]);
      region.seed = faces.seed_left_of(at);
    }
    return result.holes.size() + 1 < faces.count();  // each hole has its own face, never the exterior
  }

  const LatticeDomain& domain_;
  LatticeFaces faces_;
  std::vector<Index> face_of_hole_, face_of_region_;
  std::vector<LatticeDomain> simpler_;
};

}  // namespace

std::vector<LatticeDomain> shrinks(const LatticeDomain& domain) { return Shrinker(domain).all(); }

}  // namespace pardel::generators
