// Where a thrown box starts and how fast it flies. Plain numbers, arrays of 3; nothing of the picture.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// The velocity [m/s] with which something thrown from `origin` passes through `point`.
//
// A path d = v t + g t^2 / 2 with |v| = speed gives a quadratic equation for t^2; its smaller root is the
// flatter path. Without a root the point is out of reach, and the throw goes straight at it.
export function aim({origin, point}, speed, gravity = [0, -9.81, 0]) {
  const way = point.map((x, k) => x - origin[k]);
  const length = Math.sqrt(dot(way, way));
  if (!(length > 0)) return [0, 0, -speed];
  const b = speed * speed + dot(way, gravity);
  const root = b * b - dot(gravity, gravity) * length * length;
  if (b <= 0 || root < 0) return way.map(x => x * speed / length);
  const t = length * Math.sqrt(2 / (b + Math.sqrt(root)));
  return way.map((x, k) => x / t - gravity[k] * t / 2);
}

// A box is thrown from this share of the way to what was clicked, and this share of it below.
const NEARER = 0.2;
const LOWER = 0.06;

// Where a throw starts, aimed from the eye at `from` along `way`, unit length, at something `distance` away:
// below the line of sight, where it is seen to come in; further back while it meets something; not under
// `lowest`.
export function startOfThrow(from, way, below, distance, {edge, lowest, meets}) {
  const start = from.map((x, k) => x + distance * (NEARER * way[k] + LOWER * below[k]));
  for (let tries = 0; tries < 100; ++tries) {
    start[1] = Math.max(start[1], lowest);
    if (!meets(start)) break;
    way.forEach((x, k) => start[k] -= edge * x);
  }
  return start;
}

// How far along a ray, in lengths of `direction`, it enters a box; Infinity if it misses it or starts in it.
// `turn` is the box's orientation as a quaternion (x y z w), `half` its half edges.
export function enterBox(origin, direction, centre, turn, half) {
  const from = turnBack(turn, origin.map((x, k) => x - centre[k]));
  const along = turnBack(turn, direction);
  let enter = 0;
  let leave = Infinity;
  for (let k = 0; k < 3; ++k) {
    const near = (-Math.sign(along[k] || 1) * half[k] - from[k]) / along[k];
    const far = (Math.sign(along[k] || 1) * half[k] - from[k]) / along[k];
    if (along[k] === 0 && Math.abs(from[k]) > half[k]) return Infinity;
    if (along[k] === 0) continue;
    enter = Math.max(enter, near);
    leave = Math.min(leave, far);
  }
  return enter > 0 && enter <= leave ? enter : Infinity;
}

// How far a point is from a box; 0 inside.
export function distanceToBox(point, centre, turn, half) {
  const p = turnBack(turn, point.map((x, k) => x - centre[k]));
  return Math.hypot(...p.map((x, k) => Math.max(0, Math.abs(x) - half[k])));
}

// A vector in the frame of a body that is turned by the quaternion `turn` (x y z w).
export function turnBack([x, y, z, w], [a, b, c]) {
  // v + 2 w c + 2 c x u with c = v x u, u the quaternion's vector part.
  const p = b * z - c * y;
  const q = c * x - a * z;
  const r = a * y - b * x;
  return [a + 2 * (w * p + q * z - r * y), b + 2 * (w * q + r * x - p * z), c + 2 * (w * r + p * y - q * x)];
}
