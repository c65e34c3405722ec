/// \file
/// \brief Claim 6.2f: changes of contact that the right motion does not have.
#include "tumble/base/tolerances.hpp"

#include "driver/side_by_side.hpp"
#include "exterior_rotation/falling_column.hpp"
#include "exterior_rotation/geometric_contacts.hpp"
#include "exterior_rotation/unilateral_run.hpp"

namespace tumble::chapters {
namespace {

constexpr std::size_t kSemiImplicit = 1;  // places in contact_schemes()
constexpr std::size_t kClassical = 4;
constexpr std::size_t kExponential = 6;  // semi-implicit
constexpr std::array<std::size_t, 5> kSwept = {0, kSemiImplicit, 3, kClassical, kExponential};

using Looks = std::vector<std::vector<ContactSet>>;

// Chosen before the first run. Contact is found by geometry: a corner of a joint's area touches if
// its bodies are at most tolerance::contact_gap of an edge apart, which is what `analytic` asks; deeper
// than that, a test for collisions finds an overlap, and that is a change, too. What touches holds, but
// for what would have to pull. The same corners of the right motion are looked at in the same way. A
// change has a counterpart if the same joint comes to the same corners within two steps, and each
// counterpart serves once.
//
// Mended after the first run, whose number was 23: both runs go on for two steps after the second, so that
// no counterpart is cut off, and a face that has to pull can open altogether within one step.
struct Question {
  double angle = 0.0;
  double dt = 0.0;
  int steps = 0;
  int within = 0;
};

Question question_of(const Parameters& settings) {
  const double rate = settings.number("rate");
  return {settings.number("angle"), 1.0 / rate,
          static_cast<int>(std::lround(rate * settings.number("seconds"))),
          settings.count("within")};
}

// The right motion, at the ends of steps.
struct Reference {
  std::vector<World> worlds;
  std::vector<Joint> joints;
  double first_opening = 0.0;  // [s]
};

Reference right_motion(const Question& question) {
  Reference reference;
  const int steps = question.steps + question.within;
  const UnilateralRun run = run_unilateral(
      column_world(question.angle), unilateral(GluedScheme::dormand_prince, GluedEvents::located),
      steps * question.dt, steps,
      [&](const World& world, const Glued&) { reference.worlds.push_back(world); });
  reference.joints = run.joints;
  reference.first_opening = run.events.empty() ? steps * question.dt : run.events.front();
  return reference;
}

std::vector<ContactChange> changes_of(const Reference& reference, double tolerance) {
  Looks looks;
  for (const World& world : reference.worlds) {
    looks.emplace_back();
    for (const Joint& joint : reference.joints)
      looks.back().push_back(contact_set_of(joint, world.states(), tolerance));
  }
  return chapters::changes_of(looks);
}

std::vector<ContactChange> changes_of(const ContactScheme& scheme, const Question& question,
                                      double tolerance, bool glue = false) {
  World world = column_world(question.angle);
  GeometricContacts stepper(scheme, tolerance, glue);
  stepper.find(world);
  Looks looks = {stepper.look(world)};
  for (int n = 0; n < question.steps + question.within; ++n) {
    stepper.advance(world, question.dt);
    looks.push_back(stepper.look(world));
  }
  return chapters::changes_of(looks);
}

// A scheme's changes in the time that is asked for, sorted out.
struct Verdict {
  std::vector<ContactChange> all;
  std::vector<ContactChange> wrong;   // the right motion lacks them
  std::vector<ContactChange> missed;  // the scheme lacks them

  [[nodiscard]] auto wrong_before(int step) const {
    return std::ranges::count_if(wrong,
                                 [&](const ContactChange& change) { return change.step < step; });
  }
};

Verdict judge(const std::vector<ContactChange>& changes, const std::vector<ContactChange>& right,
              const Question& question) {
  const auto in_time = [&](std::vector<ContactChange> list) {
    std::erase_if(list, [&](const ContactChange& change) { return change.step > question.steps; });
    return list;
  };
  Verdict verdict{.all = in_time(changes)};
  verdict.wrong = changes_not_in(verdict.all, right, question.within);
  verdict.missed = changes_not_in(in_time(right), changes, question.within);
  return verdict;
}

// Wrong changes if any change of the same joint, of touching or of overlap, counts as its counterpart.
std::size_t wrong_joints(std::vector<ContactChange> changes, std::vector<ContactChange> right,
                         const Question& question) {
  for (std::vector<ContactChange>* list : {&changes, &right}) {
    for (ContactChange& change : *list) {
      change.kind = ChangeKind::lost;
      change.touching = 0;
    }
  }
  return judge(changes, right, question).wrong.size();
}

Table changes_table(const std::vector<Verdict>& verdicts, const std::vector<ContactChange>& right,
                    const Question& question) {
  Table table{"changes",
              {{"time_s", "s", "end of the step in which it is first seen"},
               {"scheme", "-", "0: the right motion; from 1 as in the main table"},
               {"joint", "-", "0: pivot; from 1 areas, the lowest first"},
               {"kind", "-", "0: lost, 1: found, 2: overlap, 3: cleared"},
               {"wrong", "-", "1: the right motion does not have it; 0: it does"}}};
  const auto add = [&](const ContactChange& change, std::size_t scheme, bool wrong) {
    table.add(change.step * question.dt, scheme, change.joint, static_cast<int>(change.kind),
              wrong);
  };
  for (const ContactChange& change : right)
    if (change.step <= question.steps) add(change, 0, false);
  for (std::size_t s = 0; s < verdicts.size(); ++s) {
    for (const ContactChange& change : verdicts[s].all) {
      const auto& wrong = verdicts[s].wrong;
      const bool is_wrong = std::ranges::any_of(wrong, [&](const ContactChange& other) {
        return other.step == change.step && other.same(change);
      });
      add(change, s + 1, is_wrong);
    }
  }
  return table;
}

Table schemes_table(const std::vector<Verdict>& verdicts) {
  Table table{"",
              {{"scheme", "-",
                "1: forward Euler, 2: semi-implicit, 3: impulse, 4: midpoint, 5: rk4, 6 to 8: the "
                "first three by the exponential, 9: leapfrog by the exponential"},
               {"changes", "-", "of contact in the time that is asked for"},
               {"wrong", "-", "of them the right motion does not have"},
               {"missed", "-", "changes of the right motion that the scheme lacks"}}};
  for (std::size_t s = 0; s < verdicts.size(); ++s) {
    const Verdict& v = verdicts[s];
    table.add(s + 1, v.all.size(), v.wrong.size(), v.missed.size());
  }
  return table;
}

Table sweep_table(const Parameters& settings, const Question& question,
                  const Reference& reference) {
  Table table{"sweep", {{"tolerance", "-", "distance up to which corners touch, over an edge"}}};
  for (const std::size_t s : kSwept)
    table.columns.push_back(
        {"wrong_" + std::to_string(s + 1), "-", "wrong changes, " + contact_schemes()[s].name});
  const int per_decade = settings.count("per_decade");
  for (int n = -9 * per_decade; n <= -per_decade; ++n) {
    const double tolerance = std::pow(10.0, static_cast<double>(n) / per_decade);
    const std::vector<ContactChange> right = changes_of(reference, tolerance);
    std::vector<std::size_t> counts;
    for (const std::size_t s : kSwept)
      counts.push_back(judge(changes_of(contact_schemes()[s], question, tolerance), right, question)
                           .wrong.size());
    table.add(tolerance, counts);
  }
  return table;
}

// The fall under a scheme, frame by frame. A box is orange while its contact with the one below is seen as the right
// motion never has it within two steps.
std::vector<FilmFrame> frames_of(const ContactScheme& scheme, const Question& question,
                                 double tolerance, const Reference& reference) {
  constexpr std::uint32_t right = 0x56b4e9;
  constexpr std::uint32_t wrong = 0xd55e00;
  World world = column_world(question.angle);
  GeometricContacts stepper(scheme, tolerance);
  stepper.find(world);
  std::vector<FilmFrame> frames;
  for (int n = 0; n <= question.steps; ++n) {
    FilmFrame frame{n * question.dt, {}};
    const std::vector<ContactSet> seen = stepper.look(world);
    for (std::size_t k = 0; k < world.bodies().size(); ++k) {
      if (!world.bodies()[k].movable()) continue;
      PictureBox drawn{box_of(world.bodies()[k], world.states()[k]), right};
      for (std::size_t j = 0; j < reference.joints.size(); ++j) {
        const Joint& joint = reference.joints[j];
        if (idx(joint.second) != k) continue;
        drawn.colour = wrong;
        for (int m = std::max(0, n - question.within); m <= n + question.within; ++m)
          if (contact_set_of(joint, reference.worlds[idx(m)].states(), tolerance) == seen[j])
            drawn.colour = right;
      }
      frame.boxes.push_back(drawn);
    }
    frames.push_back(std::move(frame));
    stepper.advance(world, question.dt);
  }
  return frames;
}

// Four times slowed down.
std::string film_of_contacts(const Question& question, double tolerance,
                             const Reference& reference) {
  const Vec3 direction_w(0.12, 0.12, 1.0);  // from the side on which the column falls
  constexpr int size = 240;                 // [px]
  const auto frames = [&](std::size_t scheme) {
    return frames_of(contact_schemes()[scheme], question, tolerance, reference);
  };
  return film_beside(frames(kSemiImplicit), frames(kExponential), direction_w, size, size, false,
                     0.25 / question.dt);
}

Result measure_wrong_contacts(const Parameters& settings) {
  const Question question = question_of(settings);
  const double tolerance = settings.number("tolerance");
  const Reference reference = right_motion(question);
  const std::vector<ContactChange> right = changes_of(reference, tolerance);
  std::vector<Verdict> verdicts;
  for (const ContactScheme& scheme : contact_schemes())
    verdicts.push_back(judge(changes_of(scheme, question, tolerance), right, question));

  Result result;
  const Table sweep = sweep_table(settings, question, reference);
  result.tables = {schemes_table(verdicts), changes_table(verdicts, right, question), sweep};
  const Verdict& simple = verdicts[kSemiImplicit];
  const auto wrong = [&](std::size_t s) { return verdicts[s].wrong.size(); };
  const int opening = static_cast<int>(std::ceil(reference.first_opening / question.dt));
  double none_from = std::nan("");
  for (std::size_t n = sweep.rows.size(); n > 0 && sweep.rows[n - 1][2] == 0.0; --n)
    none_from = sweep.rows[n - 1][0];
  result.quantities = {
      {"changes of contact in a second of the fall of figure 6.1's column, its joints without glue "
       "and with very high friction, semi-implicit Euler at 60 steps a second, that the "
       "reference solution does not have within two steps",
       "-", wrong(kSemiImplicit)},
      {"of them before the first joint opens", "-", simple.wrong_before(opening)},
      {"wrong changes if any change of the same joint answers", "-",
       wrong_joints(simple.all, right, question)},
      {"wrong changes if what touches holds even if it has to pull", "-",
       judge(changes_of(contact_schemes()[kSemiImplicit], question, tolerance, true), right,
             question)
           .wrong.size()},
      {"tolerance from which semi-implicit Euler has no wrong change", "-", none_from},
      {"changes that the reference solution has", "-", judge(right, right, question).all.size()},
      {"of these semi-implicit Euler misses", "-", simple.missed.size()},
      {"wrong changes, forward Euler", "-", wrong(0)},
      {"wrong changes, semi-implicit by the exponential", "-", wrong(kExponential)}};
  result.film = [question, tolerance, reference] {
    return film_of_contacts(question, tolerance, reference);
  };
  return result;
}

const Registered claim_6_2f_wrong_contacts_figure{
    {.name = "claim_6_2f_wrong_contacts",
     .parameters = {number("angle", 0.3, 0.01, 0.5, "rad", "of the column's centre, at the start"),
                    number("seconds", 1.0, 0.1, 10.0, "s", "of the fall"),
                    number("rate", 60.0, 10.0, 1e4, "1/s", "steps a second"),
                    number("tolerance", tolerance::contact_gap, 1e-12, 1.0, "-",
                           "distance up to which corners touch, over an edge"),
                    whole("within", 2, 0, 100, "steps that a change may be early or late"),
                    whole("per_decade", 5, 1, 100, "tolerances of the sweep")},
     .quick = {"per_decade=1"},
     .experiment = measure_wrong_contacts}};

}  // namespace
}  // namespace tumble::chapters
