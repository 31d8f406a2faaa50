// The names of enumerators on the command line and in the JSON report.
#pragma once

#include "../core/formats.hpp"
#include "../core/support/enum_names.hpp"
#include "../off_the_shelf/mesh_with_mesher.hpp"
#include "../parallel/options.hpp"
#include "progress_bar.hpp"

namespace pardel::cli {

inline constexpr auto placement_names = enum_names<Placement>({
    {Placement::circumcentre, "circumcentre"},
    {Placement::off_centre, "off-centre"},
    {Placement::search, "search"},
    {Placement::automatic, "auto"},
});
inline constexpr auto interior_names = enum_names<Interior>({
    {Interior::refine, "refine"},
    {Interior::fill, "fill"},
    {Interior::automatic, "auto"},
});
inline constexpr auto scheme_names = enum_names<Scheme>({
    {Scheme::frozen, "frozen"},
    {Scheme::cells, "cells"},
    {Scheme::decoupled, "decoupled"},
});
inline constexpr auto decomposition_names = enum_names<Decomposition>({
    {Decomposition::automatic, "auto"},
    {Decomposition::paper, "paper"},
    {Decomposition::none, "none"},
    {Decomposition::lattice, "lattice"},
    {Decomposition::quadtree, "quadtree"},
    {Decomposition::paper_quadtree, "paper-quadtree"},
});
inline constexpr auto show_progress_names = enum_names<ShowProgress>({
    {ShowProgress::automatic, "auto"},
    {ShowProgress::always, "always"},
    {ShowProgress::never, "never"},
});

/// Without the last enumerator: Triangle's files are several, which standard output would not separate.
inline constexpr EnumNames<MeshFormat, 8> stream_format_names{{"msh", "off", "svg", "vtu", "vtk", "2dm", "gr3", "inp"}};

}  // namespace pardel::cli
