// The part of the page that is looked at: one view or two side by side, their labels, and the crosshair of
// whoever throws with the keyboard.
import {View, overlayLegend, legend} from './view.js';
import {make} from './settings.js';

const SIGNS = {dot: '●', ring: '◎', hollow: '○', flash: '✸', arrow: '→', line: '—'};
// Which of the overlays' legend belong to what is shown.
const SHOWN_SIGNS = {
  contacts: ['dot', 'ring', 'hollow', 'flash'], normals: ['contact normal'], forces: ['arrow'],
  pivots: ['pivot'],
};

export class Stage {
  // hand: {onThrow(ray), onTake(id), onCamera()}
  constructor(hand) {
    this.hand = hand;
    this.crosshair = [0.5, 0.5];  // shares of a half's width and height
    this.count = 1;
    this.halves = [0, 1].map(slot => {
      const root = document.getElementById(`half${slot}`);
      const find = name => root.querySelector(name);
      return {root, canvas: find('canvas'), label: find('.label'), failed: find('.failed'),
              aim: find('.crosshair')};
    });
    this.makeView(0);
    this.explained = ['boxes', []];
    const scheme = matchMedia('(prefers-color-scheme: dark)');  // the views follow it by themselves
    scheme.addEventListener('change', () => this.explain(...this.explained));
  }

  // A browser without WebGL gets a sentence in place of the picture; everything else goes on.
  makeView(slot) {
    const half = this.halves[slot];
    try {
      half.view = new View(half.canvas, {
        ...this.hand,
        onLost: sentence => this.blind(slot, sentence),
        onRestored: () => this.blind(slot, ''),
      });
      if (slot > 0) this.halves[0].view.linkCamera(half.view);
      // In another page a finger that moves up or down scrolls that page.
      if (document.body.classList.contains('embed')) half.canvas.style.touchAction = 'pan-y';
    } catch (error) {
      half.view = undefined;
      this.blind(slot, error.message);
    }
  }

  // Why there is no picture; '': there is one.
  blind(slot, sentence) {
    const half = this.halves[slot];
    half.blind = sentence;
    half.root.classList.toggle('blind', sentence !== '');
    this.tell(slot);
  }

  // What a simulation says that cannot go on; '': it goes on.
  stop(slot, sentence) {
    this.halves[slot].stopped = sentence;
    this.tell(slot);
  }

  tell(slot) {
    const {failed, stopped, blind} = this.halves[slot];
    failed.textContent = [stopped, blind].filter(Boolean).join(' ');
    failed.hidden = failed.textContent === '';
  }

  // Shows as many halves, with a label each.
  open(labels) {
    this.count = labels.length;
    const second = this.halves[1];
    second.root.hidden = this.count < 2;
    document.getElementById('stage').classList.toggle('two', this.count > 1);
    if (this.count > 1 && !second.view && !second.blind) this.makeView(1);
    labels.forEach((text, slot) => {
      this.stop(slot, '');
      this.halves[slot].label.textContent = text;
      this.halves[slot].canvas.setAttribute('aria-label',
        `${text}. Click or Enter throws a box, arrows turn the view, Shift and arrows move the crosshair.`);
    });
    if (this.count < 2) this.stop(1, '');
  }

  get views() {
    return this.halves.slice(0, this.count).map(({view}) => view).filter(Boolean);
  }

  // bodies: what the scene reaches over; moves: whether the camera goes where all of it can be seen.
  setScene(ground, bodies, moves) {
    const before = this.camera;
    for (const view of this.views)
      view.setScene({ground, fit: moves || view !== this.views[0] ? bodies : undefined});
    if (!moves && before) this.camera = before;  // a second view has moved the camera of both
  }

  show(slot, bodies, contacts, alpha, options) {
    if (!this.halves[slot].blind) this.halves[slot].view?.show(bodies, contacts, alpha, options);
  }

  set thrownEdge(edge) {
    this.views.forEach(view => { view.thrownEdge = edge; });
  }

  each(task) {
    if (this.views.length) task(this.views[0]);  // cameras are linked
  }

  // Moves the crosshair by shares of the picture, and shows it.
  moveCrosshair(dx, dy) {
    const within = share => Math.max(0.02, Math.min(0.98, share));
    this.crosshair = [within(this.crosshair[0] + dx), within(this.crosshair[1] + dy)];
    this.showCrosshair(true);
  }

  showCrosshair(on) {
    for (const {aim} of this.halves) {
      aim.hidden = !on;
      aim.style.left = `${100 * this.crosshair[0]}%`;
      aim.style.top = `${100 * this.crosshair[1]}%`;
    }
  }

  // All in sight, and the crosshair in the middle.
  fitCamera() {
    this.each(view => view.resetCamera());
    this.crosshair = [0.5, 0.5];
    this.showCrosshair(false);
    this.hand.onCamera();
  }

  // Lengths of the arrows as they are drawn, in the first half.
  get scales() {
    return this.views[0]?.scales;
  }

  // What the crosshair points at, in the half that has the focus; undefined without a picture.
  ray() {
    const half = this.halves.find(({canvas}) => canvas === document.activeElement) ?? this.halves[0];
    const {clientWidth, clientHeight} = half.canvas;
    return half.view?.rayAt(this.crosshair[0] * clientWidth, this.crosshair[1] * clientHeight);
  }

  get camera() {
    return this.views[0]?.cameraText() ?? '';
  }

  set camera(text) {
    this.each(view => view.setCameraText(text));
  }

  // What colours and signs mean.
  explain(colour, shows) {
    this.explained = [colour, shows];
    const list = document.getElementById('legend');
    const dark = this.views[0]?.dark ?? false;
    const colours = colour === 'boxes' ? [] : legend(colour === 'balanced' ? 'stable' : colour, dark);
    const wanted = shows.flatMap(show => SHOWN_SIGNS[show]);
    const signs = overlayLegend(dark).filter(
      ({sign, text}) => wanted.some(what => what === sign || text.startsWith(what)));
    list.replaceChildren(...[...colours, ...signs].map(({colour: ink, sign, text}) => {
      const className = sign ? 'sign' : 'swatch';
      const mark = make('span', {className, 'aria-hidden': 'true'}, SIGNS[sign] ?? '');
      mark.style[sign ? 'color' : 'background'] = ink;
      return make('li', {}, mark, text);
    }));
    list.hidden = this.views.length === 0 || list.children.length === 0;
  }
}
