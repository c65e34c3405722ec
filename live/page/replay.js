// Runs of `tumble run` that are played: trajectory.csv for the poses, scene.toml for the sizes of the boxes.
import {BODY, KIND} from './module.js';

const COLUMNS = 'time_s,body,px_m,py_m,pz_m,qw,qx,qy,qz,vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s';
const NAMES = COLUMNS.split(',');
const POSE = 7;  // numbers of a pose as they are kept: position, x y z w
export const LARGEST = 300e6;  // [bytes] of a file; a browser gives no more memory for it

// A sentence that names the file, the line and what would be right.
export class BadFile extends Error {}

// Cells of a line; a name with a comma or a quote in it stands in quotes, and a quote in it is doubled.
function cellsOf(line) {
  if (!line.includes('"')) return line.split(',');
  const cells = [...line.matchAll(/(?:^|,)(?:"((?:[^"]|"")*)"|([^,"]*))/g)];
  return cells.map(([, quoted, bare]) => (quoted === undefined ? bare : quoted.replaceAll('""', '"')));
}

// Poses frame by frame: {names, times, first, who, poses, lines, note}. Rows first[k] to first[k + 1] are
// frame k; who[row] is a place in names, poses[POSE * row] begins its pose, lines[k] is a frame's first line.
export function readTrajectory(text, file) {
  let line = 1;
  const refuse = what => { throw new BadFile(`${file}, line ${line}: ${what}`); };
  let end = text.indexOf('\n');
  if (text.slice(0, end < 0 ? text.length : end).trim() !== COLUMNS)
    refuse(`expected the columns ${COLUMNS}, as tumble run writes them into trajectory.csv.`);
  const places = new Map();
  const [times, first, who, poses, lines, seen] = [[], [], [], [], [], []];
  let note = '';
  for (let at = end + 1; end >= 0 && at < text.length; at = end + 1) {
    line += 1;
    end = text.indexOf('\n', at);
    if (end < 0) end = text.length;
    const row = text.slice(at, end).replace(/\r$/, '');
    const cells = cellsOf(row);
    if (cells.length !== NAMES.length)
      refuse(`${cells.length} cells where ${NAMES.length} are expected: the file is cut off or was changed.`);
    const numbers = cells.map((cell, k) => (k === 1 || cell.trim() === '' ? NaN : Number(cell)));
    const bad = numbers.findIndex((number, k) => k !== 1 && !Number.isFinite(number));
    if (bad >= 0) {
      if (!/^[+-]?(nan|inf)/i.test(cells[bad])) refuse(`${NAMES[bad]} = ${cells[bad]}: expected a number.`);
      // A run that breaks off leaves such a frame as its last; what comes before it is played.
      note = `line ${line}: ${NAMES[bad]} is not finite, so the recording ends before it.`;
      if (numbers[0] === times[times.length - 1]) {
        who.length = first.pop();
        poses.length = POSE * who.length;
        times.pop();
      }
      if (times.length === 0) refuse(`${NAMES[bad]} is not finite, so there is nothing to play.`);
      break;
    }
    const [time, , x, y, z, qw, qx, qy, qz] = numbers;
    if (Math.abs(qw * qw + qx * qx + qy * qy + qz * qz - 1) > 1e-3)
      refuse(`the orientation of ${cells[1]} is not of length 1: the file was changed.`);
    if (times.length === 0 || time > times[times.length - 1]) {
      times.push(time);
      first.push(who.length);
      lines.push(line);
    } else if (time < times[times.length - 1]) {
      refuse(`time_s = ${cells[0]} after ${times[times.length - 1]}: expected times that grow.`);
    }
    if (!places.has(cells[1])) places.set(cells[1], places.size);
    const place = places.get(cells[1]);
    if (seen[place] === times.length)
      refuse(`${cells[1]} is there twice at ${cells[0]} s: expected each box once.`);
    seen[place] = times.length;
    who.push(place);
    poses.push(x, y, z, qx, qy, qz, qw);
  }
  if (times.length === 0) refuse('there are no rows after it, so there is nothing to play.');
  first.push(who.length);
  return {
    file, note, lines, names: [...places.keys()], times: Float64Array.from(times),
    first: Uint32Array.from(first), who: Uint32Array.from(who), poses: Float64Array.from(poses),
  };
}

const text = vector => `(${vector.map(x => Number(x.toPrecision(6))).join(', ')})`;

// A trajectory and its scene, frame by frame in the numbers of live/session.hpp.
export class Recording {
  constructor(trajectory, scene, sceneFile) {
    Object.assign(this, trajectory);
    const byName = new Map(scene.boxes.map(box => [box.name, box]));
    this.boxes = this.names.map(name => byName.get(name));
    this.check(scene, sceneFile);
    this.at = -1;  // the frame in this.bodies
    this.rows = new Int32Array(this.names.length);  // of each body in the frame before
  }

  check(scene, sceneFile) {
    const {file} = this;
    const refuse = (line, what) => {
      throw new BadFile(`${file}, line ${line}: ${what}: choose the ${file} and the scene.toml of one run.`);
    };
    const start = this.who.subarray(0, this.first[1]);
    const here = new Set(start);
    for (let k = 0; k + 1 < this.first.length; ++k)
      for (let row = this.first[k]; row < this.first[k + 1]; ++row)
        if (!this.boxes[this.who[row]])
          refuse(this.lines[k] + row - this.first[k],
            `${sceneFile} has no box called ${this.names[this.who[row]]}`);
    for (const {name, late} of scene.boxes)
      if (!late && this.times[0] === 0 && !here.has(this.names.indexOf(name)))
        refuse(this.lines[0], `the first frame has no ${name}, which is in ${sceneFile}`);
    start.forEach((place, row) => {
      const {name, size, position, late} = this.boxes[place];
      const found = [...this.poses.subarray(POSE * row, POSE * row + 3)];
      const off = Math.hypot(...found.map((x, k) => x - position[k]));
      // A filter moves boxes a little at the start.
      if (this.times[0] === 0 && !late && off > Math.min(...size))
        refuse(this.lines[0] + row,
          `${name} starts at ${text(found)}, and at ${text(position)} in ${sceneFile}`);
    });
  }

  get frames() {
    return this.times.length;
  }

  get duration() {
    return this.times[this.frames - 1] - this.times[0];
  }

  // The frame to which time [s] belongs: the first that is not before it.
  frameAt(time) {
    let [low, high] = [0, this.frames - 1];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle] < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  // Bodies of frame k, with their poses in the frame before it.
  bodiesOf(k) {
    if (k === this.at) return this.bodies;
    this.rows.fill(-1);
    if (k > 0) for (let row = this.first[k - 1]; row < this.first[k]; ++row) this.rows[this.who[row]] = row;
    const bodies = new Float64Array(BODY.size * (this.first[k + 1] - this.first[k]));
    for (let row = this.first[k], to = 0; row < this.first[k + 1]; ++row, to += BODY.size) {
      const place = this.who[row];
      const {size, fixed, name} = this.boxes[place];
      const before = this.rows[place] < 0 ? row : this.rows[place];
      bodies[to + BODY.id] = place;
      bodies.set(this.poses.subarray(POSE * row, POSE * (row + 1)), to + BODY.now);
      bodies.set(size, to + BODY.edges);
      bodies.set(this.poses.subarray(POSE * before, POSE * (before + 1)), to + BODY.before);
      bodies[to + BODY.kind] = (fixed ? KIND.fixed : 0) | (name.startsWith('thrown') ? KIND.thrown : 0);
      bodies[to + BODY.island] = -1;
      bodies.fill(NaN, to + BODY.pivot, to + BODY.pivot + 3);
    }
    this.at = k;
    this.bodies = bodies;
    return bodies;
  }
}

// Plays a recording: time goes on while it is played, and is moved by hand.
export class Player {
  constructor(recording) {
    this.recording = recording;
    this.time = recording.times[0];
    this.playing = false;
  }

  get frame() {
    return this.recording.frameAt(this.time);
  }

  // Passes seconds; stops at the end.
  advance(seconds) {
    const last = this.recording.times[this.recording.frames - 1];
    this.time = Math.min(last, this.time + seconds);
    if (this.time >= last) this.playing = false;
  }

  play(on) {
    const {times, frames} = this.recording;
    if (on && this.time >= times[frames - 1]) [this.time] = times;
    this.playing = on && frames > 1;
  }

  // To a frame; to the next or the one before with `by`.
  to(frame, by = 0) {
    const {times, frames} = this.recording;
    this.time = times[Math.max(0, Math.min(frames - 1, frame + by))];
  }

  // {bodies, alpha}: what is to be drawn.
  look() {
    const {times} = this.recording;
    const k = this.frame;
    const alpha = k === 0 ? 1 : (this.time - times[k - 1]) / (times[k] - times[k - 1]);
    return {bodies: this.recording.bodiesOf(k), alpha};
  }
}
