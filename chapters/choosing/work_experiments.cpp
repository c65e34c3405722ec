/// \file
/// \brief Error against work: each technique on motions with closed forms (thesis 6.3.2).
#include "choosing/experiments.hpp"
#include "choosing/problems.hpp"

namespace tumble::chapters {
namespace {

constexpr std::size_t kProblems = 3;
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kShown = 2;  // steps in a frame whose error the page states: 1/60 s

struct Try {
  std::size_t technique = 0;
  std::size_t problem = 0;
  int per_frame = 1;
  Attempt came;
};

LeastWork least_work(const std::vector<Try>& tries, std::size_t techniques, double tolerance,
                     double pivot = 1.0) {
  LeastWork least(techniques, {kNever, kNever, kNever});
  for (const Try& one : tries) {
    if (!(one.came.error <= tolerance)) continue;  // true for NaN
    double& best = least[one.technique][one.problem];
    best = std::min(best, work_of(one.came.totals, pivot));
  }
  return least;
}

// The four timewarps are relatives: a result of one counts four times unless one stands for all.
LeastWork with_one_timewarp(const LeastWork& work, const std::vector<PlayedTechnique>& techniques) {
  LeastWork kept;
  bool seen = false;
  for (std::size_t t = 0; t < work.size(); ++t) {
    const bool timewarp = techniques[t].name.starts_with("timewarp_");
    if (!timewarp || !seen) kept.push_back(work[t]);
    seen = seen || timewarp;
  }
  return kept;
}

Table runs_table(const std::vector<Try>& tries) {
  Table table{
      "",
      {{"technique", "-", "its row, from 0"},
       {"problem", "-", "0: bounce, 1: slide, 2: rock"},
       {"error", "-", "largest over frames, over the length of the problem; empty: stopped"},
       {"work", "-", "everything that step reports count"}}};
  for (const Try& one : tries)
    table.add(one.technique, one.problem, one.came.error, work_of(one.came.totals));
  return table;
}

// Errors that the page is about; the picture has all of them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kStated = {
    {{"contact_damped", "slide"},
     {"contact_damped", "rock"},
     {"basic", "bounce"},
     {"analytic", "bounce"},
     {"analytic", "slide"},
     {"analytic", "rock"},
     {"time_stepping", "bounce"},
     {"damped", "slide"},
     {"glued", "slide"},
     {"glued", "rock"}}};

void add_errors(const std::vector<Try>& tries, const std::vector<PlayedTechnique>& techniques,
                const std::array<Problem, kProblems>& problems, Result& result) {
  for (const Try& one : tries)
    for (const auto& [technique, problem] : kStated)
      if (one.per_frame == kShown && techniques[one.technique].name == technique &&
          problems[one.problem].name == problem)
        add_number(
            result.quantities,
            number_name(std::string(technique), "error of " + std::string(problem) + " at 1/60 s"),
            "%", 100.0 * one.came.error);
}

}  // namespace

double share_that_changes_places(const LeastWork& work) {
  int pairs = 0, changing = 0;
  for (std::size_t a = 0; a < work.size(); ++a) {
    for (std::size_t b = a + 1; b < work.size(); ++b) {
      bool first = false, second = false;
      for (std::size_t p = 0; p < kProblems; ++p) {
        first = first || work[a][p] < work[b][p];
        second = second || work[b][p] < work[a][p];
      }
      ++pairs;
      if (first && second) ++changing;
    }
  }
  return static_cast<double>(changing) / pairs;
}

namespace {

Result measure_work_against_error(const Parameters& settings) {
  const std::vector<PlayedTechnique> techniques = compared_techniques();
  const std::array<Problem, kProblems> problems = closed_problems();
  std::vector<Try> tries;
  for (std::size_t t = 0; t < techniques.size(); ++t)
    for (std::size_t p = 0; p < kProblems; ++p)
      for (int per_frame = 1; per_frame <= settings.count("finest"); per_frame *= 2)
        tries.push_back({t, p, per_frame, attempt(problems[p], techniques[t], per_frame)});

  const double tolerance = settings.number("tolerance");
  const auto changing = [&](double share, double pivot) {
    return share_that_changes_places(
        least_work(tries, techniques.size(), share * tolerance, pivot));
  };
  Result result;
  result.quantities = {
      {"share of the pairs of techniques that change places between two of three problems, by the "
       "work that an error of one per cent takes",
       "-", changing(1.0, 1.0)},
      {"the same share with half of that error", "-", changing(0.5, 1.0)},
      {"the same share with twice that error", "-", changing(2.0, 1.0)},
      {"the same share with a pivot counted ten times", "-", changing(1.0, 10.0)},
      {"the same share with one timewarp for all four", "-",
       share_that_changes_places(
           with_one_timewarp(least_work(tries, techniques.size(), tolerance), techniques))},
      {"techniques that were compared", "-", techniques.size()}};
  add_errors(tries, techniques, problems, result);

  const LeastWork least = least_work(tries, techniques.size(), tolerance);
  for (std::size_t t = 0; t < techniques.size(); ++t)
    for (std::size_t p = 0; p < kProblems; ++p)
      add_number(result.quantities,
                 number_name(techniques[t].name,
                             "work of " + problems[p].name + " for an error of one per cent"),
                 "-", least[t][p] < kNever ? least[t][p] : kNoNumber);
  result.tables = {runs_table(tries)};
  return result;
}

const Registered claim_6_3_2a_work_figure{
    {.name = "claim_6_3_2a_work",
     .parameters = {whole("finest", 32, 1, 1024,
                          "steps in 1/30 s at most; from 1 on, doubled each time"),
                    number("tolerance", 0.01, 1e-9, 1.0, "-",
                           "error for which the least work is asked")},
     .quick = {"finest=4"},
     .experiment = measure_work_against_error}};

}  // namespace
}  // namespace tumble::chapters
