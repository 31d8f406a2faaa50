// Reads many records fast: all threads read blocks of lines.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "text_reader.hpp"

namespace pardel::files {

/// Reads records `first` to n - 1, of one line each: calls read(in, begin, end) for records `begin` to `end` - 1. If
/// there are many, several threads make the calls, with a reader for each block of lines. The calls must not depend on
/// each other. Afterwards `in` is in the line of the last record, or has the failure of the first record that has one,
/// as if one thread had read everything.
void read_blocks(TextReader& in, std::size_t first, std::size_t n,
                 const std::function<void(TextReader&, std::size_t, std::size_t)>& read);

/// The same with one call read(in, i) per record, whose line is the current line of `in`. `what` is for messages: see
/// TextReader::expect_record().
template <class Read>
void read_records(TextReader& in, std::string_view what, std::size_t first, std::size_t n, const Read& read) {
  read_blocks(in, first, n, [&](TextReader& lines, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && lines.expect_record(what, i, n); ++i) read(lines, i);
  });
}

}  // namespace pardel::files
