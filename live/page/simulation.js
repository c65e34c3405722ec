// The page's end of the simulation: asks the worker, and is told about frames.
import workerSource from 'text:./worker.js';
import {Refusal} from './module.js';

export class Simulation {
  // onFrame(frame): the newest state, when there is one; call shown() when it is drawn.
  // onStopped(slot, sentence): a simulation cannot go on.
  constructor({onFrame, onStopped}) {
    const address = URL.createObjectURL(new Blob([workerSource], {type: 'text/javascript'}));
    this.worker = new Worker(address);
    this.questions = new Map();
    this.number = 0;
    this.worker.onmessage = ({data}) => {
      if (data.frame) return onFrame(data.frame);
      if (data.stopped !== undefined) return onStopped(data.stopped, data.sentence);
      const {done, refuse} = this.questions.get(data.answer);
      this.questions.delete(data.answer);
      if (data.refusal !== undefined) refuse(new Refusal(data.refusal));
      else done(data.value);
    };
    this.worker.onerror = ({message}) => onStopped(0, `The simulation has broken off (${message}): reload the page.`);
  }

  ask(task, data = {}, moved = []) {
    return new Promise((done, refuse) => {
      this.number += 1;
      this.questions.set(this.number, {done, refuse});
      this.worker.postMessage({number: this.number, task, ...data}, moved);
    });
  }

  // The frame is drawn: the next one may come. Whoever draws slowly gets fewer, and holds nobody up.
  shown() {
    this.worker.postMessage({seen: true});
  }

  start(bytes) {  // what there is to choose from
    return this.ask('start', {bytes}, [bytes.buffer]);
  }
  open(slot, request, step) {  // step [s]; {ignored}: what the technique leaves out
    return this.ask('open', {slot, request, step});
  }
  close(slot) {
    return this.ask('close', {slot});
  }
  play(on) {
    return this.ask('play', {on});
  }
  speed(value) {  // simulated seconds in a second
    return this.ask('speed', {value});
  }
  steps(count) {
    return this.ask('steps', {count});
  }
  want(bits) {  // of LOOK
    return this.ask('want', {bits});
  }
  throwBox(box) {  // {edge, mass, position, velocity} into all open slots
    return this.ask('throwBox', {box});
  }
  takeAway(id) {
    return this.ask('takeAway', {id});
  }
  scene(slot) {  // as a scene file
    return this.ask('scene', {slot});
  }
  hash(slot) {
    return this.ask('hash', {slot});
  }
}
