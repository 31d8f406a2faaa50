// Random channels, refined on a lattice by the reference.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "../../../ref/decomposition/cell_refiner.hpp"
#include "../framework/property.hpp"
#include "../framework/rapidcheck_generators.hpp"
#include "../framework/shares.hpp"
#include "channels.hpp"

namespace pardel::properties {

inline constexpr const char* channel_families =
    "channels: bars, bends, rings and slants, with walls, cracks, area caps and moved corners; blocks of three by "
    "three "
    "cells and more";

using LatticeSweep = ref::Sweep<ref::Lattice>;

/// A random channel and its refinement on a lattice.
struct RefinedChannel {
  Channel channel;
  Pslg pslg;
  Goal goal;
  ref::LatticeRefinement result;
};

inline Channel some_channel(Exhibit& exhibit) {
  const auto simpler_channels = [](const Channel& c) { return simpler(c); };
  const Channel channel = *generators::generator(random_channel_or_block, simpler_channels);
  RC_TAG(std::string(name(channel.shape)));
  exhibit.show(to_pslg(channel));
  return channel;
}

/// The refinement of the channel, in which the cells of a phase take turns.
inline ref::LatticeRefinement refined_in_turns(const Channel& channel, const ref::Turns& turns) {
  auto result = ref::refine_on_lattice(to_pslg(channel), goal_of(channel), coarse_goal_of(channel), turns);
  if (!result) RC_FAIL(result.error().message);
  return std::move(*result);
}

/// A random channel. All cells of a phase insert one point in each step.
inline RefinedChannel refined_channel(Exhibit& exhibit) {
  const Channel channel = some_channel(exhibit);
  RefinedChannel refined{channel, to_pslg(channel), goal_of(channel), refined_in_turns(channel, ref::in_rounds)};
  exhibit.show(refined.pslg, refined.result.mesh);
  return refined;
}

/// Calls visit(sweep, phase, mesh at the start of the phase) for every phase.
template <class Cells, class Visit>
void for_each_phase(const ref::CellRefinement<Cells>& refinement, Visit visit) {
  const ref::PlainMesh* before = &refinement.preprocessed;
  for (const ref::Sweep<Cells>& sweep : refinement.sweeps)
    for (const ref::Phase& phase : sweep.phases) {
      visit(sweep, phase, *before);
      before = &phase.after;
    }
}

/// Counts the cases with a sweep in which some cell and all its eight neighbours insert points.
inline void classify_inner_cells(const ref::LatticeRefinement& refinement) {
  const auto has_inner_cell = [](const LatticeSweep& sweep) {
    std::set<ref::Cell> at_work;
    for (const ref::Phase& phase : sweep.phases)
      for (const ref::Insertion& insertion : phase.insertions) at_work.insert(insertion.cell);
    return std::ranges::any_of(at_work, [&](const ref::Cell& cell) {
      for (std::int64_t i = cell.i - 1; i <= cell.i + 1; ++i)
        for (std::int64_t j = cell.j - 1; j <= cell.j + 1; ++j)
          if (!at_work.contains({i, j})) return false;
      return true;
    });
  };
  classify(std::ranges::any_of(refinement.sweeps, has_inner_cell), "a cell and its eight neighbours insert points", 4);
}

/// Are the vertices of the cavities of every two cells disjoint, and also the triangles that two cells read or write?
inline bool cells_touch_nothing_in_common(const ref::Phase& phase) {
  std::map<ref::ExactPoint, ref::Cell> vertex_of;
  std::map<ref::Corners, ref::Cell> triangle_of;
  const auto belong_to = [](const ref::Cell& cell, const auto& elements, auto& cell_of) {
    return std::ranges::all_of(elements,
                               [&](const auto& each) { return cell_of.try_emplace(each, cell).first->second == cell; });
  };
  return std::ranges::all_of(phase.touched, [&](const auto& entry) {
    const auto& [cell, touched] = entry;
    return belong_to(cell, touched.vertices, vertex_of) && belong_to(cell, touched.triangles, triangle_of);
  });
}

}  // namespace pardel::properties
