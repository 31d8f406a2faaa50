// A stop signal ends a run, with the first error that it was given.
#include "../../../core/support/stop_signal.hpp"

#include <gtest/gtest.h>

#include <string>

namespace pardel {
namespace {

std::string message_of(StopSignal& signal) {
  try {
    signal.ask();
  } catch (const Stopped& stopped) {
    return stopped.error.message;
  }
  return "";
}

TEST(StopSignal, ends_a_run_with_the_first_error) {
  StopSignal signal(nullptr);
  EXPECT_EQ(message_of(signal), "");
  signal.stop({ErrorKind::cancelled, "the first"});
  signal.stop({ErrorKind::resources, "the second"});
  EXPECT_TRUE(signal.stopped());
  EXPECT_EQ(message_of(signal), "the first");
}

TEST(StopSignal, asks_its_question_again_only_after_the_interval) {
  int asked = 0;
  const auto question = [&] { return ++asked < 3; };
  StopSignal often(StopSignal::unless(question), std::chrono::seconds(0));
  EXPECT_EQ(message_of(often), "");
  EXPECT_EQ(message_of(often), "");
  EXPECT_EQ(message_of(often), "the caller asked to stop");
  asked = 0;
  StopSignal rarely(StopSignal::unless(question), std::chrono::hours(1));
  for (int i = 0; i < 100; ++i) EXPECT_EQ(message_of(rarely), "");
  EXPECT_EQ(asked, 1);
}

TEST(StopSignal, that_was_stopped_does_not_ask_any_more) {
  int asked = 0;
  StopSignal signal([&]() -> std::optional<Error> {
    ++asked;
    return {};
  });
  signal.stop({ErrorKind::cancelled, "enough"});
  EXPECT_THROW(signal.ask_now(), Stopped);
  EXPECT_THROW(signal.ask(), Stopped);
  EXPECT_EQ(asked, 0);
}

TEST(StopSignal, that_its_question_stops_says_so_at_once) {
  StopSignal signal([]() -> std::optional<Error> { return Error{ErrorKind::cancelled, "no"}; }, std::chrono::hours(1));
  EXPECT_THROW(signal.ask_now(), Stopped);
}

}  // namespace
}  // namespace pardel
