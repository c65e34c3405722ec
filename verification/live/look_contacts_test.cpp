/// \file
/// \brief Contact points, collisions and numbers in a look at a session.
#include "live/seen.hpp"
#include "session.hpp"
#include "support/test.hpp"

using namespace tumble::live;

TEST_CASE("Contact points of a look are those of the technique's last step", "[unit][live]") {
  const std::string technique =
      GENERATE(as<std::string>(), "contact_damped", "analytic", "time_stepping", "damped");
  INFO(technique);
  const std::string request = "technique " + technique + "\n" + kTable;
  Session session(request);
  // The same by hand.
  Setup setup = make_setup(request);
  Simulation run(setup.scene, *setup.technique);
  for (int k = 0; k < 6; ++k) {
    step(session, 1);
    run.step(kDt);
  }
  session.look(kLookContacts);
  const std::vector<SeenContact> seen = contacts_of(session);
  const auto records = setup.technique->contacts();
  REQUIRE(!records.empty());
  REQUIRE(seen.size() >= records.size());
  for (std::size_t k = 0; k < records.size(); ++k) {
    const ContactRecord& record = records[k];
    CHECK(seen[k].time == record.time);
    CHECK(seen[k].first == run.world().index_of(record.first));
    CHECK(seen[k].second == run.world().index_of(record.second));
    CHECK(seen[k].point_w == record.point_w);
    CHECK(seen[k].normal_w == record.normal_w);
    CHECK(seen[k].push_w == record.push_w);
    CHECK(seen[k].is_impulse == record.is_impulse);
    CHECK(seen[k].state == static_cast<int>(record.state));
  }
  session.look(kEverything & ~kLookContacts);
  CHECK(session.contacts().empty());

  // Points of bodies that have gone since are left out, and indices are those of now.
  session.take_away(id_of(session, "lower"));
  session.look(kLookContacts);
  const World& world = session.run().world();
  for (const SeenContact& contact : contacts_of(session)) {
    CHECK(contact.first < world.count());
    CHECK(contact.second < world.count());
    CHECK(world.name(contact.first) == "ground");
  }
}

TEST_CASE("Collisions are seen once, at the look after them", "[unit][live]") {
  Session session("scene two_boxes\ntechnique timewarp_swept\nset scene.speed=4");
  const auto collisions = [&](unsigned wanted) {
    session.look(wanted);
    std::vector<SeenContact> found = contacts_of(session);
    std::erase_if(found, [](const SeenContact& contact) { return contact.state != 3; });
    return found;
  };
  std::int64_t events = 0;
  std::vector<SeenContact> found;
  for (int k = 0; k < 400 && found.empty(); ++k) {
    step(session, 1);
    found = collisions(kLookContacts);
    events = static_cast<std::int64_t>(number(session, "events"));
  }
  REQUIRE(!found.empty());
  CHECK(static_cast<std::int64_t>(found.size()) == events);
  const World& world = session.run().world();
  for (const SeenContact& event : found) {
    CHECK(event.is_impulse);
    CHECK(event.time <= world.time());
    CHECK(event.time >= world.time() - kDt);
    CHECK(event.first < event.second);
    CHECK(event.normal_w.norm() == near(1.0, 1e-12));
    CHECK(event.push_w.dot(event.normal_w) > 0.0);
  }
  CHECK(collisions(kLookContacts).empty());
}

TEST_CASE("Collisions between two looks are kept up to a bound", "[unit][live]") {
  // Cubes that never come to rest. One session is looked at after each step, the other at the end.
  const std::string request =
      "scene cage\nset scene.count=60\nset scene.speed=40\ntechnique timewarp_swept";
  Session looked(request);
  Session left(request);
  const auto collisions = [](Session& session) {
    session.look(kLookContacts);
    const std::vector<SeenContact> all = contacts_of(session);
    return std::ranges::count_if(all,
                                 [](const SeenContact& contact) { return contact.state == 3; });
  };
  std::ptrdiff_t sum = 0;
  for (int k = 0; k < 20; ++k) {
    step(looked, 1);
    step(left, 1);
    sum += collisions(looked);
  }
  CHECK(sum > 100);
  CHECK(collisions(left) == sum);
  for (int k = 0; k < 400 && sum <= 4096; ++k) {
    if (k == 0) sum = 0;
    step(looked, 1);
    step(left, 1);
    sum += collisions(looked);
  }
  REQUIRE(sum > 4096);
  CHECK(collisions(left) == 4096);
  CHECK(collisions(left) == 0);
}

TEST_CASE("The numbers of a look are those of the run's metrics", "[unit][live]") {
  Session session("scene stack\nset scene.count=3");
  session.look(0);
  REQUIRE(session.numbers().size() == Session::number_names().size());
  CHECK(number(session, "time") == 0.0);
  CHECK(number(session, "potential") == session.metrics().potential);
  step(session, 9);
  session.look(0);
  const Metrics& metrics = session.metrics();
  CHECK(number(session, "time") == 9.0 * kDt);
  CHECK(number(session, "steps") == 9.0);
  CHECK(number(session, "status") == 0.0);
  CHECK(number(session, "kinetic") == metrics.kinetic);
  CHECK(number(session, "potential") == metrics.potential);
  CHECK(number(session, "booked") == metrics.booked.total());
  CHECK(number(session, "energy_error") == metrics.energy_error);
  CHECK(number(session, "energy_share") == metrics.energy_error_share);
  CHECK(number(session, "overlap") == metrics.deepest_overlap);
  CHECK(number(session, "chatter") == metrics.chatter.amplitude);
  CHECK(number(session, "shaking") == metrics.chatter.acceleration);
  CHECK(number(session, "fastest") == metrics.fastest);
  CHECK(number(session, "asleep") == 0.0);
  CHECK(number(session, "contacts") > 0.0);
  const std::set<std::string_view> names(Session::number_names().begin(),
                                         Session::number_names().end());
  CHECK(names.size() == Session::number_names().size());
}
