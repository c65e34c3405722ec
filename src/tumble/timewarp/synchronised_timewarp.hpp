/// \file
/// \brief Common base of all forms of the synchronised timewarp.
#pragma once

#include "tumble/timewarp/timewarp_frame.hpp"

namespace tumble {

/// A synchronised timewarp without its main loop: frame, queue of collisions, watcher.
class SynchronisedTimewarp : public Technique {
 public:
  [[nodiscard]] std::span<const ContactRecord> contacts() const override {
    return frame_.contacts();
  }

  /// Sets an observer of the queue, called after each collision.
  /// \param watcher  nullptr: none. Not owned
  void watch(TimewarpWatcher* watcher) { watcher_ = watcher; }

 protected:
  /// Makes the technique.
  /// \param method  which pairs are searched, and how
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  SynchronisedTimewarp(const TimewarpOptions& options, SearchMethod method)
      : frame_(options, method) {}

  TimewarpFrame frame_;                 ///< one frame
  CollisionHeap collision_heap_;        ///< the queue
  TimewarpWatcher* watcher_ = nullptr;  ///< see watch()
};

}  // namespace tumble
