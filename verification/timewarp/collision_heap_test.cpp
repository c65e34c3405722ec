/// \file
/// \brief The queue of predicted collisions against a list with linear search.
#include "tumble/timewarp/collision_heap.hpp"

#include "support/test.hpp"

namespace {

// By brute force: invalid entries are erased, the earliest is searched for.
class PlainList {
 public:
  void insert(const ForeseenCollision& collision) { all_.push_back(collision); }
  void forget(int body) {
    std::erase_if(all_, [&](const ForeseenCollision& c) {
      return c.pair.first == body || c.pair.second == body;
    });
  }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] ForeseenCollision first() const { return *std::ranges::min_element(all_); }
  ForeseenCollision remove_first() {
    const auto place = std::ranges::min_element(all_);
    const ForeseenCollision out = *place;
    all_.erase(place);
    return out;
  }
  [[nodiscard]] std::vector<ForeseenCollision> entries() const {
    std::vector<ForeseenCollision> out = all_;
    std::ranges::sort(out);
    return out;
  }

 private:
  std::vector<ForeseenCollision> all_;
};

}  // namespace

TEST_CASE("The queue yields the earliest collision and drops those of a body", "[unit][timewarp]") {
  constexpr int kBodies = 7;
  Random random(5);
  CollisionHeap heap;
  for (int round = 0; round < 50; ++round) {
    heap.reset(kBodies);  // no entries of the last round remain
    PlainList list;
    for (int k = 0; k < 200; ++k) {
      const std::uint32_t what = random.below(10);
      if (what < 6) {
        const int a = static_cast<int>(random.below(kBodies));
        const int b = (a + 1 + static_cast<int>(random.below(kBodies - 1))) % kBodies;
        // Few different times, so that many are equal.
        const ForeseenCollision collision{0.25 * static_cast<double>(random.below(6)),
                                          {std::min(a, b), std::max(a, b)}};
        heap.insert(collision);
        list.insert(collision);
      } else if (what < 8) {
        if (!list.empty()) REQUIRE(heap.remove_first() == list.remove_first());
      } else {
        const int body = static_cast<int>(random.below(kBodies));
        heap.forget(body);
        list.forget(body);
      }
      REQUIRE(heap.empty() == list.empty());
      if (!list.empty()) REQUIRE(heap.first() == list.first());
      if (k % 10 == 0) REQUIRE(heap.entries() == list.entries());
    }
  }
}

TEST_CASE("Collisions predicted after a body was invalidated stay in the queue",
          "[unit][timewarp]") {
  CollisionHeap heap;
  heap.reset(3);
  heap.insert({0.2, {0, 1}});
  heap.forget(0);
  CHECK(heap.empty());
  heap.insert({0.3, {0, 1}});
  heap.insert({0.1, {1, 2}});
  heap.forget(2);
  REQUIRE_FALSE(heap.empty());
  CHECK(heap.first() == ForeseenCollision{0.3, {0, 1}});
}
