// Names that vertices, triangles and segments have on all ranks. An index is valid on one rank only.
#pragma once

#include <cstdint>
#include <vector>

#include "../../parallel/threads/sparse_array.hpp"

namespace pardel::engine {

/// The name of a vertex, of a segment, or of the slot of a triangle: who created it, and its index there. Slots are
/// reused, so a name belongs to different triangles over time, but at any time to one triangle at most.
struct Name {
  /// What existed before the mesh was divided was created by all ranks alike.
  static constexpr std::uint32_t everyone = 0;
  [[nodiscard]] static constexpr std::uint32_t rank(int rank) { return static_cast<std::uint32_t>(rank) + 1; }

  /// The rank of a creator; the number of ranks, or one more, if it was made in a submesh.
  [[nodiscard]] static constexpr int rank_of(std::uint32_t creator) { return static_cast<int>(creator) - 1; }

  std::uint32_t creator = everyone;
  Index id = 0;
  friend bool operator==(const Name&, const Name&) = default;
};

/// The names of the vertices, or of the slots, of one rank. By default, the name of an index is this rank and the
/// index, or everyone and the index if it existed before the division. bind() gives an index the name that another rank
/// chose.
class Names {
 public:
  /// `common`: the number of indices that existed before the division.
  Names(std::uint32_t self, Index common) : self_(self), common_(common) {}

  /// Precondition: the index has not been released.
  [[nodiscard]] Name of(Index index) const {
    const std::uint64_t state = state_.get(index);
    return state < first_name ? default_name(index) : unpacked(state - first_name);
  }
  /// The index with this name; no_index if this rank does not hold it. A default name has its index even if the index
  /// is not used yet.
  [[nodiscard]] Index index_of(Name name) const {
    if (name == default_name(name.id) && state_.get(name.id) == has_default_name) return name.id;
    return name.creator < bound_.size() ? bound_[name.creator].get(name.id) - 1 : no_index;
  }
  /// Names an index. Precondition: the index is unused or has been released, and no index has this name.
  void bind(Name name, Index index) {
    if (name == default_name(index)) return state_.set(index, has_default_name);
    if (name.creator >= bound_.size()) bound_.resize(name.creator + 1);
    bound_[name.creator].set(name.id, index + 1);
    state_.set(index, packed(name) + first_name);
  }
  /// The index no longer has a name. It may get another one, but must not be used for something new of this rank, whose
  /// name other ranks may still use.
  void release(Index index) {
    if (const std::uint64_t state = state_.get(index); state >= first_name) {
      const Name name = unpacked(state - first_name);
      bound_[name.creator].set(name.id, 0);
    }
    state_.set(index, released);
  }

  [[nodiscard]] static constexpr std::uint64_t packed(Name name) {
    return std::uint64_t{name.creator} << 32U | name.id;
  }
  [[nodiscard]] static constexpr Name unpacked(std::uint64_t bits) {
    return {static_cast<std::uint32_t>(bits >> 32U), static_cast<Index>(bits)};
  }

 private:
  /// The states of an index; from first_name on, a name.
  static constexpr std::uint64_t has_default_name = 0, released = 1, first_name = 2;

  [[nodiscard]] Name default_name(Index index) const { return {index < common_ ? Name::everyone : self_, index}; }

  std::uint32_t self_;
  Index common_;
  SparseArray<std::uint64_t> state_;
  std::vector<SparseArray<Index>> bound_;  ///< for each creator and id: the index plus 1, or 0
};

}  // namespace pardel::engine
