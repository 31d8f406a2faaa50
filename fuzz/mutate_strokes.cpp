// The mutator and the cross-over of the targets that decode a meshing problem (mesh_case.hpp). They treat strokes as
// wholes: segments, fans, holes and regions are inserted, copied, removed, exchanged and moved, and the cross-over
// draws strokes of two domains into one. Most mutations of libFuzzer itself shift the bytes behind them, and so draw an
// unrelated domain.
#include <algorithm>
#include <cstring>
#include <vector>

#include "../properties/domains/generators/random.hpp"
#include "mesh_case.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace pardel::fuzz {
namespace {

using generators::Random;
using Bytes = std::vector<std::uint8_t>;

/// The bytes of a case, divided into its header and its strokes.
struct Strokes {
  Bytes header;
  std::vector<Bytes> strokes;

  Strokes(const std::uint8_t* data, std::size_t size) : header(data, data + std::min(size, header_bytes)) {
    header.resize(header_bytes);
    for (std::size_t at = header_bytes; at < size; at += stroke_bytes) {
      strokes.emplace_back(data + at, data + std::min(size, at + stroke_bytes));
      strokes.back().resize(stroke_bytes);
    }
  }

  /// Writes as many strokes as there is space for. Returns the number of bytes.
  [[nodiscard]] std::size_t write(std::uint8_t* data, std::size_t max_size) const {
    std::size_t size = 0;
    const auto append = [&](const Bytes& bytes) {
      if (size + bytes.size() > max_size) return;
      std::memcpy(data + size, bytes.data(), bytes.size());
      size += bytes.size();
    };
    append(header);
    for (const Bytes& stroke : strokes) append(stroke);
    return size;
  }
};

Bytes random_stroke(Random& random) {
  Bytes stroke(stroke_bytes);
  for (std::uint8_t& byte : stroke) byte = static_cast<std::uint8_t>(random.next());
  return stroke;
}

void change_one_byte(Bytes& bytes, Random& random) {
  std::uint8_t& byte = bytes[random.below(bytes.size())];
  const auto step = static_cast<std::uint8_t>(random.between(1, 3));
  if (random.chance(2))
    byte = static_cast<std::uint8_t>(random.next());
  else
    byte = static_cast<std::uint8_t>(random.chance(2) ? byte + step : byte - step);
}

/// Bytes 1 to 4 are the coordinates of most strokes.
void move(Bytes& stroke, Random& random) {
  const auto dx = static_cast<std::uint8_t>(random.between(-2, 2)),
             dy = static_cast<std::uint8_t>(random.between(-2, 2));
  for (const std::size_t i : {1U, 3U}) {
    stroke[i] = static_cast<std::uint8_t>(stroke[i] + dx);
    stroke[i + 1] = static_cast<std::uint8_t>(stroke[i + 1] + dy);
  }
}

/// Random bytes. In one of two cases most bytes remain zero: then most options keep their defaults.
void draw_header(Bytes& header, Random& random) {
  const bool few = random.chance(2);
  for (std::uint8_t& byte : header) byte = few && !random.chance(6) ? byte : static_cast<std::uint8_t>(random.next());
}

void mutate(Strokes& drawn, Random& random) {
  auto& strokes = drawn.strokes;
  const auto place = [&] { return strokes.begin() + static_cast<std::ptrdiff_t>(random.below(strokes.size() + 1)); };
  const std::size_t kind = random.below(10);
  if (kind == 9) {
    for (std::size_t i = 0; i < seed_bytes; ++i) drawn.header[i] = static_cast<std::uint8_t>(random.next());
  } else if (kind == 8 && random.chance(3)) {
    draw_header(drawn.header, random);
  } else if (kind == 0 || kind == 8 || strokes.empty()) {
    change_one_byte(drawn.header, random);
  } else if (kind == 1) {
    strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(random.below(strokes.size())));
  } else if (kind == 2) {
    Bytes copy = random.one_of(strokes);
    move(copy, random);
    strokes.insert(place(), std::move(copy));
  } else if (kind == 3) {
    move(strokes[random.below(strokes.size())], random);
  } else if (kind == 4) {
    std::swap(strokes[random.below(strokes.size())], strokes[random.below(strokes.size())]);
  } else if (kind <= 6) {
    change_one_byte(strokes[random.below(strokes.size())], random);
  }
  if (kind == 7 || strokes.empty()) strokes.insert(place(), random_stroke(random));
}

}  // namespace
}  // namespace pardel::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  using namespace pardel::fuzz;
  Random random(seed);
  if (random.chance(8)) return LLVMFuzzerMutate(data, size, max_size);
  Strokes drawn(data, size);
  if (size < header_bytes) draw_header(drawn.header, random);
  do mutate(drawn, random);
  while (random.chance(2));
  if (drawn.strokes.size() > most_strokes) drawn.strokes.resize(most_strokes);
  return drawn.write(data, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data1, std::size_t size1,
                                                 const std::uint8_t* data2, std::size_t size2, std::uint8_t* out,
                                                 std::size_t max_out_size, unsigned seed) {
  using namespace pardel::fuzz;
  Random random(seed);
  const Strokes first(data1, size1), second(data2, size2);
  Strokes child = random.chance(2) ? first : second;
  child.strokes.clear();
  // Either each stroke of both with equal chances, or the beginning of one and the end of the other.
  if (random.chance(2)) {
    for (const Strokes* parent : {&first, &second})
      for (const Bytes& stroke : parent->strokes)
        if (random.chance(2)) child.strokes.push_back(stroke);
  } else {
    const auto cut1 = static_cast<std::ptrdiff_t>(random.below(first.strokes.size() + 1));
    const auto cut2 = static_cast<std::ptrdiff_t>(random.below(second.strokes.size() + 1));
    child.strokes.assign(first.strokes.begin(), first.strokes.begin() + cut1);
    child.strokes.insert(child.strokes.end(), second.strokes.begin() + cut2, second.strokes.end());
  }
  if (child.strokes.size() > most_strokes) child.strokes.resize(most_strokes);
  return child.write(out, max_out_size);
}
