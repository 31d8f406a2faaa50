#include "expansion.hpp"

#include <algorithm>

namespace pardel::schemes {
namespace {

bool holds(const std::vector<Index>& triangles, Index t) { return std::ranges::find(triangles, t) != triangles.end(); }

}  // namespace

Index Expansion::next(const LinkedMesh& mesh) {
  if (triangles_.size() < starts_.size()) return starts_[triangles_.size()];
  for (; at_ < 3 * triangles_.size(); ++at_) {
    const Side side = cursor();
    const Index other = mesh.faces[side.triangle].n[side.i];
    if (other == no_index || holds(triangles_, other) || holds(rejected_, other)) continue;
    if (!is_constrained(mesh, side) || !holds(beyond_, other)) return other;
  }
  return no_index;
}

bool Expansion::joins(const LinkedMesh& mesh, Index next) const {
  if (triangles_.size() < starts_.size()) return true;
  return !is_constrained(mesh, cursor()) && circumdisk_contains(mesh, next, p_);
}

void Expansion::visit(const LinkedMesh& mesh, Index next) {
  if (triangles_.size() < starts_.size()) {
    triangles_.push_back(next);
  } else if (is_constrained(mesh, cursor())) {
    beyond_.push_back(next);
  } else {
    (circumdisk_contains(mesh, next, p_) ? triangles_ : rejected_).push_back(next);
  }
}

Cavity Expansion::cavity(const LinkedMesh& mesh) const { return {triangles_, boundary_of(mesh, triangles_)}; }

}  // namespace pardel::schemes
