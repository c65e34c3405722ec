/// \file
/// \brief Threads that bring chains to their ends.
#include "tumble/previous_work/parallel_chains.hpp"

#include "tumble/base/error.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace tumble {
namespace {

// What the threads share.
struct SharedWork {
  std::mutex mutex;                 // held where a chain is changed or read
  std::condition_variable changed;  // a chain, or the number of threads
  std::size_t next = 0;             // chain to be taken
  std::size_t running = 0;          // threads
  std::exception_ptr thrown;
};

void work(std::span<NoiseChain> chains, const ChainGoal& goal, const SimulateNoise& simulate,
          std::atomic<bool>& stop, SharedWork& shared) {
  // [S2.4.2:work]
  std::unique_lock lock(shared.mutex);
  while (shared.next < chains.size()) {
    NoiseChain& chain = chains[shared.next++];
    while (!stop && !is_done(chain, goal)) {
      lock.unlock();  // others may read the chain meanwhile: propose() only reads, too
      NoiseChain::Step step;
      std::exception_ptr thrown;
      try {
        step = chain.propose(simulate);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      try {
        if (thrown) std::rethrow_exception(thrown);
        chain.take(std::move(step));
      } catch (...) {
        if (!shared.thrown) shared.thrown = std::current_exception();
        stop = true;
      }
      shared.changed.notify_all();
    }
  }
  --shared.running;
  shared.changed.notify_all();
  // [S2.4.2:work]
}

}  // namespace

bool is_done(const NoiseChain& chain, const ChainGoal& goal) {
  return static_cast<std::int64_t>(chain.found().size()) >= goal.found ||
         static_cast<std::int64_t>(chain.proposals().size()) >= goal.proposals;
}

void run_chains(std::span<NoiseChain> chains, const ChainGoal& goal, const SimulateNoise& simulate,
                int cores, std::atomic<bool>& stop, const std::function<void()>& watch) {
  require::that(cores >= 1, "cores = " + std::to_string(cores) + ": expected 1 or more");
  SharedWork shared;
  shared.running = std::min(static_cast<std::size_t>(cores), chains.size());
  std::vector<std::thread> threads;
  const std::size_t count = shared.running;
  for (std::size_t k = 0; k < count; ++k) {
    try {
      threads.emplace_back([&] { work(chains, goal, simulate, stop, shared); });
    } catch (
        const std::system_error&) {  // the system has no more threads: those that there are will do
      if (k == 0) throw;
      const std::lock_guard lock(shared.mutex);
      shared.running -= count - k;
      break;
    }
  }
  {
    std::unique_lock lock(shared.mutex);
    try {
      while (true) {
        if (watch && !shared.thrown) watch();
        if (shared.running == 0) break;
        shared.changed.wait(lock);
      }
    } catch (...) {
      if (!shared.thrown) shared.thrown = std::current_exception();
      stop = true;
    }
  }
  for (std::thread& thread : threads) thread.join();
  if (shared.thrown) std::rethrow_exception(shared.thrown);
}

}  // namespace tumble
