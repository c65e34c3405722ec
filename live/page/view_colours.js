// Colours: of Okabe and Ito, which people with any colour vision tell apart; what they mean; light and dark.
import {Color} from 'three';
import {BODY, KIND} from './module.js';

const OKABE_ITO = {
  black: '#000000', orange: '#e69f00', sky: '#56b4e9', green: '#009e73', yellow: '#f0e442', blue: '#0072b2',
  vermilion: '#d55e00', purple: '#cc79a7',
};

// Modes of colouring and what a person reads.
export const COLOURS = {
  boxes: 'Boxes', stable: 'Geometrically stable', islands: 'Islands', asleep: 'Asleep', overlap: 'Overlap',
};

// The overlap, as a share of the box's shortest edge, that has the last colour of the scale.
export const WORST_OVERLAP = 0.02;

const THEMES = {
  light: {
    background: '#f3f1ec', ground: '#e6e3dc', grid: '#cbc7bd', ink: '#16191d', halo: '#ffffff', shadow: 0.42,
    fixed: '#9aa0a6', stable: '#39464f', unstable: '#f1e6cd', resting: '#c9c7c2', neutral: '#dcdedd',
    force: '#16191d', normal: '#8e3f6d', impulse: '#e69f00', pivot: '#0072b2',
  },
  dark: {
    background: '#14171b', ground: '#1e2329', grid: '#343b44', ink: '#f4f2ec', halo: '#0b0d0f', shadow: 0.75,
    fixed: '#6b7279', stable: '#31414f', unstable: '#e5dac2', resting: '#444a50', neutral: '#c3c7c8',
    force: '#f4f2ec', normal: '#e79ac4', impulse: '#ffc23d', pivot: '#56b4e9',
  },
};

export const theme = dark => (dark ? THEMES.dark : THEMES.light);

const mixed = (one, other, share) => `#${new Color(one).lerp(new Color(other), share).getHexString()}`;
// Softer than the originals, so that what is drawn over the boxes stands out.
const BOXES = ['sky', 'green', 'yellow', 'blue', 'purple'].map(name => mixed(OKABE_ITO[name], '#fff', 0.22));
const BRIGHT = [...BOXES, OKABE_ITO.orange];
const ISLANDS = [...BRIGHT, ...BRIGHT.map(colour => mixed(colour, '#000000', 0.5))];
const THROWN = OKABE_ITO.vermilion;

// What the colours mean: [{colour, text}]; of 'overlap' the ends of a scale.
export function legend(mode, dark = false) {
  const t = theme(dark);
  const fixed = {colour: t.fixed, text: 'fixed'};
  const thrown = {colour: THROWN, text: 'thrown'};
  switch (mode) {
    case 'stable':
      return [{colour: t.stable, text: 'geometrically stable'}, {colour: t.unstable, text: 'not'}, fixed];
    case 'islands':
      return [{colour: ISLANDS[0], text: 'one colour for each island of boxes that touch'}, fixed];
    case 'asleep':
      return [{colour: BOXES[0], text: 'awake'}, {colour: t.resting, text: 'asleep'}, thrown, fixed];
    case 'overlap':
      return [{colour: t.neutral, text: 'no overlap'},
              {colour: THROWN, text: `${100 * WORST_OVERLAP} % of the shortest edge or more`}, fixed];
    default:
      return [thrown, fixed];
  }
}

// What the signs of the overlays mean.
export function overlayLegend(dark = false) {
  const t = theme(dark);
  return [
    {sign: 'dot', colour: t.ink, text: 'contact point that sticks'},
    {sign: 'ring', colour: t.ink, text: 'contact point that slips'},
    {sign: 'hollow', colour: t.ink, text: 'contact point that is open'},
    {sign: 'arrow', colour: t.force, text: 'force on the upper box'},
    {sign: 'line', colour: t.normal, text: 'contact normal'},
    {sign: 'flash', colour: t.impulse, text: 'collision and its impulse'},
    {sign: 'line', colour: t.pivot, text: 'pivot, and the line to its body\'s centre'},
  ];
}

// Spreads ids so that neighbours in a row differ, and mostly those above one another too.
const placeOf = (id, count) => Math.floor(id * 0.618034 % 1 * count);

// Gives each body the colour that a mode gives it.
export class Painter {
  constructor() {
    this.boxes = BOXES.map(hex => new Color(hex));
    this.islands = ISLANDS.map(hex => new Color(hex));
    this.thrown = new Color(THROWN);
    this.mixed = new Color();
    this.eldest = new Map();  // smallest id of an island, by the island's number
    this.setDark(false);
  }

  setDark(dark) {
    const t = theme(dark);
    this.fixed = new Color(t.fixed);
    this.stable = new Color(t.stable);
    this.unstable = new Color(t.unstable);
    this.resting = new Color(t.resting);
    this.neutral = new Color(t.neutral);
  }

  // Writes red, green and blue of each body into `out`.
  paint(mode, bodies, out) {
    if (mode === 'islands') this.findEldest(bodies);
    for (let at = 0, to = 0; at < bodies.length; at += BODY.size, to += 3)
      this.colourOf(mode, bodies, at).toArray(out, to);
  }

  // Islands are numbered anew in each step; the smallest id in one stays, and gives it its colour.
  findEldest(bodies) {
    this.eldest.clear();
    for (let at = 0; at < bodies.length; at += BODY.size) {
      const island = bodies[at + BODY.island];
      const id = bodies[at + BODY.id];
      if (!(this.eldest.get(island) <= id)) this.eldest.set(island, id);
    }
  }

  colourOf(mode, bodies, at) {
    const kind = bodies[at + BODY.kind];
    const id = bodies[at + BODY.id];
    if (kind & KIND.fixed) return this.fixed;
    if (mode === 'stable') return kind & KIND.stable ? this.stable : this.unstable;
    if (mode === 'overlap') {
      const edges = at + BODY.edges;
      const edge = Math.min(bodies[edges], bodies[edges + 1], bodies[edges + 2]);
      const share = Math.min(1, bodies[at + BODY.overlap] / edge / WORST_OVERLAP);
      return this.mixed.lerpColors(this.neutral, this.thrown, share);
    }
    if (mode === 'islands' && bodies[at + BODY.island] >= 0)
      return this.islands[this.eldest.get(bodies[at + BODY.island]) % this.islands.length];
    const own = kind & KIND.thrown ? this.thrown : this.boxes[placeOf(id, this.boxes.length)];
    return mode === 'asleep' && kind & KIND.asleep ? this.mixed.lerpColors(own, this.resting, 0.82) : own;
  }
}
