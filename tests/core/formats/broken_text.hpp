// Texts of files with one mistake, and the errors that they cause.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "../../../core/result.hpp"

namespace pardel {

/// The text with the first `from` replaced by `to`. The test fails if there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// The message of a result that must be an `invalid_input` error; "(no error)" if it is none.
template <class T>
std::string message_of_invalid(const Result<T>& result) {
  if (result.ok()) return "(no error)";
  EXPECT_EQ(result.error().kind, ErrorKind::invalid_input);
  return result.error().message;
}

}  // namespace pardel
