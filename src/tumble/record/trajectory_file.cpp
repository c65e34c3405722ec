/// \file
/// \brief Writing trajectories, as computed and as shown.
#include "tumble/record/trajectory_file.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/number_text.hpp"

namespace tumble {
namespace {

constexpr std::string_view kHeader =
    "time_s,body,px_m,py_m,pz_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s";

}  // namespace

TrajectoryFile::TrajectoryFile(std::filesystem::path path) : table_(std::move(path), kHeader) {}

void TrajectoryFile::write(const World& world) {
  for (int i = 0; i < world.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const BodyProperties& body = world.bodies()[k];
    if (body.shape == Shape::ground) continue;
    const BodyState& state = world.states()[k];
    write(world.time(), world.name(i), state, velocity(body, state), angular_velocity(body, state));
  }
}

void TrajectoryFile::write(double time, std::string_view name, const BodyState& pose,
                           const Vec3& velocity_w, const Vec3& angular_velocity_w) {
  const Quat& q = pose.orientation_wb;
  table_.cell(time).cell(name).cell(pose.position_w).cell(q.w()).cell(Vec3(q.vec()));
  table_.cell(velocity_w).cell(angular_velocity_w).end_row();
}

FilteredTrajectoryFile::FilteredTrajectoryFile(std::filesystem::path path, const PoseFilter& filter)
    : table_(std::move(path)), filter_(filter.clone()) {
  filter_->finish([](const Frame&) {});  // what the filter may have seen is of another run
}

void FilteredTrajectoryFile::write(const World& world) {
  if (!refusal_.empty()) return;
  std::vector<Velocities>& moves = moves_.emplace_back();
  for (int i = 0; i < world.count(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const BodyProperties& body = world.bodies()[k];
    const BodyState& state = world.states()[k];
    known_.try_emplace(world.ids()[k], Known{world.name(i), body.shape == Shape::ground});
    moves.push_back({velocity(body, state), angular_velocity(body, state)});
  }
  try {
    for (std::size_t k = 0; k < moves.size(); ++k)  // poses are the filter's to look at
      if (!moves[k].velocity_w.allFinite() || !moves[k].angular_velocity_w.allFinite())
        refuse("frame at " + shortest_text(world.time()) + " s, body " +
               world.name(static_cast<int>(k)) + ": its velocity is not finite");
    filter_->add(frame_of(world), [this](const Frame& frame) { show(frame); });
  } catch (const std::invalid_argument& error) {
    refusal_ = error.what();
    moves_.pop_back();
  }
}

void FilteredTrajectoryFile::finish() {
  filter_->finish([this](const Frame& frame) { show(frame); });
  table_.flush();
}

// The angular velocity is that of the orientation as computed, so it was kept with the frame.
void FilteredTrajectoryFile::show(const Frame& frame) {
  const std::vector<Velocities>& moves = moves_.front();
  for (std::size_t k = 0; k < frame.ids.size(); ++k) {
    const Known& body = known_.at(frame.ids[k]);
    if (body.ground) continue;
    table_.write(frame.time, body.name, frame.states[k], moves[k].velocity_w,
                 moves[k].angular_velocity_w);
  }
  moves_.pop_front();
  ++frames_;
}

}  // namespace tumble
