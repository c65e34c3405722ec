// Numbers of the running simulations, as text and as small curves over time.
import {make} from './settings.js';

const KEPT = 600;  // samples of each curve: what a plot is wide, and no more however long it runs
const HEIGHT = 64;  // [CSS px]

const PREFIXES = [
  [1e9, 'G'], [1e6, 'M'], [1e3, 'k'], [1, ''], [1e-3, 'm'], [1e-6, 'µ'], [1e-9, 'n'], [1e-12, 'p'],
];

// Three digits and a prefix: 2.73 nm. A true minus, since a hyphen is hard to see.
export function withUnit(value, unit) {
  if (!Number.isFinite(value)) return 'not finite';
  const size = Math.abs(value);
  const [scale, prefix] = PREFIXES.find(([least]) => size >= least) ?? [1, ''];
  const text = size < 1e-12 ? '0' : (value / scale).toPrecision(3);
  return `${text.includes('e') ? String(Number(text)) : text} ${prefix}${unit}`.replace('-', '−');
}

// floor: what the height of the plot shows at least, so that noise does not look like something.
const CURVES = [
  {title: 'energy, kinetic + potential', unit: 'J', floor: 1e-3, of: seen => seen.kinetic + seen.potential},
  {title: 'energy error', unit: 'J', floor: 1e-3, zero: true, of: seen => seen.energy_error},
  {title: 'deepest overlap', unit: 'm', floor: 1e-5, zero: true, of: seen => seen.overlap},
  {title: 'chatter amplitude', unit: 'm', floor: 1e-5, zero: true, of: seen => seen.chatter},
  {title: 'time for a step', unit: 's', floor: 1e-3, zero: true, of: (seen, cost) => cost * 1e-3},
];

// Samples of one simulation, the newest over the oldest.
class Ring {
  constructor() {
    this.samples = new Float64Array(KEPT * (1 + CURVES.length));  // time, then a number for each curve
    this.count = 0;  // ever added
  }

  add(time, values) {
    const at = (this.count % KEPT) * (1 + CURVES.length);
    this.samples[at] = time;
    values.forEach((value, k) => { this.samples[at + 1 + k] = value; });
    this.count += 1;
  }

  // Calls task(time, value) from the oldest to the newest.
  each(curve, task) {
    for (let k = Math.max(0, this.count - KEPT); k < this.count; ++k) {
      const at = (k % KEPT) * (1 + CURVES.length);
      task(this.samples[at], this.samples[at + 1 + curve]);
    }
  }
}

export class Plots {
  constructor(place, names) {
    this.names = names;
    this.rings = [new Ring(), new Ring()];
    this.last = [-1, -1];  // step of the newest sample
    this.drawn = 0;  // [ms] when
    this.parts = CURVES.map(({title}) => {
      const values = [0, 1].map(slot => make('span', {className: `slot${slot}`}));
      const canvas = make('canvas', {'aria-hidden': 'true', height: HEIGHT});
      const head = make('p', {}, make('span', {textContent: title}),
        make('span', {className: 'values'}, ...values));
      place.append(make('div', {className: 'plot'}, head, canvas));
      return {canvas, values};
    });
    this.place = place;
  }

  clear() {
    this.rings = [new Ring(), new Ring()];
    this.last = [-1, -1];
    this.drawn = 0;
  }

  // Numbers of a look by name.
  named(numbers) {
    return Object.fromEntries(this.names.map((name, k) => [name, numbers[k]]));
  }

  add(slot, numbers, cost) {
    const seen = this.named(numbers);
    if (seen.steps === this.last[slot]) return;
    this.last[slot] = seen.steps;
    this.rings[slot].add(seen.time, CURVES.map(({of}) => of(seen, cost)));
  }

  // Draws now and then: nobody reads faster than ten times in a second.
  draw(slots, now = false) {
    if (this.place.offsetParent === null || (!now && performance.now() - this.drawn < 100)) return;
    this.drawn = performance.now();
    const style = getComputedStyle(this.place);
    const inks = ['--slot0', '--slot1', '--faint'].map(name => style.getPropertyValue(name));
    this.parts.forEach((part, curve) => this.drawPart(part, curve, slots, inks));
  }

  drawPart({canvas, values}, curve, slots, inks) {
    const {unit, floor, zero} = CURVES[curve];
    const wide = canvas.clientWidth;
    const density = window.devicePixelRatio || 1;
    if (canvas.width !== Math.round(wide * density)) canvas.width = Math.round(wide * density);
    if (canvas.height !== Math.round(HEIGHT * density)) canvas.height = Math.round(HEIGHT * density);
    let [from, to, low, high] = [Infinity, -Infinity, zero ? 0 : Infinity, zero ? 0 : -Infinity];
    const newest = [];
    slots.forEach(slot => this.rings[slot].each(curve, (time, value) => {
      newest[slot] = value;
      if (!Number.isFinite(value)) return;
      [from, to] = [Math.min(from, time), Math.max(to, time)];
      [low, high] = [Math.min(low, value), Math.max(high, value)];
    }));
    values.forEach((element, slot) => {
      element.textContent = newest[slot] === undefined ? '' : withUnit(newest[slot], unit);
    });
    const pen = canvas.getContext('2d');
    pen.setTransform(density, 0, 0, density, 0, 0);
    pen.clearRect(0, 0, wide, HEIGHT);
    if (!(to >= from)) return;
    const room = Math.max(floor - (high - low), 0);
    low -= zero && low >= 0 ? 0 : room / 2;
    high += zero && low >= 0 ? room : room / 2;
    const x = time => 1 + (wide - 2) * (to > from ? (time - from) / (to - from) : 0.5);
    const y = value => 4 + (HEIGHT - 8) * (high - value) / (high - low);
    if (zero) this.line(pen, inks[2], [], [[0, y(0)], [wide, y(0)]]);
    slots.forEach(slot => {
      const points = [];
      this.rings[slot].each(curve, (time, value) => {
        if (Number.isFinite(value)) points.push([x(time), y(value)]);
      });
      this.line(pen, inks[slot], slot === 1 ? [5, 3] : [], points);
    });
    pen.fillStyle = getComputedStyle(canvas).color;
    pen.font = '10px system-ui, sans-serif';
    pen.fillText(withUnit(high, unit), 3, 12);
  }

  line(pen, ink, dashes, points) {
    pen.beginPath();
    pen.setLineDash(dashes);
    pen.lineWidth = 1.5;
    pen.strokeStyle = ink;
    points.forEach(([x, y], k) => (k === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
    pen.stroke();
  }
}

const count = value => value.toLocaleString('en', {maximumFractionDigits: 0});
const ROWS = [
  ['boxes', seen => count(seen.boxes)],
  ['asleep', seen => count(seen.asleep)],
  ['fastest', seen => withUnit(seen.fastest, 'm/s')],
  ['contact points', seen => count(seen.contacts)],
  ['collisions in the step', seen => count(seen.events)],
  ['iterations', seen => count(seen.iterations)],
  ['taken back', seen => count(seen.rewinds)],
];

// The numbers of this moment as a table, with a column for each simulation.
export class Readout {
  constructor(table) {
    this.table = table;
    this.drawn = 0;
  }

  open(names) {
    const row = (title, cells, tag) => make('tr', {}, make('th', {scope: 'row', textContent: title}),
      ...cells.map((text, slot) => make(tag, {textContent: text, className: `slot${slot}`})));
    this.rows = ROWS.map(([title]) => row(title, names.map(() => ''), 'td'));
    this.hashes = row('state hash', names.map(() => ''), 'td');
    const head = names.length > 1 ? [row('', names, 'th')] : [];
    this.table.replaceChildren(...head, this.hashes, ...this.rows);
  }

  show(slots, now) {
    if (!now && performance.now() - this.drawn < 100) return;
    this.drawn = performance.now();
    this.rows.forEach((row, k) => slots.forEach((seen, slot) => {
      row.cells[slot + 1].textContent = ROWS[k][1](seen);
    }));
    if (!now) this.showHashes(slots.map(() => 'when paused'));
  }

  showHashes(found) {
    found.forEach((hash, slot) => { this.hashes.cells[slot + 1].textContent = hash; });
  }
}
