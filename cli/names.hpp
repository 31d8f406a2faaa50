// The names of enumerators on the command line and in the JSON report.
#pragma once

#include "../core/support/enum_names.hpp"
#include "../parallel/options.hpp"
#include "drawing/colouring.hpp"
#include "output.hpp"
#include "progress_bar.hpp"

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

inline constexpr auto stream_format_names = enum_names<StreamFormat>({
    {StreamFormat::msh, "msh"},
    {StreamFormat::off, "off"},
    {StreamFormat::svg, "svg"},
    {StreamFormat::vtu, "vtu"},
});

inline constexpr auto colour_names = enum_names<ColourBy>({
    {ColourBy::quality, "quality"},
    {ColourBy::size, "size"},
    {ColourBy::region, "region"},
    {ColourBy::tile, "tile"},
    {ColourBy::phase, "phase"},
    {ColourBy::thread, "thread"},
});

}  // namespace pardel::cli
