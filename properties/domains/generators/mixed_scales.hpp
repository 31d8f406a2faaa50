// Domains that mix scales. A domain of the families has features of about one scale. Here it gets points that lie far
// away, a huge outline, another domain that is much smaller or far off, or a tiny feature. One far point may then
// change nothing elsewhere, and a tiny part must get the mesh that it has alone.
//
//     const Mixed mixed = mixed_scales(domain, other, random);
//     // mixed.pslg is valid, and needs about as many triangles as the domains of mixed.parts together.
#pragma once

#include <cstdint>
#include <vector>

#include "../../../core/pslg.hpp"
#include "random.hpp"

namespace pardel::generators {

/// What was done to a domain.
enum class Mixture : std::uint8_t {
  far_points_outside,  ///< points without segments far outside of the domain; they are in no triangle
  far_points_inside,   ///< a huge outline around the domain, with points without segments far out in it
  far_points_of_hull,  ///< far points around the convex hull that is the domain
  component_beside,    ///< another domain beside it, scaled by a power of two
  component_in_hole,   ///< the same in a hole
  component_in_face,   ///< the same somewhere inside of the bounding box, mostly in a face of the domain
  component_far_off,   ///< another domain far from the origin
  tiny_feature,        ///< a tiny outline, crack or pair of points, mostly in a face of the domain
};
/// All mixtures, in the order of the enumeration.
[[nodiscard]] const std::vector<Mixture>& all_mixtures();
/// The name of the enumerator, for example "tiny_feature".
[[nodiscard]] const char* name(Mixture mixture);

struct Mixed {
  Pslg pslg;                  ///< valid, if the two domains are
  std::vector<Mixture> what;  ///< empty if nothing could be done
  /// Valid domains in which scales differ less. Together they need about as many triangles.
  /// Two of them are the components: the points and segments of the first one come first, then those of the second one.
  std::vector<Pslg> parts;
  bool enlarges = false;  ///< there may be faces that are larger than those of the domain: bounds on areas mean no more
  bool is_tiny = false;   ///< features are so small that edges of the least possible length may be needed
};

/// Mixes the scales of a domain at random: one mixture, and sometimes far points outside besides. Coordinates are 0, or
/// 2^-140 to 2^200 in magnitude, and nothing is rounded: parts are moved and scaled by powers of two, and what that
/// would round is not done. `other` is a second domain, which may be the same one; it is scaled by up to 2^60 and used
/// as a component. `allows_tiny`: features may be as small as coordinates can be. `mixtures`: those that may be chosen.
/// Points of `other` get as many attributes as those of the domain have, and markers if those have some.
/// Precondition: both are valid.
[[nodiscard]] Mixed mixed_scales(const Pslg& domain, const Pslg& other, Random& random, bool allows_tiny = false,
                                 const std::vector<Mixture>& mixtures = all_mixtures());

}  // namespace pardel::generators
