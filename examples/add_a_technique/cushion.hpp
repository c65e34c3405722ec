/// \file
/// \brief Springs and dampers where bodies overlap (thesis 2.5.1): a technique that the library does not have.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tumble/contact/gather.hpp>
#include <tumble/geometry/bounding_tree.hpp>
#include <tumble/techniques.hpp>
#include <vector>

namespace example {

// [options]
/// Options of the technique.
struct CushionOptions {
  double spring = 0.25;  ///< [-] share of its overlap that a point alone ends in a substep
  double damper = 1.0;   ///< [-] share of its approach that a point alone ends in a substep
  int substeps = 8;      ///< of a step, each with contacts of its own
};

/// Names the options to a visitor: key, field, range, unit, meaning.
template <class Visitor>
void describe(CushionOptions& o, Visitor& v) {
  v.number("spring", o.spring, 1e-6, 4.0, "-",
           "share of its overlap that a point ends in a substep");
  v.number("damper", o.damper, 0.0, 2.0, "-",
           "share of its approach that a point ends in a substep");
  v.whole("substeps", o.substeps, 1, 10000, "substeps of a step");
}
// [options]

// [class]
/// Cushions: nothing is solved; each point pushes by the overlap and approach of its two bodies.
class Cushion : public tumble::Technique {
 public:
  /// Makes the technique.
  /// \param options  spring above 0, damper from 0, substeps from 1, spring + 2 damper below 4
  /// \throws std::invalid_argument naming the value that is out of range
  explicit Cushion(const CushionOptions& options = {});

  std::string_view name() const override { return "cushion"; }
  tumble::StepReport step(tumble::World& world, double dt) override;
  std::unique_ptr<tumble::Technique> clone() const override;
  std::span<const tumble::ContactRecord> contacts() const override { return records_; }
  std::vector<std::string> ignores(const tumble::World& world) const override;
  // [class]

 private:
  void substep(tumble::World& world, double h, tumble::StepReport& report);
  void find_contacts(const tumble::World& world, tumble::StepReport& report);
  void split_bodies();
  void push(double h);
  void rub();
  void record(double h, tumble::StepReport& report);

  CushionOptions options_;

  // Of one substep; kept so that a warm step asks for no memory.
  tumble::BoundingTree near_;
  std::vector<tumble::Bounds> bounds_;
  std::vector<tumble::IndexPair> pairs_;
  tumble::ContactList contacts_;
  std::vector<tumble::MovingBody> start_, moving_, split_;
  std::vector<tumble::ContactRecord> records_;
};

/// Name, options and maker, as the library has them of its own techniques.
/// \return the recipe
tumble::TechniqueRecipe cushion_recipe();

}  // namespace example
