// Text that several ranks write into one file. No rank holds all of it, nor all of its own part.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "../support/shared_files.hpp"
#include "records.hpp"

namespace pardel::files {

/// What one rank has of a part of the text.
struct TextPart {
  std::size_t records = 0;
  /// Appends the text of a record. Called twice for each record, by several threads.
  std::function<void(Bytes&, std::size_t)> put;
};

/// Collective. Writes the parts one after another, and in each part the records of rank 0 first, then those of rank 1,
/// and so on. All ranks pass equally many parts. Each rank formats its records twice, first to learn how long they are.
void write_shared_text(SharedFiles& files, std::size_t file, std::span<const TextPart> parts, Ranks& ranks);

}  // namespace pardel::files
