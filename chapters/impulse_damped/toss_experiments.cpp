/// \file
/// \brief Tossed cubes with and without chance, against measured ones (thesis 2.4.2, 4.2).
#include "impulse_damped/damped_variants.hpp"
#include "impulse_damped/tosses.hpp"

namespace tumble::chapters {
namespace {

constexpr double kQuiet = 0.5;  // [s] and one that has not moved for so long will not move again

// By seed: how far each of its tosses goes, and when it rests.
struct Tosses {
  std::vector<double> travel;        // [m]
  std::vector<double> time_to_rest;  // [s]
};
using Outcomes = std::vector<Tosses>;

void toss(const PlayedTechnique& technique, std::uint64_t seed, Tosses& tosses) {
  PlayedScene played(make_scene("toss", {}, seed), technique, seed);
  const std::size_t cube = played.index("cube");
  const Vec3 start_w = played.world().states()[cube].position_w;
  double moves = 0.0;  // [s] until then
  while (played.world().time() < toss_seconds && played.world().time() < moves + kQuiet) {
    played.step();
    const BodyProperties& body = played.world().bodies()[cube];
    const BodyState& state = played.world().states()[cube];
    const bool rests = velocity(body, state).norm() < toss_still &&
                       angular_velocity(body, state).norm() < 10.0 * toss_still;
    if (!rests) moves = played.world().time();
  }
  const Vec3 way_w = played.world().states()[cube].position_w - start_w;
  tosses.travel.push_back(std::hypot(way_w.x(), way_w.z()));
  tosses.time_to_rest.push_back(moves);
}

// A technique gets the same starts as every other.
// after: groups of starts that are passed over
Outcomes toss_all(const PlayedTechnique& technique, int seeds, int count, int after = 0) {
  Outcomes all(static_cast<std::size_t>(seeds));
  for (int seed = 0; seed < seeds; ++seed)
    for (int k = 0; k < count; ++k)
      toss(technique, static_cast<std::uint64_t>(1 + (after + seed) * count + k),
           all[static_cast<std::size_t>(seed)]);
  return all;
}

using Numbers = std::vector<double> Tosses::*;

std::vector<double> pooled(const Outcomes& outcomes, Numbers what, int left_out) {
  std::vector<double> all;
  for (int seed = 0; seed < static_cast<int>(outcomes.size()); ++seed) {
    if (seed == left_out) continue;
    const std::vector<double>& some = outcomes[static_cast<std::size_t>(seed)].*what;
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

// Mean over the three quartiles of how far they are from the measured ones, over the distance
// between the measured outer two: 1 is as far as the measured tosses spread.
double distance(const Outcomes& outcomes, Numbers what, const std::array<double, 3>& measured,
                int left_out) {
  const std::vector<double> all = pooled(outcomes, what, left_out);
  double sum = 0.0;
  for (std::size_t q = 0; q < 3; ++q)
    sum += std::abs(quantile_of(all, 0.25 * static_cast<double>(q + 1)) - measured[q]);
  return sum / 3.0 / (measured[2] - measured[0]);
}

double travel_distance(const Outcomes& outcomes, int left_out) {
  return distance(outcomes, &Tosses::travel, measured_tosses.travel, left_out);
}

double time_distance(const Outcomes& outcomes, int left_out) {
  return distance(outcomes, &Tosses::time_to_rest, measured_tosses.time_to_rest, left_out);
}

double both(const Outcomes& outcomes, int left_out) {
  return 0.5 * (travel_distance(outcomes, left_out) + time_distance(outcomes, left_out));
}

PlayedTechnique damped(const char* randomness, const DampedVariant& variant = {"", {"damped"}}) {
  PlayedTechnique technique = variant.technique;
  technique.settings.push_back(std::string("randomness=") + randomness);
  return technique;
}

Result measure_tosses(const Parameters& settings) {
  const int seeds = settings.count("seeds");
  const int count = settings.count("tosses");
  const auto run = [&](const PlayedTechnique& technique) {
    return toss_all(technique, seeds, count);
  };
  struct Way {
    std::string column;
    std::string words;
    Outcomes outcomes;
  };
  const std::vector<Way> ways = {
      {"chance", "damped, chance in fast collisions", run(damped("fast"))},
      {"damped", "damped, no chance", run(damped("off"))},
      {"impulse", "impulses alone", run({"impulse"})},
      {"coulomb", "contact_damped", run(coulomb_technique())}};

  Result result;
  const auto compared = [&](const std::string& name, const Outcomes& top, const Outcomes& bottom,
                            const std::function<double(const Outcomes&, int)>& far) {
    result.add(over_seeds(name, "-", seeds, [&](int left_out) {
      return far(top, left_out) / far(bottom, left_out);
    }));
  };
  const Outcomes& with = ways[0].outcomes;
  const Outcomes& without = ways[1].outcomes;
  compared(
      "distance of travel and time to rest from the measured quartiles, with randomness over "
      "without",
      with, without, both);
  compared(
      "distance of travel and time to rest from the measured quartiles, with randomness over "
      "without, fresh seeds",
      toss_all(damped("fast"), seeds, count, seeds), toss_all(damped("off"), seeds, count, seeds),
      both);
  const DampedVariant reported{"as_reported", {"damped", {"reading=as_reported"}}};
  compared(
      "distance of travel and time to rest from the measured quartiles, with randomness over "
      "without, as_reported",
      toss_all(damped("fast", reported), seeds, count, seeds),
      toss_all(damped("off", reported), seeds, count, seeds), both);
  compared("the same, travel only", with, without, travel_distance);
  compared("the same, time to rest only", with, without, time_distance);
  for (const DampedVariant& variant : damped_variants())
    if (!variant.words.empty())
      compared("the same, " + variant.words, run(damped("fast", variant)),
               run(damped("off", variant)), both);
  for (std::size_t k = 1; k < ways.size(); ++k) {
    result.add(over_seeds(
        "distance of travel from the measured quartiles, over their spread, " + ways[k].words, "-",
        seeds, [&](int left_out) { return travel_distance(ways[k].outcomes, left_out); }));
    result.add(over_seeds(
        "distance of time to rest from the measured quartiles, over their spread, " + ways[k].words,
        "-", seeds, [&](int left_out) { return time_distance(ways[k].outcomes, left_out); }));
  }

  Table shares{"", {{"share", "-", "of the tosses that get no farther, or rest no later"}}};
  for (const Way& way : ways) {
    shares.columns.push_back({"travel_" + way.column + "_m", "m", "travel, " + way.words});
    shares.columns.push_back({"rest_" + way.column + "_s", "s", "time to rest, " + way.words});
  }
  constexpr int lines = 100;
  for (int k = 0; k <= lines; ++k) {
    const double share = 1.0 * k / lines;
    std::vector<double> row;
    for (const Way& way : ways)
      for (const Numbers what : {&Tosses::travel, &Tosses::time_to_rest})
        row.push_back(quantile_of(pooled(way.outcomes, what, -1), share));
    shares.add(share, row);
  }
  Table quartiles{"quartiles",
                  {{"share", "-", "of the measured tosses"},
                   {"travel_m", "m", "no farther than this"},
                   {"rest_s", "s", "rest no later than this"}}};
  for (std::size_t q = 0; q < 3; ++q)
    quartiles.add(0.25 * static_cast<double>(q + 1), measured_tosses.travel[q],
                  measured_tosses.time_to_rest[q]);
  result.tables = {shares, quartiles};
  return result;
}

const Registered claim_2_4_2a_tosses_figure{
    {.name = "claim_2_4_2a_tosses",
     .parameters = {whole("tosses", 40, 2, 10000, "for each seed"),
                    whole("seeds", 20, 2, 1000, "groups of tosses")},
     .quick = {"tosses=4", "seeds=3"},
     .experiment = measure_tosses}};

}  // namespace
}  // namespace tumble::chapters
