// Frames of the simulation, or of a recording, brought onto the page.
import {BODY} from './module.js';

export class Drawing {
  // stage, plots, readout, controls: where things are shown.
  constructor(app) {
    this.app = app;
    this.begin();
    this.still = [];  // who waits for a frame in which time stands
    this.ripe = [];  // those for whom it has come, and is to be drawn
  }

  // Frames from now on are of a new simulation.
  begin() {
    this.last = undefined;  // newest frame with bodies
    if (this.owed) this.app.simulation.shown();
    this.owed = false;  // a frame has come of which the worker does not know yet that it is drawn
  }

  onFrame(frame) {
    const {fresh, alpha, playing, reached} = frame;
    if (fresh) this.last = frame;
    else if (this.last) Object.assign(this.last, {alpha, playing, reached});
    this.owed = true;
    this.schedule();
    if (!fresh || playing) return;
    this.ripe.push(...this.still.splice(0));
    this.app.hashes();
  }

  // Draws when the screen is ready for it.
  schedule() {
    if (this.waits) return;
    this.waits = true;
    requestAnimationFrame(now => {
      this.waits = false;
      if (this.app.replay) this.drawReplay(now);
      else if (this.last && !this.app.busy) this.draw();
      if (!this.owed) return;
      this.owed = false;
      globalThis.tumble.frames += 1;
      this.app.simulation.shown();
    });
  }

  // The next frame to come in which time stands, when it is drawn.
  stillFrame() {
    return new Promise(done => { this.still.push(done); });
  }

  draw() {
    const {app, last} = this;
    const {stage, plots} = app;
    app.placeCamera(last.slots[0].bodies);
    const options = app.options();
    last.slots.forEach((seen, slot) => {
      const {time} = plots.named(seen.numbers);
      stage.show(slot, seen.bodies, seen.contacts, last.alpha, {...options, time, playing: last.playing});
      plots.add(slot, seen.numbers, seen.cost);
    });
    plots.draw(last.slots.map((_, slot) => slot), !last.playing);
    const counted = ({numbers, bodies}) => ({...plots.named(numbers), boxes: bodies.length / BODY.size});
    app.readout.show(last.slots.map(counted), !last.playing);
    app.controls.showFrame(last, plots.named(last.slots[0].numbers));
    this.ripe.splice(0).forEach(done => done(last));
  }

  drawReplay(now) {
    const {app} = this;
    const {replay} = app;
    if (replay.playing) {
      // A pause of the page is not one of the recording.
      replay.advance(Math.min(0.1, (now - (this.clock ?? now)) * 1e-3) * app.setup.speed);
      if (!replay.playing) app.play(false);
      else this.schedule();
    }
    this.clock = replay.playing ? now : undefined;
    const {bodies, alpha} = replay.look();
    app.placeCamera(replay.recording.bodiesOf(replay.frame));
    const {playing, time} = replay;
    app.stage.show(0, bodies, new Float64Array(0), alpha, {colour: 'boxes', playing, time});
    app.controls.showReplay(replay);
  }
}
