#include "drawn_lengths.hpp"

#include <utility>

#include "input.hpp"
#include "read_geojson.hpp"

namespace pardel::cli {

Result<DrawnLengths> read_drawn_lengths(const std::filesystem::path& file, CrossingPolygons crossing) {
  Result<DrawnDomain> drawing = read_drawing(file, LengthProperty::read);
  if (!drawing) return drawing.error();
  return lengths_of(std::move(*drawing), file.string(), [&](FramedSides sides) -> Result<ValidPslg> {
    Domain domain{std::move(sides.pslg), file.string(), std::move(sides.points), true};
    const bool is_wrong = !find_problems(domain.pslg, {.convex_hull = true}).empty();
    const bool repair = is_wrong && crossing == CrossingPolygons::repaired;
    Result<MaybeRepaired, Refusal> valid = valid_domain(std::move(domain), repair, {.convex_hull = true}, 0);
    if (!valid) return valid.error().error;
    return std::move(valid->domain);
  });
}

}  // namespace pardel::cli
