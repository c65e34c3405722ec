/// \file
/// \brief A plain technique made of the shared layers alone, to test that they work together.
#pragma once

#include "tumble/contact/gather.hpp"
#include "tumble/contact/impacts.hpp"
#include "tumble/contact/repair.hpp"
#include "tumble/contact/sleeping.hpp"
#include "tumble/contact/sticky.hpp"
#include "tumble/dynamics/technique.hpp"

#include <string_view>

namespace tumble::test {

// Steps bodies with every layer once: broad phase, contacts, impacts, flight, repair, sleep.
//
// It is no technique of the thesis and none that a user should want: speeds first, then contacts
// as collisions one after the other, then positions, then whatever overlaps is pushed apart.
class LayerStepper : public Technique {
 public:
  explicit LayerStepper(std::string_view broad_phase = "bounding_tree");
  LayerStepper(const LayerStepper& other);
  LayerStepper& operator=(const LayerStepper&) = delete;
  ~LayerStepper() override = default;

  [[nodiscard]] std::string_view name() const override { return "layers"; }
  StepReport step(World& world, double dt) override;
  [[nodiscard]] std::unique_ptr<Technique> clone() const override;

 private:
  void find_contacts(World& world, double margin, StepReport& report);
  void collide(World& world, double dt, StepReport& report);

  std::unique_ptr<BroadPhase> broad_phase_;
  SleepingRule sleeping_;
  OverlapRepair repair_;
  ImpactSolver impacts_;
  Islands islands_;
  ContactList contacts_;
  ContactList previous_;
  std::vector<MovingBody> moving_;
  std::vector<Bounds> bounds_;
  std::vector<IndexPair> pairs_;
  std::vector<IndexPair> candidates_;
};

// A clump of tumbling, bouncing boxes of several sizes over the ground.
World bouncing_clump(int per_edge);

}  // namespace tumble::test
