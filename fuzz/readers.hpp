// The fuzz targets of all readers of files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace pardel::fuzz {

/// Tests the property on one input, as fuzz_one() (fuzz_one.hpp) of a target whose file has the name `main_file`: its
/// suffix chooses the reader.
int fuzz_reader(std::span<const std::uint8_t> bytes, const std::string& main_file);

}  // namespace pardel::fuzz
