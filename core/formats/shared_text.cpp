#include "shared_text.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "../support/exception_of.hpp"

namespace pardel::files {
namespace {

/// Some records of a part.
struct Block {
  std::size_t part, begin, end;
  std::uint64_t bytes = 0;
};

std::vector<Block> blocks_of(std::span<const TextPart> parts) {
  constexpr std::size_t most_records = 8192;
  std::vector<Block> blocks;
  for (std::size_t part = 0; part < parts.size(); ++part)
    for (std::size_t begin = 0; begin < parts[part].records; begin += most_records)
      blocks.push_back({part, begin, std::min(begin + most_records, parts[part].records)});
  return blocks;
}

/// Calls use(b, text) for all blocks with their texts.
template <class Use>
void format(std::span<const TextPart> parts, std::span<const Block> blocks, const Use& use) {
  std::exception_ptr failure;
#pragma omp parallel
  {
    Bytes text;
#pragma omp for schedule(dynamic, 1)
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const Block& block = blocks[b];
      const std::exception_ptr mine = exception_of([&] {
        text.clear();
        for (std::size_t i = block.begin; i < block.end; ++i) parts[block.part].put(text, i);
        use(b, text.view());
      });
      if (!mine) continue;
#pragma omp critical(pardel_shared_text)
      if (!failure) failure = mine;
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace

void write_shared_text(SharedFiles& files, std::size_t file, std::span<const TextPart> parts, Ranks& ranks) {
  std::vector<Block> blocks = blocks_of(parts);
  format(parts, blocks, [&](std::size_t b, std::string_view text) { blocks[b].bytes = text.size(); });
  const auto count = static_cast<std::size_t>(ranks.count()), rank = static_cast<std::size_t>(ranks.rank());
  std::vector<std::uint64_t> place(parts.size() * count, 0);  // per part and rank: the size, then where it begins
  for (const Block& block : blocks) place[block.part * count + rank] += block.bytes;
  ranks.add_up(place);
  std::exclusive_scan(place.begin(), place.end(), place.begin(), std::uint64_t{0});
  std::vector<std::uint64_t> offset;
  for (const Block& block : blocks) {
    std::uint64_t& next = place[block.part * count + rank];
    offset.push_back(next);
    next += block.bytes;
  }
  format(parts, blocks, [&](std::size_t b, std::string_view text) { files.write_at(file, offset[b], text); });
}

}  // namespace pardel::files
