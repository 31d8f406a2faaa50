#include "../../../parallel/refinement/bucket_queue.hpp"

#include <cmath>
#include <map>

#include "../../../properties/theorems/framework/property.hpp"

namespace pardel::engine {
namespace {

/// The least key comes first; among equal keys, the last one pushed.
class Model {
 public:
  void push(TriangleId id, unsigned key) { stacks_[key].push_back(id); }
  [[nodiscard]] bool empty() const { return stacks_.empty(); }
  TriangleId pop() {
    const auto least = stacks_.begin();
    const TriangleId id = least->second.back();
    least->second.pop_back();
    if (least->second.empty()) stacks_.erase(least);
    return id;
  }

 private:
  std::map<unsigned, std::vector<TriangleId>> stacks_;
};

PARDEL_PROPERTY(BucketQueue, behaves_like_a_map_of_stacks,
                {.statement = "the least key comes first; among equal keys, the entry that was pushed last",
                 .source = "parallel/refinement/bucket_queue.hpp",
                 .families = "few keys, near keys, all keys"}) {
  const auto pops = *rc::gen::arbitrary<std::vector<bool>>();
  BucketQueue queue;
  Model model;
  TriangleId id = 0;
  const auto any_key = rc::gen::oneOf(rc::gen::inRange(0U, 4U), rc::gen::inRange(4000U, 4200U),
                                      rc::gen::inRange(0U, BucketQueue::last + 1));
  for (const bool pop : pops) {
    RC_ASSERT(queue.empty() == model.empty());
    if (pop && !model.empty()) {
      RC_ASSERT(queue.pop().id() == model.pop());
    } else {
      const unsigned key = *any_key;
      queue.push({EdgeRef(++id, 0), 0}, key);
      model.push(id, key);
    }
  }
  while (!model.empty()) RC_ASSERT(queue.pop().id() == model.pop());
  RC_ASSERT(queue.empty());
}

TEST(BucketQueue, takes_the_first_and_the_last_key) {
  BucketQueue queue;
  queue.push({EdgeRef(1, 0), 10}, BucketQueue::last);
  queue.push({EdgeRef(2, 1), 20}, BucketQueue::urgent);
  const QueuedTriangle first = queue.pop(), second = queue.pop();
  EXPECT_EQ(first.id(), 2U);
  EXPECT_EQ(first.first_corner, 20U);
  EXPECT_EQ(second.id(), 1U);
  EXPECT_EQ(second.first_corner, 10U);
  EXPECT_TRUE(queue.empty());
}

TEST(BucketQueueKey, never_decreases_and_holds_a_quarter_of_an_octave) {
  unsigned before = BucketQueue::urgent;
  for (double length = 0x1p-1000; length < 0x1p1000; length *= 1.01) {
    const unsigned key = BucketQueue::key(length);
    EXPECT_GE(key, before);
    EXPECT_LT(key, BucketQueue::last);
    EXPECT_NE(key, BucketQueue::key(length * 1.26));
    before = key;
  }
  EXPECT_LT(BucketQueue::key(INFINITY), BucketQueue::last);
  EXPECT_EQ(BucketQueue::key(0), BucketQueue::urgent);
}

}  // namespace
}  // namespace pardel::engine
