/// \file
/// \brief The contact area of two boxes: faces clipped to each other, or edges that cross.
#include "tumble/geometry/manifold.hpp"

#include "tumble/base/error.hpp"
#include "tumble/base/index.hpp"
#include "tumble/base/tolerances.hpp"
#include "tumble/geometry/edge_crossing.hpp"
#include "tumble/geometry/edge_on_edge.hpp"
#include "tumble/geometry/rectangle_clip.hpp"
#include "tumble/geometry/tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace tumble {
namespace {

using Three = std::array<double, 3>;

// Takes out points that fall together with the one before them, or the last with the first.
void merge_repeated(double near, Manifold& out) {
  const auto same = [near](const ManifoldPoint& p, const ManifoldPoint& q) {
    return (p.position_w - q.position_w).cwiseAbs().maxCoeff() <= near;
  };
  std::size_t kept = 0;
  for (std::size_t i = 0; i < idx(out.count); ++i) {
    if (kept > 0 &&
        (same(out.points[i], out.points[kept - 1]) || same(out.points[i], out.points[0])))
      continue;
    out.points[kept++] = out.points[i];
  }
  out.count = static_cast<int>(kept);
}

// Two faces that look at each other, seen from the reference box: its axis r is the normal of the
// plane, its next two axes u and v span it.
struct FacePair {
  const Box& reference;
  const Box& incident;
  std::array<Three, 3> c;  // c[j][i] = axis i of the reference . axis j of the incident box
  Three d;                 // [m] from the reference to the incident centre, reference frame
  std::size_t r;           // axis of the reference face
  double side;             // +1 or -1: the face at the positive or negative end of that axis
  FeatureId reference_edges;
  FeatureId incident_edges;
};

// The face of the incident box that looks back most: the one at the end (+1 or -1) of its axis m.
// Its next two axes k and l span it.
struct IncidentFace {
  explicit IncidentFace(const FacePair& f) {
    const double look[3] = {std::abs(f.c[0][f.r]), std::abs(f.c[1][f.r]), std::abs(f.c[2][f.r])};
    const std::size_t one_of_two = look[1] > look[0] ? 1 : 0;
    m = look[2] > std::max(look[0], look[1]) ? 2 : one_of_two;
    k = kCycle[m + 1];
    l = kCycle[m + 2];
    end = -f.side * std::copysign(1.0, f.c[m][f.r]);
  }
  std::size_t m, k, l;
  double end;
};

// The four corners of the incident face as (x, y, height above the reference face).
void see_from_reference(const FacePair& f, const IncidentFace& face, ClipArea& area) {
  const double* h = f.reference.half.data();
  const double* g = f.incident.half.data();
  const double to_face = face.end * g[face.m];
  const auto seen = [&f](const Three& v, double scale) {
    return Three{scale * v[kCycle[f.r + 1]], scale * v[kCycle[f.r + 2]], f.side * scale * v[f.r]};
  };
  const Three d = seen(f.d, 1.0), out = seen(f.c[face.m], to_face);
  const Three along_k = seen(f.c[face.k], g[face.k]), along_l = seen(f.c[face.l], g[face.l]);
  const Three center{d[0] + out[0], d[1] + out[1], (d[2] - h[f.r]) + out[2]};
  area.count = 4;
  for (std::size_t x = 0; x < 3; ++x) {
    area.corners[0].x[x] = center[x] - along_k[x] - along_l[x];
    area.corners[1].x[x] = center[x] + along_k[x] - along_l[x];
    area.corners[2].x[x] = center[x] + along_k[x] + along_l[x];
    area.corners[3].x[x] = center[x] - along_k[x] + along_l[x];
  }
  for (std::size_t i = 0; i < 4; ++i) area.corners[i].line = i;
}

// Which box edge each of the eight lines of a ClipArea is.
std::array<FeatureId, 8> edges_of(const FacePair& f, const IncidentFace& face) {
  const bool e = face.end > 0.0, s = f.side > 0.0;
  const std::size_t u = kCycle[f.r + 1], v = kCycle[f.r + 2];
  const FeatureId r = f.reference_edges, i = f.incident_edges;
  return {i + edge_number(face.k, false, e), i + edge_number(face.l, e, true),
          i + edge_number(face.k, true, e),  i + edge_number(face.l, e, false),
          r + edge_number(v, s, false),      r + edge_number(v, s, true),
          r + edge_number(u, false, s),      r + edge_number(u, true, s)};
}

// The contact of two faces: the incident one clipped to the reference one.
void clip_faces(const FacePair& f, double margin, Manifold& out) {
  const std::size_t u = kCycle[f.r + 1], v = kCycle[f.r + 2];
  const Vec3& h = f.reference.half;
  const double h_u = h.data()[u], h_v = h.data()[v];
  const IncidentFace face(f);
  ClipArea area, scratch;
  see_from_reference(f, face, area);
  constexpr double kWider = 1.0 + tolerance::clip_slack;
  const ClipArea& clipped = clip_to_rectangle(area, scratch, h_u * kWider, h_v * kWider);
  const std::array<FeatureId, 8> edge = edges_of(f, face);

  // Points within the margin, halfway between the surfaces: all are written, and the count moves on
  // past those that stay.
  const Mat3& axes = f.reference.axes_w;
  const Vec3 x_w = axes.col(static_cast<int>(u)), y_w = axes.col(static_cast<int>(v));
  const Vec3 out_w = f.side * axes.col(static_cast<int>(f.r));
  const Vec3 face_w = f.reference.center_w + h.data()[f.r] * out_w;
  const double* g = f.incident.half.data();
  const double near =
      tolerance::same_point * std::min(std::max(h_u, h_v), std::max(g[face.k], g[face.l]));
  bool repeated = false;
  std::size_t count = 0;
  const ClipCorner* before = &clipped.corners[clipped.count > 0 ? clipped.count - 1 : 0];
  for (std::size_t i = 0; i < clipped.count; ++i) {
    const ClipCorner& p = clipped.corners[i];
    ManifoldPoint& point = out.points[count];
    point.position_w = face_w + p.x[0] * x_w + p.x[1] * y_w + (0.5 * p.x[2]) * out_w;
    point.distance = p.x[2];
    point.feature = name_of(edge[before->line], edge[p.line]);
    count += static_cast<std::size_t>(p.x[2] <= margin);
    repeated |= std::abs(p.x[0] - before->x[0]) <= near && std::abs(p.x[1] - before->x[1]) <= near;
    before = &p;
  }
  out.count = static_cast<int>(count);
  if (repeated) merge_repeated(near, out);
}

// The face axis of `found`, seen from the box that it belongs to.
void clip_along(const BoxPair& pair, const Separation& found, double margin, Manifold& out) {
  const std::array<Lanes, 3>& c = pair.c;
  if (found.axis < 3) {
    const double side = found.normal_w.dot(pair.first.axes_w.col(found.axis)) > 0.0 ? 1.0 : -1.0;
    const Lanes& d = pair.d_first;
    clip_faces(
        {pair.first,
         pair.second,
         {{{c[0][0], c[1][0], c[2][0]}, {c[0][1], c[1][1], c[2][1]}, {c[0][2], c[1][2], c[2][2]}}},
         {d[0], d[1], d[2]},
         idx(found.axis),
         side,
         0,
         kEdgesOfSecond},
        margin, out);
  } else {
    const int j = found.axis - 3;
    const double side = found.normal_w.dot(pair.second.axes_w.col(j)) > 0.0 ? -1.0 : 1.0;
    const Lanes& d = pair.d_second;
    clip_faces(
        {pair.second,
         pair.first,
         {{{c[0][0], c[0][1], c[0][2]}, {c[1][0], c[1][1], c[1][2]}, {c[2][0], c[2][1], c[2][2]}}},
         {-d[0], -d[1], -d[2]},
         idx(j),
         side,
         kEdgesOfSecond,
         0},
        margin, out);
  }
}

void write_point(const EdgeContact& contact, const Separation& found, Manifold& out) {
  out.points[0] = {contact.position_w, found.distance, contact.feature};
  out.count = 1;
}

// Where no two edges pass each other along the best axis, boxes that are apart by less than the
// margin are closest at two edges that lie beside each other, or at corners. So are boxes that just touch, where
// rounding hides along which axis. Those are found among the edges that reach farthest along the normal. Edges side
// by side are as close at both ends of the stretch that they share: with one point there the boxes would be pushed
// aside as if at a corner.
void write_nearest(const BoxPair& pair, const Separation& found, Manifold& out) {
  const EdgeContact nearest = nearest_edges(pair, found.normal_w, pair.rounding());
  write_point(nearest, found, out);
  if (nearest.stretch_w.isZero(0.0)) return;
  out.points[1] = out.points[0];
  out.points[1].feature |= kOtherEnd;
  out.points[0].position_w -= nearest.stretch_w;
  out.points[1].position_w += nearest.stretch_w;
  out.count = 2;
}

// Whether two edges that are parallel but for rounding lie far from each other, although the boxes just touch: along
// the axis between them rounding alone sees a distance, and other edges are nearest.
bool lie_elsewhere(const BoxPair& pair, const Separation& found, const EdgeContact& contact) {
  if (found.distance <= -pair.rounding()) return false;
  const double longest = 2.0 * std::max(pair.first.half.maxCoeff(), pair.second.half.maxCoeff());
  return std::sqrt(contact.apart2) >
         std::max(found.distance, 0.0) + tolerance::beside_the_normal * longest;
}

// Says whether the axis leads to a contact, or the boxes are too far apart along it to have one.
bool find_points(const BoxPair& pair, const Separation& found, double margin, Manifold& out) {
  out.normal_w = found.normal_w;
  out.axis = found.axis;
  out.count = 0;
  if (found.distance > margin) return true;
  if (found.axis >= 6) {
    const EdgeContact contact =
        cross_edges(pair, found.normal_w, (found.axis - 6) / 3, (found.axis - 6) % 3);
    write_point(contact, found, out);
    return contact.within && !lie_elsewhere(pair, found, contact);
  }
  clip_along(pair, found, margin, out);
  return out.count > 0;
}

// Refuses a caller's mistakes; the usual case costs two comparisons.
void check(double margin, AxisIndex axis, AxisIndex least, std::string_view name) {
  require::not_negative(margin, "margin");
  if (axis < least || axis > 14)
    refuse(std::string(name) + " = " + std::to_string(axis) + ": expected an axis from " +
           std::to_string(least) + " to 14");
}

}  // namespace

void find_manifold(const Box& first, const Box& second, const Separation& found, double margin,
                   Manifold& out) {
  check(margin, found.axis, 0, "found.axis");
  find_points(BoxPair(first, second), found, margin, out);
}

bool collide(const Box& first, const Box& second, double margin, AxisIndex remembered,
             Manifold& out) {
  check(margin, remembered, kNoAxis, "remembered");
  const BoxPair pair(first, second);
  SeparationOptions options{true, margin, remembered};
  Separation found;
  for (;;) {
    found = separation(pair, options);
    if (find_points(pair, found, margin, out)) break;
    // An axis that is almost the best may miss the contact area, as edges that pass beyond their
    // ends do. Then the memory goes first and the preference next: the best axis misses nothing if
    // the boxes overlap.
    if (options.remembered == kNoAxis && !options.prefer_faces) {
      if (found.axis >= 6 && found.distance > -pair.rounding()) write_nearest(pair, found, out);
      break;
    }
    if (options.remembered == kNoAxis) options.prefer_faces = false;
    options.remembered = kNoAxis;
  }
  turn_to_edges(pair, found.distance, margin, out);
  return out.count > 0;
}

void add_face_points(const Box& first, const Box& second, double margin, Manifold& manifold) {
  require::not_negative(margin, "margin");
  if (manifold.axis < 6 || manifold.count != 1) return;
  // The face that looks most along the normal, and what of the other box lies before it.
  Separation face;
  double along = 0.0;  // [-] cosine between the face's normal and that of the contact
  for (int k = 0; k < 6; ++k) {
    const Vec3 axis_w = k < 3 ? first.axes_w.col(k) : second.axes_w.col(k - 3);
    const double cosine = axis_w.dot(manifold.normal_w);
    if (std::abs(cosine) <= along) continue;
    along = std::abs(cosine);
    face.axis = k;
    face.normal_w = std::copysign(1.0, cosine) * axis_w;
  }
  Manifold found;
  clip_along(BoxPair(first, second), face, margin * along, found);
  const double longest = 2.0 * std::max(first.half.maxCoeff(), second.half.maxCoeff());
  const double near = tolerance::beside_the_normal * longest;
  const double out = face.axis < 3 ? 0.5 : -0.5;  // half, out of the box that the face belongs to
  const Vec3 crossing_w = manifold.points[0].position_w;
  for (std::size_t k = 0; k < idx(found.count) && manifold.count < Manifold::kMostPoints; ++k) {
    ManifoldPoint p = found.points[k];
    // From the other box's corner to the face, along the normal of the contact in place of the face's.
    const Vec3 corner_w = p.position_w + out * p.distance * face.normal_w;
    p.distance /= along;
    p.position_w = corner_w - out * p.distance * manifold.normal_w;
    if ((p.position_w - crossing_w).norm() > near) manifold.points[idx(manifold.count++)] = p;
  }
}

void flip(Manifold& manifold) {
  manifold.normal_w = -manifold.normal_w;
  const AxisIndex axis = manifold.axis;
  if (axis >= 6) {
    manifold.axis = 6 + 3 * ((axis - 6) % 3) + (axis - 6) / 3;
  } else if (axis != kNoAxis) {
    manifold.axis = axis < 3 ? axis + 3 : axis - 3;
  }
}

}  // namespace tumble
