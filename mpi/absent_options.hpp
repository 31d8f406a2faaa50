// What the commands of pardel can do, and the same commands of pardel-mpi cannot.
#pragma once

#include <array>
#include <string_view>

#include "../cli/usage_message.hpp"

namespace pardel::mpi {

inline constexpr std::string_view no_standard_output =
    "the pieces of a mesh do not fit into standard output; write OUT.pvtu, and then use 'pardel convert'";

inline constexpr std::array<cli::AbsentOption, 9> absent_options = {{
    {"mesh", "--refine", "ranks begin with a domain, not with a mesh; use 'pardel mesh --refine'"},
    {"mesh", "--max-vertices",
     "ranks insert vertices at the same time, so the mesh at a limit would depend on their number; limit the memory of "
     "each rank with --max-memory, or use 'pardel mesh --max-vertices'"},
    {"mesh", "--paranoid",
     "no rank has the whole mesh that is checked after a sweep; use --check, or 'pardel mesh --paranoid'"},
    {"mesh", "--format", no_standard_output},
    {"mesh", "--order",
     "ranks write the corners of triangles only; write OUT.pvtu, and then use 'pardel convert --order 2'"},
    {"mesh", "--open-boundary",
     "ranks do not write the formats that have open boundaries; write OUT.pvtu, and then use 'pardel convert'"},
    {"mesh", "-j,--drop-unused",
     "the numbers of vertices in pieces begin with those of the input; write OUT.pvtu, and then use 'pardel convert "
     "--drop-unused'"},
    {"mesh", "--progress", "mpirun passes on the lines of all ranks, and a bar is not a line; there is no substitute"},
    {"check", "--progress", "mpirun passes on the lines of all ranks, and a bar is not a line; there is no substitute"},
}};

}  // namespace pardel::mpi
