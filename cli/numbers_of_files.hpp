// The numbers that vertices, triangles, points and segments have in the files of a mesh and of its domain.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "../core/mesh.hpp"
#include "../core/pslg.hpp"

namespace pardel::cli {

/// The checker counts from 0. Keeps a reference to the mesh.
class NumbersOfFiles {
 public:
  /// Of a domain, and of a mesh that counts from 0.
  explicit NumbersOfFiles(FirstId of_domain) : of_domain_(of_domain) {}
  NumbersOfFiles(FirstId of_domain, const Mesh& mesh) : of_domain_(of_domain), mesh_(&mesh) {}

  /// What the checker says in a sentence or in its summary, with the numbers of the files. Numbers of things follow one
  /// blank after "vertex", "edge", "triangle", "point", "segment", "hole" or "region". O(length).
  [[nodiscard]] std::string in_sentence(std::string_view sentence) const;

 private:
  [[nodiscard]] std::uint64_t vertex(std::uint64_t index) const;
  [[nodiscard]] std::uint64_t triangle(std::uint64_t index) const;
  [[nodiscard]] std::uint64_t of_input(std::uint64_t index) const;

  FirstId of_domain_;
  const Mesh* mesh_ = nullptr;
};

}  // namespace pardel::cli
