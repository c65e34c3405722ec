// What is set up, what runs, and whose hand does what to it.
import {LOOK} from './module.js';
import {aim} from './view.js';
import {decode, defaults, numberOf, request} from './link.js';
import {changes, make} from './settings.js';
import {Plots, Readout} from './plots.js';
import {Player} from './replay.js';
import {reach, readScene, suited} from './scene.js';
import {Stage} from './stage.js';
import {Controls} from './controls.js';
import {Drawing} from './drawing.js';
import {Share} from './share.js';

// What a simulation is opened by: a change of it starts from the beginning, one of SCENE moves the camera.
const SCENE = ['scene', 'sceneSettings', 'toml', 'seed'];
const RUN = [...SCENE, 'technique', 'techniqueSettings', 'versus', 'versusSettings', 'dt'];
const MOST_ALERTS = 3;

const named = (name, values) => [name, changes(values)].filter(Boolean).join(', ');

export class App {
  constructor(catalogue, simulation) {
    this.catalogue = catalogue;
    this.simulation = simulation;
    this.setup = defaults(catalogue);
    this.playing = false;  // what was asked for; it runs if somebody can see it
    this.seen = {tab: !document.hidden, frame: true};
    this.queue = Promise.resolve();
    this.turn = 0;  // of openings: a newer one makes those that wait needless
    this.busy = true;  // being opened: frames are kept, not drawn
    this.stage = new Stage({
      onThrow: ray => (this.taking ? this.take(ray.id) : this.throwAlong(ray)),
      onTake: id => this.take(id),
      onCamera: () => this.onCamera(),
    });
    this.drawing = new Drawing(this);
    this.plots = new Plots(document.getElementById('plots'), catalogue.numbers);
    this.readout = new Readout(document.getElementById('readout'));
    this.controls = new Controls(this);
    this.share = new Share(this);
  }

  // Takes over what a link says.
  async follow(hash) {
    const {setup, mistakes} = decode(hash, this.catalogue);
    if (mistakes.length)
      this.say(`Not all of the link is understood; what is left of it is shown. ${mistakes.join(' ')}`);
    this.setup = setup;
    this.playing = setup.play ?? !matchMedia('(prefers-reduced-motion: reduce)').matches;
    this.simulation.speed(setup.speed);
    await this.open(true);
  }

  // Says a sentence that can be taken off the page.
  say(sentence) {
    const place = document.getElementById('alerts');
    if ([...place.children].some(one => one.firstChild.textContent === sentence)) return;
    const off = make('button', {type: 'button', textContent: '×', title: 'Dismiss', 'aria-label': 'Dismiss'});
    const one = make('div', {className: 'alert', role: 'alert'}, make('span', {textContent: sentence}), off);
    off.onclick = () => one.remove();
    place.append(one);
    while (place.children.length > MOST_ALERTS) place.firstChild.remove();
  }

  // Does a task of the simulation; a refusal is said.
  async attempt(task) {
    try {
      return await task;
    } catch (error) {
      this.say(sentence(error));
      return undefined;
    }
  }

  // --- the set-up ---

  // Changes the set-up and starts it from the beginning.
  change(part) {
    const other = SCENE.some(key => key in part);
    Object.assign(this.setup, part, other ? {camera: ''} : {});
    return this.open(other);
  }

  // Changes what is shown, and goes on.
  look(part) {
    Object.assign(this.setup, part);
    this.want();
    this.controls.showSetup();
    this.share.showLink();
    this.drawing.schedule();
  }

  // Starts the set-up from the beginning; fit: the camera moves to where all can be seen.
  open(fit = false) {
    this.fit ||= fit;
    this.turn += 1;
    const {turn} = this;
    this.queue = this.queue.then(() => (turn === this.turn ? this.openNow() : undefined));
    return this.queue;
  }

  async openNow() {
    this.replay = undefined;
    this.busy = true;
    await this.simulation.play(false);
    try {
      await this.openSlots();
    } catch (error) {
      // What can be opened for sure: the last that was, or the defaults.
      const sure = this.opened ?? defaults(this.catalogue);
      for (const key of RUN) this.setup[key] = structuredClone(sure[key]);
      const instead = this.opened ? 'What was there starts again.' : 'Shown instead: pyramid.';
      this.say(`${sentence(error)} ${instead}`);
      await this.openSlots();
    }
    this.drawing.begin();
    this.opened = structuredClone(Object.fromEntries(RUN.map(key => [key, this.setup[key]])));
    this.scene = readScene(await this.simulation.scene(0));
    this.placed = false;
    this.showOpened();
    this.busy = false;
    this.drawing.schedule();
    await this.run();
  }

  async openSlots() {
    const {setup, simulation} = this;
    this.ignored = [];
    if (!setup.versus) await simulation.close(1);
    for (const slot of setup.versus ? [0, 1] : [0]) {
      const {ignored} = await simulation.open(slot, request(setup, slot), numberOf(setup.dt));
      this.ignored[slot] = ignored;
    }
  }

  get techniques() {
    return [this.setup.technique, this.setup.versus].filter(Boolean);
  }

  // What each half shows: `damped, passes=8`, with the scene where there is one technique only.
  labels() {
    const {setup} = this;
    const own = named(setup.technique, setup.techniqueSettings);
    if (setup.versus) return [own, named(setup.versus, setup.versusSettings)];
    return [`${setup.toml ? setup.toml.name : named(setup.scene, setup.sceneSettings)} · ${own}`];
  }

  showOpened() {
    this.stage.open(this.labels());
    this.plots.clear();
    this.readout.open(this.techniques);
    this.controls.showSetup();
    this.controls.showIgnored(this.ignored);
    this.share.showLink();
    document.getElementById('saved').hidden = true;  // it was about another run
    this.want();
  }

  // Moves the camera where a newly opened scene asks for it.
  placeCamera(bodies) {
    if (this.placed) return;
    this.placed = true;
    const fitted = this.fit;
    this.fit = false;
    this.stage.setScene(this.scene.ground, reach(bodies, this.scene), fitted);
    if (!fitted || !this.setup.camera) return;
    try {
      this.stage.camera = this.setup.camera;
    } catch (error) {
      this.say(sentence(error));
      this.setup.camera = '';
    }
  }

  // What the module has to find out for what is shown.
  want() {
    const {show, colour} = this.setup;
    let bits = LOOK[colour] ?? 0;
    if (show.some(what => what !== 'pivots')) bits |= LOOK.contacts;
    if (show.includes('pivots')) bits |= LOOK.pivots;
    this.simulation.want(bits);
    this.stage.explain(colour, show);
  }

  // What is shown, in the words of the view.
  options() {
    const {show, colour, force, dt} = this.setup;
    const [normals, forces, pivots] = ['normals', 'forces', 'pivots'].map(what => show.includes(what));
    const contacts = show.includes('contacts') || normals || forces;
    return {colour: colour === 'balanced' ? 'stable' : colour, contacts, normals, forces, pivots,
            forceScale: force, dt: numberOf(dt)};
  }

  // --- time ---

  // Lets time pass, or not, as things are.
  async run() {
    this.controls.showPlaying();
    const runs = this.playing && this.seen.tab && this.seen.frame;
    if (this.replay) this.replay.play(runs);
    else if (!this.busy) await this.simulation.play(runs);
    this.drawing.schedule();
  }

  play(on = !this.playing) {
    this.playing = on;
    return this.run();
  }

  async step(by = 1) {
    await this.play(false);
    if (this.replay) this.replay.to(this.replay.frame + by);
    else if (by > 0) await this.attempt(this.simulation.steps(by));
    this.drawing.schedule();
  }

  reset() {
    if (!this.replay) return this.open();
    this.replay.to(0);
    return this.drawing.schedule();
  }

  setSpeed(value) {
    this.setup.speed = value;
    this.simulation.speed(value);
    this.controls.showSetup();
    this.share.showLink();
  }

  // Plays a recording in place of a simulation.
  async show(recording, scene) {
    await this.queue;
    await this.simulation.play(false);
    this.setup.versus = undefined;
    this.scene = scene;
    this.placed = false;
    this.fit = true;
    this.replay = new Player(recording);
    this.stage.open([recording.file]);
    this.controls.showSetup();
    await this.play(true);
  }

  // --- hands ---

  // What is thrown: what was asked for, else what suits the scene.
  hand(asked = this.setup.throw) {
    return {...suited(this.scene ?? {boxes: []}), ...asked};
  }

  async throwAlong(ray) {
    if (this.replay) return this.say('This is a recording: close it to throw boxes.');
    if (!ray) return this.say('Without a picture there is nothing to aim at.');
    document.getElementById('hint').hidden = true;
    const {edge, mass, speed} = this.hand();
    const velocity = aim(ray, speed, this.scene.gravity);
    return this.attempt(this.simulation.throwBox({edge, mass, position: ray.origin, velocity}));
  }

  async take(id) {
    if (this.replay) return this.say('This is a recording: close it to take boxes away.');
    if (id === undefined) return this.say('There is no box to take away where you point.');
    return this.attempt(this.simulation.takeAway(id));
  }

  // --- what is heard ---

  onStopped(slot, what) {
    this.stage.stop(slot, `${this.techniques[slot]} has stopped: ${sentence({message: what})}`);
  }

  onCamera() {
    this.share.showLink();
    this.drawing.schedule();
  }

  // State hashes, now that time stands.
  async hashes() {
    if (this.busy || this.replay) return;
    const {turn} = this;
    const slots = this.techniques.map((_, slot) => slot);
    const found = await Promise.all(slots.map(slot => this.simulation.hash(slot).catch(() => '')));
    if (turn === this.turn && !this.drawing.last?.playing) this.readout.showHashes(found);
  }
}

// What an error says, as a sentence.
export function sentence({message}) {
  const text = message.replace(/^tumble: /, '');
  return /[.!?]$/.test(text) ? text : `${text}.`;
}
