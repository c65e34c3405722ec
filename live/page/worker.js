// The simulation's own thread: it keeps time, so that drawing never holds it up, nor it the drawing.
// simulation.js speaks to it. All open slots step together, so that one hand throws at both.
import {Module} from './module.js';

const PATIENCE = 12;  // [ms] of stepping before messages are looked at again
const SLOTS = 2;

let module;
const open = Array(SLOTS).fill(false);
const stopped = Array(SLOTS).fill(false);  // a step failed: it stays as it is
const cost = Array(SLOTS).fill(0);  // [ms] of a step, smoothed
let dt = 1 / 60;  // [s]
let speed = 1;  // simulated seconds in a second
let playing = false;
let wanted = 0;
let due = 0;  // [s] to be simulated
let last = 0;  // [ms] when time was looked at
let reached = 1;  // share of the wanted speed, smoothed
let seen = true;  // the page has taken the last frame
let changed = false;  // something has to be shown
let timer = 0;

function stop(slot, sentence) {
  stopped[slot] = true;
  postMessage({stopped: slot, sentence});
}

function step() {
  for (let slot = 0; slot < SLOTS; ++slot) {
    if (!open[slot] || stopped[slot]) continue;
    const began = performance.now();
    try {
      module.step(slot, 1, dt);
    } catch (error) {
      stop(slot, error.message);
    }
    cost[slot] += 0.05 * (performance.now() - began - cost[slot]);
  }
  changed = true;
}

const running = () => playing && open.some((is, slot) => is && !stopped[slot]);

function tick() {
  timer = 0;
  const now = performance.now();
  if (running()) {
    const passed = Math.max(0, now - last) * 1e-3;
    due += passed * speed;
    let done = 0;
    while (due >= dt && performance.now() - now < PATIENCE && running()) {
      step();
      due -= dt;
      done += dt;
    }
    // What cannot be caught up with is let go: slower than wanted, instead of later and later.
    if (due > 2 * dt) due = dt;
    if (passed > 0) reached += 0.05 * (Math.min(1, (done + Math.min(due, dt)) / (passed * speed)) - reached);
  }
  last = now;
  show();
  if (running()) timer = setTimeout(tick, 4);
}

function wake() {
  if (timer === 0) timer = setTimeout(tick, 0);
}

function show() {
  if (!seen || !module || !(changed || running())) return;
  const slots = [];
  const moved = [];
  for (let slot = 0; slot < SLOTS; ++slot) {
    if (!open[slot]) continue;
    // Between two steps only the share of the way changes.
    const numbers = changed ? module.look(slot, wanted) : {};
    if (changed) moved.push(numbers.bodies.buffer, numbers.contacts.buffer, numbers.numbers.buffer);
    slots[slot] = {...numbers, cost: cost[slot], stopped: stopped[slot]};
  }
  postMessage({frame: {slots, fresh: changed, alpha: playing ? Math.min(1, due / dt) : 1, playing, reached,
                       memory: module.memory}}, moved);
  seen = false;
  changed = false;
}

const tasks = {
  async start({bytes}) {
    module = await Module.from(bytes);
    return module.catalogue();
  },
  open({slot, request, step: length}) {
    const ignored = module.open(slot, request);
    open[slot] = true;
    stopped[slot] = false;
    cost[slot] = 0;
    dt = length;
    due = 0;
    changed = true;
    return {ignored};
  },
  close({slot}) {
    module.close(slot);
    open[slot] = false;
    changed = true;
  },
  play({on}) {
    playing = on;
    last = performance.now();
    due = 0;
    changed = true;
  },
  speed({value}) {
    speed = value;
  },
  steps({count}) {
    for (let k = 0; k < count; ++k) step();
  },
  want({bits}) {
    wanted = bits;
    changed = true;
  },
  throwBox({box}) {
    open.forEach((is, slot) => is && !stopped[slot] && module.throwBox(slot, box));
    changed = true;
  },
  takeAway({id}) {
    open.forEach((is, slot) => is && !stopped[slot] && module.takeAway(slot, id));
    changed = true;
  },
  scene: ({slot}) => module.scene(slot),
  hash: ({slot}) => module.hash(slot),
};

onmessage = async ({data}) => {
  if (data.seen) {
    seen = true;
    return show();
  }
  try {
    postMessage({answer: data.number, value: await tasks[data.task](data)});
  } catch (error) {
    postMessage({answer: data.number, refusal: error.message});
  }
  wake();
};
