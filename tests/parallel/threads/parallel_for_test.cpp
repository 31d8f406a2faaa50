#include "../../../parallel/threads/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <new>
#include <optional>
#include <thread>
#include <vector>

namespace pardel::engine {
namespace {

TEST(ParallelFor, calls_the_body_once_for_each_item) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> calls(1000, 0);
    parallel_for(threads, calls.size(), [&](std::size_t i, int thread) {
      ++calls[i];
      EXPECT_GE(thread, 0);
      EXPECT_LT(thread, threads);
    });
    EXPECT_EQ(calls, std::vector<int>(1000, 1));
  }
}

TEST(FirstException, is_before_later_items_only) {
  FirstException first;
  EXPECT_FALSE(first.is_before(5));
  first.guard(3, [] { throw 3; });
  EXPECT_FALSE(first.is_before(2));
  EXPECT_FALSE(first.is_before(3)) << "other parts of this item still run";
  EXPECT_TRUE(first.is_before(4));
  first.guard(4, [] { throw 4; });
  try {
    first.rethrow();
    ADD_FAILURE() << "nothing was thrown";
  } catch (int item) {
    EXPECT_EQ(item, 3);
  }
}

TEST(ThreadCount, is_the_number_that_is_wanted_or_all) {
  omp_set_num_threads(5);
  EXPECT_EQ(thread_count(2), 2);
  EXPECT_EQ(thread_count(0), 5);
}

TEST(ThreadCount, is_one_for_few_items_unless_a_number_is_wanted) {
  omp_set_num_threads(5);
  EXPECT_EQ(thread_count(0, fewest_for_threads - 1), 1);
  EXPECT_EQ(thread_count(0, fewest_for_threads), 5);
  EXPECT_EQ(thread_count(2, 1), 2);
}

TEST(ParallelFor, throws_the_exception_of_the_first_item_that_throws) {
  for (const int threads : {1, 2, 4}) {
    for (int repeat = 0; repeat < 20; ++repeat) {
      std::atomic<std::size_t> before{0};
      try {
        parallel_for(threads, 100, [&](std::size_t i, int) {
          if (i < 40) ++before;
          if (i >= 40) throw i;
        });
        ADD_FAILURE() << "nothing was thrown";
      } catch (std::size_t item) {
        EXPECT_EQ(item, 40U);
      }
      EXPECT_EQ(before, 40U) << "every earlier item is done";
    }
  }
}

TEST(ParallelFor, skips_the_items_after_one_that_throws) {
  std::size_t calls = 0;
  EXPECT_THROW(parallel_for(1, 10,
                            [&](std::size_t i, int) {
                              ++calls;
                              if (i == 3) throw std::bad_alloc();
                            }),
               std::bad_alloc);
  EXPECT_EQ(calls, 4U);
}

/// The items that start after item number 100 wait for the stop. So each other thread starts one of them at most.
TEST(ParallelFor, starts_no_item_after_the_run_was_stopped) {
  for (const int threads : {1, 2, 4}) {
    StopSignal stop({});
    std::atomic<int> started{0}, started_after{0};
    std::atomic<bool> stopped{false};
    const auto loop = [&] {
      parallel_for(Threads(threads, &stop), 1000, [&](std::size_t, int) {
        if (stopped) ++started_after;
        const int number = ++started;
        if (number < 100) return;
        if (number > 100) return stopped.wait(false);
        stop.stop({ErrorKind::cancelled, "stop"});
        stopped = true;
        stopped.notify_all();
      });
    };
    EXPECT_THROW(loop(), Stopped);
    EXPECT_LT(started_after, threads) << "an item that another thread was about to start";
    EXPECT_LT(started, 100 + threads);
  }
}

/// The item of thread 1 ends only after the caller has been asked more often than thread 0 has items.
TEST(ParallelFor, asks_the_caller_while_only_other_threads_work) {
  constexpr int items = 8;
  std::atomic<bool> other_works{false};
  int asked = 0;
  StopSignal stop(
      [&]() -> std::optional<Error> {
        if (!other_works || ++asked <= items) return {};
        return Error{ErrorKind::cancelled, "stop"};
      },
      std::chrono::seconds(0));
  const Threads threads(2, &stop);
  const auto loops = [&] {
    for (;;)
      parallel_for(threads, items, [&](std::size_t, int thread) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (thread == 0) return;
        other_works = true;
        for (;;) threads.ask();
      });
  };
  EXPECT_THROW(loops(), Stopped);
  EXPECT_EQ(asked, items + 1);
}

TEST(ParallelRuns, visit_each_item_once_and_consecutive_items_in_one_thread) {
  for (const std::size_t n : {0UL, 1UL, 5UL, 16UL, 100UL, 1000UL}) {
    std::vector<int> visits(n);
    std::vector<std::thread::id> by(n);
    parallel_runs(2, n, [&](std::size_t i) {
      ++visits[i];
      by[i] = std::this_thread::get_id();
    });
    EXPECT_EQ(visits, std::vector<int>(n, 1));
    std::size_t changes = 0;
    for (std::size_t i = 1; i < n; ++i) changes += by[i] != by[i - 1];
    EXPECT_LE(changes, 15U) << "there are 16 runs";
  }
}

TEST(ParallelRuns, throw_the_exception_of_the_first_item_that_throws) {
  for (int round = 0; round < 20; ++round) {
    const auto run = [] {
      parallel_runs(2, 1000, [](std::size_t i) {
        if (i % 100 == 37) throw static_cast<int>(i);
      });
    };
    try {
      run();
      ADD_FAILURE() << "no exception";
    } catch (int item) {
      EXPECT_EQ(item, 37);
    }
  }
}

TEST(ParallelBlocks, divide_the_items_into_consecutive_blocks) {
  const std::size_t n = 2 * items_in_block + 5;
  ASSERT_EQ(block_count(n), 3U);
  EXPECT_EQ(block_count(0), 0U);
  std::vector<std::size_t> first(3), last(3);
  parallel_blocks(2, n, [&](std::size_t from, std::size_t to, std::size_t block) {
    first[block] = from;
    last[block] = to;
  });
  EXPECT_EQ(first, (std::vector<std::size_t>{0, items_in_block, 2 * items_in_block}));
  EXPECT_EQ(last, (std::vector<std::size_t>{items_in_block, 2 * items_in_block, n}));
}

}  // namespace
}  // namespace pardel::engine
