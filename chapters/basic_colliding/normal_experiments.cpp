/// \file
/// \brief Experiment on the normal of a point in a box: signed distance, closest face (thesis 3.3.2).
#include "tumble/dynamics/integrate.hpp"
#include "tumble/geometry/signed_distance.hpp"

#include "basic_colliding/counted.hpp"

namespace tumble::chapters {
namespace {

// --- operations ----------------------------------------------------------------------------

Box random_box(Random& random) {
  const Vec3 center = random.in_cube(1.0);
  const Quat orientation = random.orientation();
  const Vec3 size = random.in_cube(0.5) + Vec3::Ones();
  return make_box(center, orientation, size);
}

bool same_bits(const CountedVector& counted, const Vec3& vector) {
  return counted[0].value == vector[0] && counted[1].value == vector[1] &&
         counted[2].value == vector[2];
}

// What all queries of one kind took.
struct Work {
  std::int64_t queries = 0;
  Operations signed_distance;
  Operations closest_face;
};

// Points anywhere in twice the box, so that an eighth of them lies inside.
std::array<Work, 2> count_operations(int queries) {
  std::array<Work, 2> work;  // outside, inside
  for (int k = 0; k < queries; ++k) {
    Random random = Random(1).fork(static_cast<std::uint64_t>(k));
    const Box box = random_box(random);
    const Vec3 point_w =
        box.center_w + box.axes_w * (2.0 * box.half.cwiseProduct(random.in_cube(1.0)));
    const SignedDistance truth = signed_distance(box, point_w);
    Work& mine = work[truth.distance <= 0.0 ? 1 : 0];
    ++mine.queries;
    const CountedNormal distance = counted_signed_distance(box, point_w, mine.signed_distance);
    const CountedNormal face = counted_closest_face(box, point_w, mine.closest_face);
    const bool inside = truth.distance <= 0.0;
    if (distance.distance.value != truth.distance ||
        !same_bits(distance.normal_w, truth.gradient_w) ||
        (inside && !same_bits(face.normal_w, truth.gradient_w)))
      throw std::runtime_error("the counted functions are not the library's");
  }
  return work;
}

double mean(std::int64_t operations, const Work& work) {
  return static_cast<double>(operations) / static_cast<double>(work.queries);
}

// --- angles --------------------------------------------------------------------------------

constexpr double kNear = 0.1;  // [m] from the surface of a cube of 1 m
constexpr int kBins = 19;      // around 0, 10, ... 180 degrees

// Angles between a face's normal and the gradient, inside and outside.
struct Angles {
  std::array<double, kBins> bins{};
  double frames = 0.0;
  double off = 0.0;      // by more than 10 degrees
  double off_now = 0.0;  // the same for the closest face of the same frame
  void add(double last, double now) {
    frames += 1.0;
    bins[static_cast<std::size_t>(last / 10.0 + 0.5)] += 1.0;
    off += last > 10.0 ? 1.0 : 0.0;
    off_now += now > 10.0 ? 1.0 : 0.0;
  }
};

// The outward normal of the face that is closest to a point, in the box's own frame.
Vec3 closest_face_b(const Vec3& point_b, const Vec3& half) {
  int axis = 0;
  (point_b.cwiseAbs() - half).maxCoeff(&axis);
  return point_b[axis] < 0.0 ? Vec3(-Vec3::Unit(axis)) : Vec3(Vec3::Unit(axis));
}

double degrees_between(const Vec3& a, const Vec3& b) {
  const double cosine = std::clamp(a.dot(b), -1.0, 1.0);
  return elementary::acos(cosine) * 180.0 / std::numbers::pi;
}

// A corner of one tumbling cube passes another tumbling cube, frame by frame, for half a second in
// the middle of which it is near the surface.
void follow(double speed, double spin, Random random, Angles& inside, Angles& outside) {
  constexpr int frames = 30;
  const BodyProperties cube = box_properties(Vec3::Ones(), 1.0);
  const Vec3 half = Vec3::Constant(0.5);
  const Quat box_wb = random.orientation();
  const Vec3 box_spin_w = random.uniform(0.0, spin) * random.direction();
  const Quat other_wb = random.orientation();
  const Vec3 other_spin_w = random.uniform(0.0, spin) * random.direction();
  const Vec3 velocity_w = speed * random.direction();
  Vec3 meeting_b = random.in_cube(0.5 + kNear);
  while (std::abs(meeting_b.cwiseAbs().maxCoeff() - 0.5) > kNear)
    meeting_b = random.in_cube(0.5 + kNear);

  // Where it all is in the middle of the path, and from there back to the beginning.
  BodyState box = make_state(cube, Vec3::Zero(), box_wb, Vec3::Zero(), box_spin_w);
  const Vec3 other_w = box_wb * meeting_b - other_wb * half;
  BodyState other = make_state(cube, other_w, other_wb, velocity_w, other_spin_w);
  const auto fly_both = [&](double time) {
    fly(cube, box, Vec3::Zero(), time, RotationRule::frozen);
    fly(cube, other, Vec3::Zero(), time, RotationRule::frozen);
  };
  fly_both(-0.5 * frames * kStep);
  Vec3 last_b = Vec3::Zero();
  for (int k = 0; k <= frames; ++k, fly_both(kStep)) {
    const Box now = box_of(cube, box);
    const Vec3 corner_w = other.position_w + other.orientation_wb * half;
    const Vec3 face_b = closest_face_b(now.axes_w.transpose() * corner_w, half);
    const SignedDistance truth = signed_distance(now, corner_w);
    if (k > 0 && std::abs(truth.distance) <= kNear) {
      const Vec3 gradient_b = now.axes_w.transpose() * truth.gradient_w;
      (truth.distance <= 0.0 ? inside : outside)
          .add(degrees_between(last_b, gradient_b), degrees_between(face_b, gradient_b));
    }
    last_b = face_b;
  }
}

// Paths with one speed.
struct Paths {
  Angles inside;
  Angles outside;
};

Paths follow_all(int count, double speed, double spin) {
  Paths paths;
  for (int k = 0; k < count; ++k)
    follow(speed, spin, Random(2).fork(static_cast<std::uint64_t>(k)), paths.inside, paths.outside);
  return paths;
}

// --- tables --------------------------------------------------------------------------------

std::vector<double> row_of(double number, const Operations& operations, const Work& work) {
  return {number, mean(operations.sums, work), mean(operations.products, work),
          mean(operations.divisions + operations.roots, work), mean(operations.choices, work)};
}

Table operations_table(const std::array<Work, 2>& work) {
  return {
      "",
      {{"kind", "-", "1 closest face, 2 signed distance inside, 3 signed distance outside"},
       {"sums", "-", "additions and subtractions per query"},
       {"products", "-", "multiplications"},
       {"divisions", "-", "divisions and square roots"},
       {"choices", "-", "comparisons, absolute values, maxima"}},
      {row_of(1.0, work[1].closest_face, work[1]), row_of(2.0, work[1].signed_distance, work[1]),
       row_of(3.0, work[0].signed_distance, work[0])}};
}

Table angles_table(const Paths& paths) {
  Table table{"angles",
              {{"angle_deg", "deg", "middle of the bin"},
               {"inside", "-", "share of the frames inside"},
               {"outside", "-", "share of the frames outside"}}};
  for (std::size_t k = 0; k < kBins; ++k)
    table.add(10.0 * static_cast<double>(k), paths.inside.bins[k] / paths.inside.frames,
              paths.outside.bins[k] / paths.outside.frames);
  return table;
}

Result measure_signed_distance(const Parameters& settings) {
  const std::array<Work, 2> work = count_operations(settings.count("queries"));
  const auto arithmetic = [&](const Work& of) {
    return static_cast<double>(of.signed_distance.arithmetic()) /
           static_cast<double>(of.closest_face.arithmetic());
  };
  // Every query inside costs the same, and every one outside: chance has a say only in how many lie
  // inside.
  Quantity ratio =
      share_of_trials("arithmetic operations of the signed distance over those of the closest face",
                      work[1].queries, work[0].queries + work[1].queries);
  const double outside = arithmetic(work[0]);
  const double gain = outside - arithmetic(work[1]);
  ratio.value = outside - gain * ratio.value;
  std::swap(ratio.low, ratio.high);
  ratio.low = outside - gain * ratio.low;
  ratio.high = outside - gain * ratio.high;

  const int count = settings.count("paths");
  const double spin = settings.number("spin");
  const Paths paths = follow_all(count, settings.number("speed"), spin);
  Table speeds{"speeds",
               {{"speed_m_s", "m/s", "of the corner against the box's centre"},
                {"travel", "-", "in a frame of 1/60 s, over the edge of the box"},
                {"inside", "-", "share of the frames inside with a normal off by over 10 degrees"},
                {"outside", "-", "the same, outside"},
                {"outside_now", "-", "the same, closest face of this very frame"}}};
  for (const double speed : {0.5, 1.0, 2.0, 4.0, 8.0, 16.0}) {
    const Paths at = follow_all(count, speed, spin);
    speeds.add(speed, speed * kStep, at.inside.off / at.inside.frames,
               at.outside.off / at.outside.frames, at.outside.off_now / at.outside.frames);
  }
  return {{operations_table(work), angles_table(paths), speeds},
          {ratio,
           {"the same, inside the box", "-", arithmetic(work[1])},
           {"frames inside with a normal off by over 10 degrees", "-",
            paths.inside.off / paths.inside.frames}}};
}

const Registered claim_3_3_2b_signed_distance_figure{
    {.name = "claim_3_3_2b_signed_distance",
     .parameters = {whole("queries", 1000000, 100, 100000000, "random boxes and points"),
                    whole("paths", 40000, 10, 1000000,
                          "random paths of a corner past a box, per speed"),
                    number("speed", 2.0, 0.0, 1000.0, "m/s", "of the corner in the histogram"),
                    number("spin", 5.0, 0.0, 100.0, "rad/s", "largest spin of either body")},
     .quick = {"queries=20000", "paths=1000"},
     .experiment = measure_signed_distance}};

}  // namespace
}  // namespace tumble::chapters
