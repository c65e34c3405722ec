/// \file
/// \brief The C interface of the WebAssembly module.
///
/// Texts go in through tumble_input() and come out of tumble_answer(). No exception leaves: a function that
/// can fail returns a status, and the sentence that says what to do is the answer.
#include "tumble/scenes/scene_file.hpp"

#include "catalogue.hpp"
#include "session.hpp"

#include <array>
#include <exception>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>

#ifdef __EMSCRIPTEN__
#include <emscripten/emscripten.h>
#define TUMBLE_EXPORT extern "C" EMSCRIPTEN_KEEPALIVE
#else
/// A function that the page calls by its own name.
#define TUMBLE_EXPORT extern "C"
#endif

namespace {

using namespace tumble;

/// What a function came to; the same numbers as the exit codes of the command `tumble`.
enum Status : int { kOk = 0, kBadInput = 2, kFailed = 3 };

constexpr int kSlots = 2;  // as many simulations side by side

std::string g_input;
std::string g_answer;
std::array<std::unique_ptr<live::Session>, kSlots> g_sessions;

bool is_open(int slot) {
  return slot >= 0 && slot < kSlots && g_sessions[static_cast<std::size_t>(slot)] != nullptr;
}

live::Session& session(int slot) {
  if (!is_open(slot))
    throw std::invalid_argument("tumble: no simulation is open there: open a scene first");
  return *g_sessions[static_cast<std::size_t>(slot)];
}

std::span<const double> seen(int slot, int what) {
  if (!is_open(slot)) return {};
  const live::Session& s = session(slot);
  return what == 0 ? s.bodies() : what == 1 ? s.contacts() : s.numbers();
}

// Runs something, and makes a status and a sentence of what it throws.
template <class Task>
int status_of(const Task& task) {
  try {
    task();
    return kOk;
  } catch (const std::invalid_argument& error) {
    g_answer = message_of(error);
    return kBadInput;
  } catch (const std::bad_alloc&) {
    g_answer = "the browser gives no more memory: choose a smaller scene";
    return kFailed;
  } catch (const std::exception& error) {
    g_answer = error.what();
    return kFailed;
  }
}

}  // namespace

/// Makes room for a text that is handed in.
/// \param bytes its length in UTF-8
/// \return where to write it; nullptr, with a sentence, if there is no such room
TUMBLE_EXPORT char* tumble_input(int bytes) {
  const int failed = status_of([&] { g_input.resize(static_cast<std::size_t>(bytes)); });
  return failed != kOk ? nullptr : g_input.data();
}

/// Where the answer is.
/// \return UTF-8 text of tumble_answer_size() bytes, until the next call
TUMBLE_EXPORT const char* tumble_answer() { return g_answer.data(); }

/// How long the answer is.
/// \return in bytes
TUMBLE_EXPORT int tumble_answer_size() { return static_cast<int>(g_answer.size()); }

/// Answers with tumble::live::catalogue().
/// \return 0
TUMBLE_EXPORT int tumble_catalogue() {
  return status_of([] { g_answer = live::catalogue(); });
}

/// Opens a simulation by the request in the input, see tumble::live::make_setup(). The one that was in
/// the slot goes, unless the request is refused. Answers with what the technique leaves out, by commas.
/// \param slot 0 or 1
/// \return 0, or 2 with a sentence
TUMBLE_EXPORT int tumble_open(int slot) {
  return status_of([&] {
    if (slot < 0 || slot >= kSlots) throw std::invalid_argument("slot: expected 0 or 1");
    auto opened = std::make_unique<live::Session>(g_input);
    g_answer.clear();
    for (const std::string& what : opened->ignored())
      g_answer.append(g_answer.empty() ? "" : ", ").append(what);
    g_sessions[static_cast<std::size_t>(slot)] = std::move(opened);
  });
}

/// Closes a simulation and gives its memory back.
/// \param slot 0 or 1
TUMBLE_EXPORT void tumble_close(int slot) {
  if (slot >= 0 && slot < kSlots) g_sessions[static_cast<std::size_t>(slot)].reset();
}

/// Steps a simulation.
/// \param slot   0 or 1
/// \param steps  how many
/// \param dt     [s] of each, above 0
/// \return 0; 2 with a sentence if the technique refuses; 3 with one after a step that broke off or left something
///         unsolved or not finite: no other step makes sense
TUMBLE_EXPORT int tumble_step(int slot, int steps, double dt) {
  int status = kOk;
  const int failed = status_of([&] {
    live::Session& opened = session(slot);
    for (int k = 0; k < steps && status == kOk; ++k) {
      if (opened.step(dt) < StepStatus::unsolved) continue;
      g_answer = "a step could not be solved: reset, or choose a shorter step";
      status = kFailed;
    }
  });
  return failed != kOk ? failed : status;
}

/// Throws a box into a simulation.
/// \param slot   0 or 1
/// \param edge   [m] its edges, above 0
/// \param mass   [kg] above 0
/// \param x      [m] its centre
/// \param y      [m]
/// \param z      [m]
/// \param vx     [m/s] its velocity
/// \param vy     [m/s]
/// \param vz     [m/s]
/// \return 0, or 2 with a sentence
TUMBLE_EXPORT int tumble_throw(int slot, double edge, double mass, double x, double y, double z,
                               double vx, double vy, double vz) {
  return status_of([&] {
    SceneBox box;
    box.size = Vec3::Constant(edge);
    box.mass = mass;
    box.position_w = Vec3(x, y, z);
    box.velocity_w = Vec3(vx, vy, vz);
    session(slot).throw_in(std::move(box));
  });
}

/// Takes a body out of a simulation.
/// \param slot  0 or 1
/// \param id    of the body, as in the numbers of a look
/// \return 0, or 2 with a sentence
TUMBLE_EXPORT int tumble_take_away(int slot, int id) {
  return status_of([&] { session(slot).take_away(static_cast<BodyId>(id)); });
}

/// Fills the numbers that tumble_seen() leads to.
/// \param slot    0 or 1
/// \param wanted  bits of tumble::live::Look
/// \return 0, or 2 with a sentence
TUMBLE_EXPORT int tumble_look(int slot, int wanted) {
  return status_of([&] { session(slot).look(static_cast<unsigned>(wanted)); });
}

/// Numbers of the last look.
/// \param slot  0 or 1
/// \param what  0 bodies, 1 contacts, 2 numbers
/// \return where they are, until the next call
TUMBLE_EXPORT const double* tumble_seen(int slot, int what) { return seen(slot, what).data(); }

/// How many numbers tumble_seen() leads to.
/// \param slot  0 or 1
/// \param what  as there
/// \return count of doubles; 0 if no simulation is open there
TUMBLE_EXPORT int tumble_seen_count(int slot, int what) {
  return static_cast<int>(seen(slot, what).size());
}

/// Answers with the state hash of a simulation, 16 hexadecimal digits.
/// \param slot 0 or 1
/// \return 0, or 2 with a sentence
TUMBLE_EXPORT int tumble_hash(int slot) {
  return status_of([&] { g_answer = session(slot).run().world().hash().text(); });
}

/// Answers with the scene of a simulation as a scene file, with what was thrown and taken away.
/// \param slot 0 or 1
/// \return 0, or 2 with a sentence
TUMBLE_EXPORT int tumble_scene(int slot) {
  return status_of([&] { g_answer = to_toml(session(slot).run().scene()); });
}
