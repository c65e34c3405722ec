/// \file
/// \brief Priority queue of predicted collisions, earliest first (thesis A.1: collisionHeap).
#include "tumble/timewarp/collision_heap.hpp"

#include "tumble/base/index.hpp"

#include <algorithm>

namespace tumble {

void CollisionHeap::reset(int bodies) {
  heap_.clear();
  forgotten_.assign(idx(bodies), 0);
}

void CollisionHeap::insert(const ForeseenCollision& collision) {
  const IndexPair& pair = collision.pair;
  heap_.push_back({collision, forgotten_[idx(pair.first)], forgotten_[idx(pair.second)]});
  std::push_heap(heap_.begin(), heap_.end(), later);
}

void CollisionHeap::forget(int body) {
  ++forgotten_[idx(body)];
  drop_forgotten();
}

ForeseenCollision CollisionHeap::remove_first() {
  const ForeseenCollision first = heap_.front().collision;
  std::pop_heap(heap_.begin(), heap_.end(), later);
  heap_.pop_back();
  drop_forgotten();
  return first;
}

std::vector<ForeseenCollision> CollisionHeap::entries() const {
  std::vector<ForeseenCollision> out;
  for (const Entry& entry : heap_)
    if (valid(entry)) out.push_back(entry.collision);
  std::sort(out.begin(), out.end());
  return out;
}

bool CollisionHeap::valid(const Entry& entry) const {
  const IndexPair& pair = entry.collision.pair;
  return entry.first_forgotten == forgotten_[idx(pair.first)] &&
         entry.second_forgotten == forgotten_[idx(pair.second)];
}

void CollisionHeap::drop_forgotten() {
  while (!heap_.empty() && !valid(heap_.front())) {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    heap_.pop_back();
  }
}

}  // namespace tumble
