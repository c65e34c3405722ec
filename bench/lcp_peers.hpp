/// \file
/// \brief The contact solvers of installed engines, behind one call, for lcp.cpp.
#pragma once

#include "tumble/lcp_solvers/lcp.hpp"

#ifdef TUMBLE_HAVE_ODE
#include <ode/ode.h>
#endif
#ifdef TUMBLE_HAVE_BULLET
#include <BulletDynamics/MLCPSolvers/btDantzigLCP.h>
#endif
#ifdef TUMBLE_HAVE_SICONOS
#include <LCP_Solvers.h>
#include <LinearComplementarityProblem.h>
#include <NonSmoothDrivers.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <lcp_cst.h>
#endif

#include <cstdarg>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#ifdef TUMBLE_HAVE_ODE
// ODE's scratch memory, as its solver reads it: the library exports the solver, no header does.
class dxWorldProcessMemArena {
 public:
  // Provides memory.
  explicit dxWorldProcessMemArena(std::size_t bytes) : storage_(bytes) { rewind(); }
  // Gives all of it back.
  void rewind() {
    current_ = begin_ = storage_.data();
    end_ = storage_.data() + storage_.size();
  }

 private:
  void* current_;  // the first three words are ODE's
  void* begin_;
  void* end_;
  void* arena_begin_ = nullptr;
  const void* manager_ = nullptr;
  std::vector<char> storage_;
};
// ODE 0.16's Dantzig solver, A x = b + w with lo <= x <= hi. All arrays are overwritten.
void dxSolveLCP(dxWorldProcessMemArena* arena, unsigned n, dReal* A, dReal* b_and_x, dReal* w,
                unsigned unbounded, dReal* lo_and_hi, int* friction_index);
std::size_t dxEstimateSolveLCPMemoryReq(unsigned n, bool outer_w_available);
#endif

#ifdef TUMBLE_HAVE_DART
namespace dart::external::ode {
// DART's form of ODE's solver, declared here because its header and ODE's do not go together.
bool dSolveLCP(int n, double* A, double* x, double* b, double* w, int unbounded, double* low,
               double* high, int* friction_index, bool early_termination);
}  // namespace dart::external::ode
#endif

namespace lcp_bench {

// A solver of another engine.
struct Peer {
  std::string name;                                     // as printed
  bool pivots;                                          // and so needs a definite matrix
  std::function<void(const tumble::LcpProblem&)> take;  // copies the problem; not timed
  std::function<void()> solve;                          // solves the copy, and may spoil it
  std::function<std::vector<double>()> forces;          // what came out
};

#ifdef TUMBLE_HAVE_ODE
// ODE's dxSolveLCP.
inline Peer ode() {
  struct State {
    unsigned n = 0;
    std::vector<dReal> A, pairs, bounds, w;
    std::vector<int> friction;
    std::unique_ptr<dxWorldProcessMemArena> arena;
  };
  const auto state = std::make_shared<State>();
  dSetMessageHandler([](int /*number*/, const char* /*text*/, va_list /*list*/) {});
  const auto take = [state](const tumble::LcpProblem& problem) {
    state->n = static_cast<unsigned>(problem.size());
    const std::size_t n = state->n;
    const std::size_t stride = n > 1 ? (n + 3) / 4 * 4 : n;
    state->A.assign(n * stride, 0);
    state->pairs.assign(2 * n, 0);
    state->bounds.assign(2 * n, 0);
    state->w.assign(n, 0);
    state->friction.assign(n, -1);
    for (std::size_t i = 0; i < n; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = 0; j < n; ++j)
        state->A[i * stride + j] = problem.A(row, static_cast<Eigen::Index>(j));
      state->pairs[2 * i] = -problem.b[row];
      state->bounds[2 * i + 1] = std::numeric_limits<dReal>::infinity();
    }
    state->arena = std::make_unique<dxWorldProcessMemArena>(
        dxEstimateSolveLCPMemoryReq(state->n, true) + 4096);
  };
  const auto solve = [state] {
    dxSolveLCP(state->arena.get(), state->n, state->A.data(), state->pairs.data(), state->w.data(),
               0, state->bounds.data(), state->friction.data());
  };
  const auto forces = [state] {
    std::vector<double> f;
    for (std::size_t i = 0; i < state->n; ++i) f.push_back(state->pairs[2 * i + 1]);
    return f;
  };
  return {"ODE dxSolveLCP", true, take, solve, forces};
}
#endif

// A descendant of ODE's earlier dSolveLCP, with plain arrays.
template <class Number, class Call>
Peer descendant(std::string name, Call call) {
  struct State {
    int n = 0;
    std::vector<Number> A, x, b, w, low, high;
    std::vector<int> friction;
  };
  const auto state = std::make_shared<State>();
  const auto take = [state](const tumble::LcpProblem& problem) {
    state->n = problem.size();
    const auto n = static_cast<std::size_t>(state->n);
    const std::size_t stride = n > 1 ? (n + 3) / 4 * 4 : n;
    state->A.assign(n * stride, 0);
    for (std::vector<Number>* v : {&state->x, &state->b, &state->w, &state->low}) v->assign(n, 0);
    state->high.assign(n, std::numeric_limits<Number>::infinity());
    state->friction.assign(n, -1);
    for (std::size_t i = 0; i < n; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = 0; j < n; ++j)
        state->A[i * stride + j] =
            static_cast<Number>(problem.A(row, static_cast<Eigen::Index>(j)));
      state->b[i] = static_cast<Number>(-problem.b[row]);
    }
  };
  const auto solve = [state, call] {
    call(state->n, state->A.data(), state->x.data(), state->b.data(), state->w.data(),
         state->low.data(), state->high.data(), state->friction.data());
  };
  const auto forces = [state] { return std::vector<double>(state->x.begin(), state->x.end()); };
  return {std::move(name), true, take, solve, forces};
}

#ifdef TUMBLE_HAVE_BULLET
// Bullet's btSolveDantzigLCP, in the precision that Bullet was built with.
inline Peer bullet() {
  const auto scratch = std::make_shared<btDantzigScratchMemory>();
  const char* name = sizeof(btScalar) == 8 ? "Bullet Dantzig (double)" : "Bullet Dantzig (float)";
  return descendant<btScalar>(
      name, [scratch](int n, btScalar* A, btScalar* x, btScalar* b, btScalar* w, btScalar* low,
                      btScalar* high, int* friction) {
        btSolveDantzigLCP(n, A, x, b, w, 0, low, high, friction, *scratch);
      });
}
#endif

#ifdef TUMBLE_HAVE_DART
// DART's dSolveLCP.
inline Peer dart() {
  return descendant<double>("DART dSolveLCP", [](int n, double* A, double* x, double* b, double* w,
                                                 double* low, double* high, int* friction) {
    ::dart::external::ode::dSolveLCP(n, A, x, b, w, 0, low, high, friction, false);
  });
}
#endif

#ifdef TUMBLE_HAVE_SICONOS
// Siconos' sweeps, the only one of its solvers that ends on the larger singular problems.
inline Peer siconos() {
  struct State {
    std::vector<double> A, b, f, w;
  };
  const auto state = std::make_shared<State>();
  const auto take = [state](const tumble::LcpProblem& problem) {
    state->A.assign(problem.A.data(), problem.A.data() + problem.A.size());
    state->b.assign(problem.b.data(), problem.b.data() + problem.b.size());
    state->f.assign(state->b.size(), 0.0);
    state->w.assign(state->b.size(), 0.0);
  };
  const auto solve = [state] {
    const auto n = static_cast<int>(state->b.size());
    NumericsMatrix* A = NM_create_from_data(NM_DENSE, n, n, state->A.data());
    LinearComplementarityProblem problem{};
    problem.size = n;
    problem.M = A;
    problem.q = state->b.data();
    SolverOptions* options = solver_options_create(SICONOS_LCP_PGS);
    options->iparam[SICONOS_IPARAM_MAX_ITER] = 10000;
    options->dparam[SICONOS_DPARAM_TOL] = 1e-8;
    linearComplementarity_driver(&problem, state->f.data(), state->w.data(), options);
    solver_options_delete(options);
    std::free(options);
    std::free(A);  // without the numbers, which are ours
  };
  const auto forces = [state] { return state->f; };
  return {"Siconos LCP_PGS", false, take, solve, forces};
}
#endif

// The solvers that were found at build time.
inline std::vector<Peer> peers() {
  std::vector<Peer> out;
#ifdef TUMBLE_HAVE_ODE
  out.push_back(ode());
#endif
#ifdef TUMBLE_HAVE_BULLET
  out.push_back(bullet());
#endif
#ifdef TUMBLE_HAVE_DART
  out.push_back(dart());
#endif
#ifdef TUMBLE_HAVE_SICONOS
  out.push_back(siconos());
#endif
  return out;
}

}  // namespace lcp_bench
