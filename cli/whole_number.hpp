// Options whose value is any whole number, such as a seed.
#pragma once

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

namespace pardel::cli {

/// CLI11 takes negative numbers modulo 2^64, 2^64 - 1 for larger numbers, and numbers that begin with 0 as octal ones.
[[nodiscard]] inline CLI::Validator whole_number() {
  return {[](std::string& text) -> std::string {
            std::uint64_t value = 0;
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
            if (error == std::errc() && end == text.data() + text.size()) {
              text = std::to_string(value);
              return {};
            }
            return fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text);
          },
          ""};
}

}  // namespace pardel::cli
