/// \file
/// \brief The basic colliding technique (thesis 2.1): the first one to read.
#pragma once

#include "tumble/base/cloned.hpp"
#include "tumble/base/options.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/contact/gather.hpp"
#include "tumble/contact/impacts.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/dynamics/event_search.hpp"
#include "tumble/dynamics/technique.hpp"
#include "tumble/geometry/bounding_tree.hpp"

#include <vector>

namespace tumble {

/// Options of the basic technique.
struct BasicOptions {
  double resolution = tolerance::event_resolution;  ///< [s] how exactly impacts are searched for
  int event_cap = 1000;                             ///< moments of impact allowed in one step
  ImpactOrder impacts = ImpactOrder::simultaneous;  ///< how several impacts at once are resolved
  SearchMethod search = SearchMethod::discrete;     ///< the thesis's, or one that misses nothing
  RotationRule rotation = RotationRule::splitting;  ///< how bodies turn in flight
};

template <class Visitor>
void describe(BasicOptions& o, Visitor& v) {
  v.number("resolution", o.resolution, tolerance::least_event_resolution, 1.0, "s",
           "time resolution of the search for impacts");
  v.whole("event_cap", o.event_cap, 1, 1000000, "moments of impact allowed in one step");
  v.word("impacts", o.impacts, impact_words(), kImpactsMeaning);
  v.word("search", o.search,
         {{"discrete", SearchMethod::discrete}, {"conservative", SearchMethod::conservative}},
         "test for overlap at the end of a step only (thesis 3.2), or miss no contact");
  v.word("rotation", o.rotation, words_of(rotation_rules()), kRotationMeaning);
}

/// Advance, find an overlap, search back for the moment of impact, resolve, go on (thesis 2.1).
///
/// Between impacts bodies fly freely, so nothing ever rests: a box that lies on the ground falls on
/// it again and again, in ever shorter hops. The number of impacts in a step is capped; when the cap
/// is met the rest of the step is flown without them, the overlap that comes of it is repaired by
/// moving bodies, and the report says so. Bodies that overlap at the start of a step and go deeper
/// collide at once. No impact adds energy; repair may, as much as is booked.
/// \par Cost
/// Each moment of impact rewinds and advances all bodies and tests all near pairs again.
/// \algorithm{The basic colliding technique: section 2.1}
/// \deviation{The number of impacts in a step is capped; by the thesis's words a step with a resting box does not end.}
/// \verified{A bouncing cube of the basic technique follows an event-driven reference run}
class Basic : public Cloned<Technique, Basic> {
 public:
  /// Makes the technique.
  /// \throws std::invalid_argument for a resolution not above 0 or a cap below 1
  explicit Basic(const BasicOptions& options = {});

  [[nodiscard]] std::string_view name() const override { return "basic"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::span<const ContactRecord> contacts() const override { return records_; }

 private:
  StepReport step_part(World& world, double dt);
  [[nodiscard]] Flight flight_of(const World& world) const;
  const FirstEvent& find_first(const World& world, double remaining, StepReport& report);
  int fly_all(World& world, double time, StepReport& report) const;
  double resolve(World& world, const Event& moment, StepReport& report);
  void release_rounding(const World& world, double speed_change, double remaining);
  void repair_overlap(World& world, StepReport& report);

  BasicOptions options_;
  BoundingTree broad_phase_;
  EventSearch search_;
  ImpactSolver impacts_;
  OverlapRepair repair_;

  // Storage of one step, kept so that a warm step asks for no memory.
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> candidates_;
  std::vector<IndexPair> touching_;
  std::vector<IndexPair> released_;
  std::vector<MovingBody> moving_;
  ContactList contacts_;
  std::vector<ContactRecord> records_;
};

}  // namespace tumble
