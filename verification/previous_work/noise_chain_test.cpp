/// \file
/// \brief Markov chains over noise: where they are, and what replays and threads change about them, which is nothing.
#include "tumble/previous_work/noise_chain.hpp"

#include "tumble/contact_damped/contact_damped.hpp"
#include "tumble/previous_work/noisy_impacts.hpp"
#include "tumble/previous_work/parallel_chains.hpp"
#include "tumble/record/sampling.hpp"

#include "support/files.hpp"
#include "support/test.hpp"

namespace {

ImpactName impact(int number) { return {BodyId{0}, BodyId{1}, number}; }

// Three motions: A with one impact in half of the cases, B and C with three impacts in a quarter each.
constexpr std::array<double, 3> kViolations = {0.4, 0.0, 0.7};
constexpr std::array<double, 3> kShares = {0.5, 0.25, 0.25};

int motion_of(const ImpactNoise& noise) {
  if (noise.of(impact(0))[0] < 0.5) return 0;
  return noise.of(impact(1))[0] < 0.5 ? 1 : 2;
}

NoisyMotion three_motions(const ImpactNoise& noise) {
  const int motion = motion_of(noise);
  NoisyMotion result{kViolations[idx(motion)], {impact(0)}, true};
  if (motion > 0) result.impacts.insert(result.impacts.end(), {impact(1), impact(2)});
  return result;
}

// A motion with as many impacts as chance will have, none of which meets the wishes.
NoisyMotion no_luck(const ImpactNoise& noise) {
  NoisyMotion result{noise.of(impact(0))[1] + 0.5, {impact(0)}, true};
  for (int k = 1; k < 20 && noise.of(impact(k - 1))[0] < 0.8; ++k)
    result.impacts.push_back(impact(k));
  return result;
}

std::string table_of(const NoiseChain& chain) { return chain_table(chain.proposals()); }

// A small cube that falls onto the ground, and where it comes down after that.
struct Bounce {
  World world;
  double approach = 0.0;  // [m/s] before the step of the impact
  double rebound = 0.0;   // [m/s] after it
  double landing = 0.0;   // [m] along x, by the closed form of free flight
  std::vector<ImpactName> impacts;
};

constexpr double kRange = 0.3;  // [-] of restitution, around 0.5

Bounce bounce(const ImpactNoise& noise, double range) {
  Bounce out;
  World& world = out.world;
  world.add_ground(0.0, 0.5);
  world.add(box_properties(Vec3::Constant(0.1), 1.0, 0.0, 0.5), Vec3(0.0, 0.3, 0.0),
            Quat::Identity(), Vec3(1.0, 0.0, 0.0));
  NoisyImpacts technique(std::make_unique<ContactDamped>(), noise,
                         {.normal = 0.0, .restitution = range});
  while (technique.impacts().empty() && world.steps() < 100) {
    out.approach = -world.body(BodyId{1}).velocity_w().y();
    technique.step(world, 1.0 / 60.0);
  }
  const BodyView body = world.body(BodyId{1});
  out.rebound = body.velocity_w().y();
  const double height = body.position_w().y() - 0.05;
  const double g = -world.gravity_w.y();
  out.landing = body.position_w().x() +
                body.velocity_w().x() *
                    (out.rebound + std::sqrt(out.rebound * out.rebound + 2.0 * g * height)) / g;
  out.impacts.assign(technique.impacts().begin(), technique.impacts().end());
  return out;
}

}  // namespace

TEST_CASE(
    "A chain goes from one state to another as often as back, and is at each as often as it should "
    "be",
    "[exact][sampling]") {
  constexpr double strictness = 2.0;
  constexpr int steps = 400000;
  NoiseChain chain(Random(1), strictness);
  std::array<double, 3> visits{};
  std::array<std::array<int, 3>, 3> ways{};
  int before = -1;
  for (int k = 0; k < steps; ++k) {
    const NoiseChain::Step step = chain.propose(three_motions);
    const int proposed = motion_of(step.noise);
    const int after = step.proposal.accepted ? proposed : before;
    if (before >= 0) ++ways[idx(before)][idx(after)];
    before = after;
    visits[idx(after)] += 1.0 / steps;
    chain.take(step);
  }
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) sum += kShares[k] * std::exp(-strictness * kViolations[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    const double expected = kShares[k] * std::exp(-strictness * kViolations[k]) / sum;
    INFO(k << ": " << visits[k] << ", expected " << expected);
    // Three standard deviations, as a motion lasts for a dozen proposals. Measured 0.002.
    CHECK(std::abs(visits[k] - expected) < 0.008);
    for (std::size_t j = 0; j < k; ++j) {
      INFO(j << " to " << k << ": " << ways[j][k] << ", back " << ways[k][j]);
      CHECK(std::abs(ways[j][k] - ways[k][j]) < 3.0 * std::sqrt(ways[j][k] + ways[k][j]));
    }
  }
}

TEST_CASE(
    "Where a bouncing cube lands has the density of the closed form, by chi-squared at one per "
    "cent",
    "[exact][sampling]") {
  // Restitution is uniform, so the rebound is: v0 +- r a. With a wish that grows with it the density is an exponential, cut off at both ends.
  const Bounce plain = bounce(ImpactNoise(), 0.0);
  const double slowest = plain.rebound - kRange * plain.approach;
  const double width = 2.0 * kRange * plain.approach;
  REQUIRE(plain.impacts.size() == 1);
  constexpr double strictness = 3.0;
  constexpr int bins = 10;
  constexpr int samples = 1000;
  constexpr int apart =
      10;  // states from one sample to the next, which then hardly know each other
  std::array<double, bins> counts{};
  NoiseChain chain(Random(5), strictness);
  const SimulateNoise simulate = [&](const ImpactNoise& noise) {
    const Bounce b = bounce(noise, kRange);
    return NoisyMotion{(b.rebound - slowest) / width, b.impacts, true};
  };
  double share = 0.0;  // [-] of the way from the slowest rebound to the fastest
  for (int k = 0; k < samples * apart; ++k) {
    NoiseChain::Step step = chain.propose(simulate);
    if (step.proposal.accepted) share = step.motion.violation;
    chain.take(std::move(step));
    if (k % apart != apart - 1) continue;
    // Distribution function of the cut exponential: bins of equal probability.
    const double below = (1.0 - std::exp(-strictness * share)) / (1.0 - std::exp(-strictness));
    REQUIRE(below > -1e-9);
    REQUIRE(below < 1.0 + 1e-9);
    ++counts[static_cast<std::size_t>(std::clamp(bins * below, 0.0, bins - 0.5))];
  }
  double chi_squared = 0.0;
  for (const double count : counts)
    chi_squared += (count - samples / bins) * (count - samples / bins) / (samples / bins);
  INFO("chi squared " << chi_squared);
  CHECK(chi_squared < 21.67);  // nine degrees of freedom at one per cent
}

TEST_CASE("The rebound of a bounce without wishes is uniform in restitution", "[exact][sampling]") {
  const Bounce plain = bounce(ImpactNoise(), 0.0);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const ImpactNoise noise((Random(seed)));
    const Bounce b = bounce(noise, kRange);
    const double shift = kRange * (2.0 * noise.of(b.impacts.at(0))[0] - 1.0);
    CHECK(b.rebound == Approx(plain.rebound + shift * plain.approach).epsilon(1e-12));
    CHECK((b.landing > plain.landing) == (shift > 0.0));
  }
}

TEST_CASE("Chains have the same bits on any number of cores", "[determinism][sampling]") {
  std::vector<std::string> tables;
  for (const int cores : {1, 2, 7}) {
    std::vector<NoiseChain> chains = make_chains(3, 5, 2.0);
    std::atomic<bool> stop = false;
    run_chains(chains, {.found = 40, .proposals = 200}, three_motions, cores, stop);
    std::string all;
    for (const NoiseChain& chain : chains) all += table_of(chain);
    tables.push_back(all);
  }
  CHECK(tables[0] == tables[1]);
  CHECK(tables[0] == tables[2]);
}

TEST_CASE("A chain that is replayed from its table goes on as if it had never ended",
          "[determinism][sampling]") {
  NoiseChain whole(Random(7), 2.0);
  for (int k = 0; k < 80; ++k) whole.take(whole.propose(three_motions));
  for (const std::size_t cut : {0U, 1U, 33U, 79U}) {
    const Folder folder("noise_chain");
    std::ofstream(folder.file("chain.csv")) << chain_table(whole.proposals().first(cut));
    NoiseChain again(Random(7), 2.0);
    again.replay(read_chain(folder.path / "chain.csv"));
    if (cut > 0) again.take(again.propose(three_motions));  // recalls its motion
    while (again.proposals().size() < 80) again.take(again.propose(three_motions));
    CHECK(table_of(again) == table_of(whole));
    REQUIRE(again.found().size() == whole.found().size());
    for (std::size_t k = 0; k < again.found().size(); ++k) {
      CHECK(again.found()[k].proposal == whole.found()[k].proposal);
      for (int n = 0; n < 3; ++n)
        CHECK(again.found()[k].noise.of(impact(n)) == whole.found()[k].noise.of(impact(n)));
    }
  }
}

TEST_CASE("A chain without luck ends at its cap with the best that it found", "[unit][sampling]") {
  std::vector<NoiseChain> chains = make_chains(1, 3, 1.0);
  std::atomic<bool> stop = false;
  int looks = 0;
  run_chains(chains, {.found = 1, .proposals = 50}, no_luck, 2, stop, [&] { ++looks; });
  CHECK(looks > 0);
  for (const NoiseChain& chain : chains) {
    CHECK(chain.proposals().size() == 50);
    CHECK(chain.found().empty());
    CHECK(no_luck(chain.best().noise).violation == chain.least_violation());
    for (const NoiseProposal& p : chain.proposals()) {
      if (p.accepted) CHECK(p.violation >= chain.least_violation());
    }
  }
}

TEST_CASE("Chains stop when they are asked to, and pass on what a motion throws",
          "[unit][sampling]") {
  std::vector<NoiseChain> chains = make_chains(1, 2, 1.0);
  std::atomic<bool> stop = false;
  run_chains(chains, {.found = 1, .proposals = 1000000000}, no_luck, 2, stop, [&] { stop = true; });
  CHECK(stop);
  stop = false;
  const SimulateNoise fails = [](const ImpactNoise&) -> NoisyMotion {
    throw std::invalid_argument("no such motion");
  };
  CHECK_THROWS_WITH(run_chains(chains, {.found = 1, .proposals = 1000000000}, fails, 2, stop),
                    "no such motion");
  CHECK_THROWS_AS(run_chains(chains, {}, fails, 0, stop), std::invalid_argument);
  NoiseChain unfinished(Random(1), 1.0);
  unfinished.take(unfinished.propose([](const ImpactNoise&) {
    return NoisyMotion{0.0, {}, false};
  }));
  CHECK(unfinished.proposals().empty());
}

TEST_CASE("Tables and replays that cannot be of a chain are refused", "[unit][sampling]") {
  CHECK_THROWS_AS(NoiseChain(Random(1), 0.0), std::invalid_argument);
  CHECK_THROWS_AS(make_chains(1, 0, 1.0), std::invalid_argument);
  NoiseChain chain(Random(7), 2.0);
  NoiseProposal rejected;
  CHECK_THROWS_AS(chain.replay(std::vector{rejected}), std::invalid_argument);
  for (int k = 0; k < 3; ++k) chain.take(chain.propose(three_motions));
  CHECK_THROWS_AS(chain.replay({}), std::invalid_argument);
  NoiseChain other(Random(7), 2.0);
  other.replay(chain.proposals());
  CHECK_THROWS_WITH(other.take(other.propose(no_luck)), Contains("go on with the scene"));

  const Folder folder("chain_table");
  const std::filesystem::path file = folder.file("chain.csv");
  const std::string head = chain_table({});
  for (const char* row :
       {"1,all,0,0,0,1,0,1\n", "0,any,0,0,0,1,0,1\n", "0,all,0,0,0,2,0,1\n", "0,all,0,0,0,1,-1,1\n",
        "0,all,0,0,0,1,nan,1\n", "0,all,0,0,0,1\n", "0,all,0,0,-1,1,0,1\n"}) {
    std::ofstream(file) << head << row;
    INFO(row);
    CHECK_THROWS_WITH(read_chain(file), Contains("chain.csv:2: "));
  }
  std::ofstream(file) << "time_s,body\n";
  CHECK_THROWS_WITH(read_chain(file), Contains("chain.csv:1: "));
}
