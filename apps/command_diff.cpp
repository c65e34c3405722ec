/// \file
/// \brief `tumble diff`: the first frame and body at which two recorded runs part.
#include "tumble/base/number_text.hpp"
#include "tumble/math/rotation.hpp"
#include "tumble/record/recorded_run.hpp"

#include "request.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tumble::app {
namespace {

// How two runs part, or nothing.
using Parting = std::optional<std::string>;

const std::string& name_of(const RecordedRun& run, const RecordedPose& pose) {
  return run.scene.boxes[static_cast<std::size_t>(pose.box)].name;
}

const RecordedPose* find(const RecordedRun& run, const RecordedFrame& frame,
                         const std::string& name) {
  for (const RecordedPose& pose : frame.poses)
    if (name_of(run, pose) == name) return &pose;
  return nullptr;
}

double largest(const Vec3& difference) { return difference.cwiseAbs().maxCoeff(); }

// Of one body in one frame: each quantity that has other bits, and by how much a coordinate differs at most.
Parting parted(const RecordedPose& a, const RecordedPose& b) {
  struct Quantity {
    const char* name;
    const char* unit;
    bool equal;
    double apart;
  };
  const std::array<Quantity, 4> quantities = {{
      {"position", " m", a.position_w == b.position_w, largest(a.position_w - b.position_w)},
      {"orientation", " rad", a.orientation_wb.coeffs() == b.orientation_wb.coeffs(),
       angle_between(a.orientation_wb, b.orientation_wb)},
      {"velocity", " m/s", a.velocity_w == b.velocity_w, largest(a.velocity_w - b.velocity_w)},
      {"angular velocity", " rad/s", a.angular_velocity_w == b.angular_velocity_w,
       largest(a.angular_velocity_w - b.angular_velocity_w)},
  }};
  std::string out;
  for (const Quantity& q : quantities)
    if (!q.equal)
      out.append(out.empty() ? "" : ", ")
          .append(q.name)
          .append(" by ")
          .append(rounded_text(q.apart, 3) + q.unit);
  return out.empty() ? Parting() : Parting(out);
}

Parting parted(const RecordedRun& first, const RecordedFrame& a, const RecordedRun& second,
               const RecordedFrame& b) {
  if (a.time != b.time)
    return "the frame is at " + shortest_text(a.time) + " s in the first run and at " +
           shortest_text(b.time) + " s in the second";
  for (const RecordedPose& pose : a.poses) {
    const std::string& name = name_of(first, pose);
    const RecordedPose* other = find(second, b, name);
    if (other == nullptr) return name + " is in the first run only";
    if (const Parting how = parted(pose, *other)) return name + ": " + *how;
  }
  for (const RecordedPose& pose : b.poses)
    if (find(first, a, name_of(second, pose)) == nullptr)
      return name_of(second, pose) + " is in the second run only";
  return {};
}

}  // namespace

int diff_command(const std::string& first, const std::string& second) {
  const RecordedRun one = read_run(first);
  const RecordedRun two = read_run(second);
  const std::size_t both = std::min(one.frames.size(), two.frames.size());
  for (std::size_t k = 0; k < both; ++k) {
    const Parting how = parted(one, one.frames[k], two, two.frames[k]);
    if (!how) continue;
    std::printf("first difference at %s s, frame %zu:\n  %s\n",
                rounded_text(one.frames[k].time, 6).c_str(), k, how->c_str());
    if (k == 0) std::printf("frame 0 is the start: these are other scenes or settings\n");
    if (k > 0) std::printf("frames 0 (the start) to %zu are equal\n", k - 1);
    return kDiffer;
  }
  if (one.frames.size() == two.frames.size()) {
    std::printf("equal: %zu frames have the same bits\n", both);
    return kDone;
  }
  const bool longer = one.frames.size() > both;
  std::printf("%zu frames have the same bits, then the %s run continues to %s s\n", both,
              longer ? "first" : "second",
              rounded_text((longer ? one : two).frames.back().time, 6).c_str());
  return kDiffer;
}

}  // namespace tumble::app
