// The names of enumerators on the command line and in the JSON report.
#pragma once

#include "../core/support/enum_names.hpp"
#include "../parallel/options.hpp"
#include "progress_bar.hpp"
#include "tile_hues.hpp"

namespace pardel::cli {

inline constexpr auto placement_names = enum_names<Placement>({
    {Placement::circumcentre, "circumcentre"},
    {Placement::off_centre, "off-centre"},
});
inline constexpr auto decomposition_names = enum_names<Decomposition>({
    {Decomposition::automatic, "auto"},
    {Decomposition::paper, "paper"},
    {Decomposition::none, "none"},
});
inline constexpr auto show_progress_names = enum_names<ShowProgress>({
    {ShowProgress::automatic, "auto"},
    {ShowProgress::always, "always"},
    {ShowProgress::never, "never"},
});

inline constexpr auto hue_names = enum_names<HueBy>({
    {HueBy::tile, "tile"},
    {HueBy::phase, "phase"},
    {HueBy::thread, "thread"},
});

}  // namespace pardel::cli
