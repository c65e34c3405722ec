/// \file
/// \brief The parts that all forms of the synchronised timewarp have.
#pragma once

#include "tumble/timewarp/timewarp_frame.hpp"

namespace tumble {

/// A synchronised timewarp without its main loop: a frame, the queue of collisions, a watcher.
class SynchronisedTimewarp : public Technique {
 public:
  [[nodiscard]] std::span<const ContactRecord> contacts() const override {
    return frame_.contacts();
  }

  /// Shows the queue, collision by collision.
  /// \param watcher  nullptr: none. Not owned
  void watch(TimewarpWatcher* watcher) { watcher_ = watcher; }

 protected:
  /// Makes the storage.
  /// \param options see there
  /// \param method  which pairs are searched, and how
  /// \throws std::invalid_argument for a resolution not above 0 or less than one event a pair
  SynchronisedTimewarp(const TimewarpOptions& options, SearchMethod method)
      : frame_(options, method) {}

  TimewarpFrame frame_;                 ///< one frame
  CollisionHeap collision_heap_;        ///< the queue
  TimewarpWatcher* watcher_ = nullptr;  ///< see watch()
};

}  // namespace tumble
