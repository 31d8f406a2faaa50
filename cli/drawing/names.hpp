// The names of the enumerators of pictures on the command line.
#pragma once

#include "../../core/support/enum_names.hpp"
#include "canvas.hpp"
#include "colouring.hpp"

namespace pardel::cli {

inline constexpr auto picture_format_names = enum_names<PictureFormat>({
    {PictureFormat::svg, "svg"},
    {PictureFormat::png, "png"},
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
