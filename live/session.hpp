/// \file
/// \brief One interactive simulation: opened by a text request, stepped, changed by throws, and drawn.
#pragma once

#include "tumble/record/metrics.hpp"
#include "tumble/scenes/simulation.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// The library behind the live page.
namespace tumble::live {

/// A scene and a technique, made from a request.
struct Setup {
  Scene scene;                           ///< checked
  std::unique_ptr<Technique> technique;  ///< with no step done
};

/// Reads a request.
///
/// A request is a text of lines, in any order:
/// - `scene NAME` or, as the last line, `toml` followed by a scene file;
/// - `technique NAME`; the default one if there is none;
/// - `seed N`, 1 if there is none;
/// - `set scene.KEY=VALUE` and `set technique.KEY=VALUE`.
/// \param request the text
/// \return the same scene and technique that `tumble run` makes of the same words
/// \throws std::invalid_argument saying which word is wrong and what would be right
Setup make_setup(std::string_view request);

/// Parts of a look besides poses. Bits.
enum Look : unsigned {
  kLookContacts = 1U,   ///< contact points
  kLookStable = 2U,     ///< geometrically stable boxes, by the hull of their supports (thesis 5.4)
  kLookIslands = 4U,    ///< islands: bodies that touch, directly or over others
  kLookOverlap = 8U,    ///< depth of each body in another
  kLookPivots = 16U,    ///< the points about which bodies turn (thesis 6.2)
  kLookBalanced = 32U,  ///< boxes stable by static equilibrium too; in place of kLookStable
};

/// Numbers of one body in a look: id, position now (3), orientation now (x y z w), size (3), position
/// and orientation before the last step (7), kind, island, overlap, pivot (3).
inline constexpr int kBodyNumbers = 24;
/// Numbers of one contact point or event: time, indices of two bodies, point (3), normal (3), push on
/// the second (3), whether that is an impulse, and ContactState (3: a collision).
inline constexpr int kContactNumbers = 14;

/// Kinds of bodies in a look. Bits.
enum Kind : unsigned {
  kFixed = 1U,   ///< immovable
  kAsleep = 2U,  ///< sleeps
  kStable = 4U,  ///< geometrically stable, if that was asked for
  kThrown = 8U,  ///< was thrown in
};

/// A simulation with the numbers that the page draws.
class Session {
 public:
  /// Most boxes that can be thrown in: each stays until the session ends.
  static constexpr int kMostThrown = 500;

  /// Opens at time 0.
  /// \param request see make_setup()
  /// \throws std::invalid_argument as make_setup()
  explicit Session(std::string_view request);
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// One step.
  /// \param dt [s] above 0
  /// \return how it ended
  /// \throws std::invalid_argument if the technique refuses the scene
  StepStatus step(double dt);

  /// Throws a box; called thrown1, thrown2, ..., whatever is free in the scene.
  /// \param box as Simulation::throw_in() takes it
  /// \throws std::invalid_argument as that, and after kMostThrown boxes
  void throw_in(SceneBox box);

  /// Takes a box away.
  /// \param id of a body
  /// \throws std::invalid_argument as Simulation::take_away()
  void take_away(BodyId id);

  /// Fills bodies(), contacts() and numbers().
  /// \param wanted bits of Look
  void look(unsigned wanted);

  /// kBodyNumbers for each body but the ground.
  /// \return as of the last look()
  [[nodiscard]] const std::vector<double>& bodies() const { return bodies_; }
  /// kContactNumbers for each contact point of the last step, then for each collision since the last look().
  /// Indices are those of World.
  /// \return as of the last look()
  [[nodiscard]] const std::vector<double>& contacts() const { return contacts_; }
  /// In the order of number_names().
  /// \return as of the last look()
  [[nodiscard]] const std::vector<double>& numbers() const { return numbers_; }
  /// Names of the numbers.
  /// \return one for each of numbers()
  static const std::vector<std::string_view>& number_names();

  /// The simulation.
  /// \return its world and scene
  [[nodiscard]] const Simulation& run() const { return run_; }
  /// Energies, overlap and chatter.
  /// \return after the last step
  [[nodiscard]] const Metrics& metrics() const { return meter_.metrics(); }
  /// Parts of the physics that the technique leaves out.
  /// \return words such as "friction"
  [[nodiscard]] std::vector<std::string> ignored() const {
    return run_.technique().ignores(run_.world());
  }

 private:
  class EventList : public Observer {
   public:
    void on_event(const Event& event) override;
    EventLog log;
  };

  explicit Session(Setup setup);
  void look_at_bodies(unsigned wanted);
  void look_at_contacts();
  void find_pivots();
  void find_stable(bool balanced);
  void find_islands();

  Simulation run_;
  MetricsMeter meter_;
  EventList events_;
  StepReport report_;
  std::vector<BodyId> ids_before_;  // of the last step
  std::vector<BodyState> states_before_;
  int thrown_ = 0;
  OverlapMeter overlap_;

  std::vector<double> bodies_;
  std::vector<double> contacts_;
  std::vector<double> numbers_;
  std::vector<char> stable_;    // by index, while a look is made
  std::vector<int> island_of_;  // ditto; -1: none
  std::vector<Vec3> pivots_w_;  // [m] ditto; NaN: none
};

}  // namespace tumble::live
