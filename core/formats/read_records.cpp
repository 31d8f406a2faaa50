#include "read_records.hpp"

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <optional>

#include "../support/exception_of.hpp"

namespace pardel::files {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18;

/// The lines of which the first byte is in block b of the text.
std::string_view lines_of_block(std::string_view text, std::size_t b) {
  const auto line_after = [&](std::size_t at) {
    if (at == 0 || at >= text.size()) return std::min(at, text.size());
    return std::min(text.find('\n', at - 1), text.size() - 1) + 1;
  };
  const std::size_t begin = line_after(b * block_bytes);
  return text.substr(begin, line_after((b + 1) * block_bytes) - begin);
}

/// What is known of the records before a block, or in a block.
struct Count {
  std::size_t records = 0;
  std::size_t lines = 0;
};

Count count_in(std::string_view lines) {
  TextReader in(lines, {});
  Count count;
  while (in.next_line()) ++count.records;
  count.lines = in.line() - 1;
  return count;
}

}  // namespace

void read_blocks(TextReader& in, std::size_t first, std::size_t n,
                 const std::function<void(TextReader&, std::size_t, std::size_t)>& read) {
  constexpr std::size_t few_records = 4096;
  const int threads = omp_get_max_threads();
  const bool few = n < first + few_records || in.rest().size() < 2 * block_bytes;
  if (threads == 1 || few || in.failed()) return read(in, first, n);

  in.leave_line();
  const std::string_view text = in.rest();
  const std::size_t blocks = (text.size() + block_bytes - 1) / block_bytes;
  Count before{first, in.line()};          // the records and lines before the next block
  std::atomic<std::size_t> last = blocks;  // the block with the last record, or the first one with a failure
  std::optional<TextReader> end;           // the reader of that block
  std::exception_ptr failure;
#pragma omp parallel for ordered schedule(dynamic, 1) num_threads(threads)
  for (std::size_t b = 0; b < blocks; ++b) {
    if (b > last) continue;
    const std::string_view lines = lines_of_block(text, b);
    const Count count = count_in(lines);
    Count mine;
#pragma omp ordered
    {
      mine = before;
      before = {before.records + count.records, before.lines + count.lines};
    }
    const std::size_t stop = std::min(mine.records + count.records, n);
    std::optional<TextReader> reader;
    const std::exception_ptr thrown = exception_of([&] {
      reader = in.part(lines, mine.lines);
      read(*reader, std::min(mine.records, n), stop);
    });
    if (thrown || reader->failed() || stop == n) {
#pragma omp critical(pardel_read_blocks)
      if (b < last) {
        last = b;
        end = std::move(reader);
        failure = thrown;
      }
    }
  }
  if (failure) std::rethrow_exception(failure);
  if (end) return in.go_on_after(*end);
  in.skip(text.size());
  read(in, before.records, n);  // fails: there are too few records
}

}  // namespace pardel::files
