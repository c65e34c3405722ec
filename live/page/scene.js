// What the page wants to know of a scene: what it stands on, what suits it, where its boxes go.
import {BODY} from './module.js';

const GO = 0.6;  // [s] for which boxes are followed to see where the camera has to look
const FAR = 10;  // edges that a box goes in that time at most, where the scene is not larger

// Of a scene file as the module writes it: no reader of TOML in general.
export function readScene(toml) {
  const vector = (part, key) =>
    JSON.parse(part.match(new RegExp(`^${key} = (\\[.*\\])$`, 'm'))?.[1] ?? '[0, 0, 0]');
  const [head, ...boxes] = toml.split('\n[[joint]]\n')[0].split('\n[[box]]\n');
  return {
    gravity: vector(head, 'gravity'),
    ground: /^\[ground\]$/m.test(head),
    boxes: boxes.map(part => ({
      name: JSON.parse(part.match(/^name = (".*")$/m)[1]),
      size: vector(part, 'size'),
      position: vector(part, 'position'),
      velocity: vector(part, 'velocity'),
      mass: Number(part.match(/^mass = (.*)$/m)?.[1]),
      fixed: /^fixed = true$/m.test(part),
      late: /^appears = /m.test(part),
    })),
  };
}

// A box to throw: like those of the scene, a few times heavier, and about as fast as the thesis's (6.1).
export function suited({boxes}) {
  const moving = boxes.filter(({fixed}) => !fixed);
  const middle = values => values.sort((a, b) => a - b)[values.length >> 1] ?? 1;
  const short = value => Number(value.toPrecision(2));
  const edge = short(middle(moving.map(({size}) => Math.cbrt(size[0] * size[1] * size[2]))));
  return {speed: short(20 * Math.sqrt(edge)), mass: short(5 * middle(moving.map(({mass}) => mass))), edge};
}

// The bodies of the start, and once more where those that move will be: what a camera should have in sight.
export function reach(bodies, {boxes, ground}) {
  const start = boxes.filter(({late}) => !late);
  if (start.length * BODY.size !== bodies.length) return bodies;
  const span = k => {
    const along = start.map(({position}) => position[k]);
    return Math.max(...along) - Math.min(...along);
  };
  const size = Math.hypot(...[0, 1, 2].map(span));
  const all = [...bodies];
  start.forEach(({size: edges, velocity}, row) => {
    const speed = Math.hypot(...velocity);
    if (speed === 0) return;
    const time = Math.min(GO, Math.max(size, FAR * Math.max(...edges)) / speed);
    const there = bodies.slice(row * BODY.size, (row + 1) * BODY.size);
    velocity.forEach((v, k) => { there[BODY.now + k] += v * time; });
    if (ground) there[BODY.now + 1] = Math.max(there[BODY.now + 1], edges[1] / 2);
    all.push(...there);
  });
  return Float64Array.from(all);
}
