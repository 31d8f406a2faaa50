// Reads the documents of the project (Markdown).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pardel::testing {

/// The text of a file of the project; the path is relative to the project's root.
[[nodiscard]] std::string read_document(const std::filesystem::path& file);

[[nodiscard]] std::vector<std::string> lines_of(const std::string& text);

/// A document without its fenced blocks of code.
[[nodiscard]] std::string without_code(const std::string& text);

/// The contents of the fenced code blocks in a language; "" selects the blocks without a language.
[[nodiscard]] std::vector<std::string> code_blocks(const std::string& text, const std::string& language);

[[nodiscard]] std::string without_indentation(const std::string& text);

}  // namespace pardel::testing
