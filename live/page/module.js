// The WebAssembly module as an object: texts and numbers go in and out, statuses become errors.
// live/module.cpp says what each function does.

// Bits of what to find out for a look, as live/session.hpp has them.
export const LOOK = {contacts: 1, stable: 2, islands: 4, overlap: 8, pivots: 16, balanced: 32};
// Bits of what a body is.
export const KIND = {fixed: 1, asleep: 2, stable: 4, thrown: 8};
// Numbers of one body and of one contact, and where each begins in them.
export const BODY = {size: 24, id: 0, now: 1, edges: 8, before: 11, kind: 18, island: 19, overlap: 20, pivot: 21};
export const CONTACT = {size: 14, time: 0, first: 1, second: 2, point: 3, normal: 6, push: 9, impulse: 12, state: 13};

// A sentence from the library: what is wrong, and what would be right.
export class Refusal extends Error {}

// What the module asks the page for: numbers as text and text as numbers (live/numbers_by_page.cpp).
class NumberTexts {
  memory;  // the module's

  number = (at, size, taken) => {
    const text = String.fromCharCode(...new Uint8Array(this.memory.buffer, at, size));
    const [found] = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?/i.exec(text) ?? [''];
    new DataView(this.memory.buffer).setInt32(taken, found.length, true);
    return Number(found);
  };

  text = (value, digits, at) => {
    const rounded = digits ? Number(value.toPrecision(digits)) : value;
    const text = Object.is(rounded, -0) ? '-0' : String(rounded).replace('NaN', 'nan').replace('Infinity', 'inf');
    return new TextEncoder().encodeInto(text, new Uint8Array(this.memory.buffer, at)).written;
  };
}

export class Module {
  // Makes a module of its bytes; each has a memory of its own.
  static async from(bytes) {
    const nothing = () => 0;
    const page = new NumberTexts();
    const imports = {
      page,
      env: {emscripten_notify_memory_growth: nothing},
      wasi_snapshot_preview1: new Proxy({}, {get: () => nothing}),  // what C's start-up would ask an operating system
    };
    const compiled = await WebAssembly.compile(bytes);
    for (const {module, name} of WebAssembly.Module.imports(compiled)) {
      imports[module] ??= {};
      imports[module][name] ??= nothing;
    }
    const {exports} = await WebAssembly.instantiate(compiled, imports);
    page.memory = exports.memory;
    exports._initialize();
    return new Module(exports);
  }

  constructor(exports) {
    this.exports = exports;
  }

  // Memory in use [bytes].
  get memory() {
    return this.exports.memory.buffer.byteLength;
  }

  write(text) {
    const bytes = new TextEncoder().encode(text);
    const at = this.exports.tumble_input(bytes.length);
    if (at === 0) throw new Refusal(this.answer());
    new Uint8Array(this.exports.memory.buffer, at, bytes.length).set(bytes);
  }

  answer() {
    const {memory, tumble_answer, tumble_answer_size} = this.exports;
    return new TextDecoder().decode(new Uint8Array(memory.buffer, tumble_answer(), tumble_answer_size()));
  }

  // Calls a function that returns a status; its answer is the text, or the sentence of an error.
  call(name, ...values) {
    let status;
    try {
      status = this.exports[name](...values);
    } catch (error) {
      throw new Refusal(`The simulation has broken off (${error.message}): reload the page.`);
    }
    if (status !== 0) throw new Refusal(this.answer());
  }

  catalogue() {
    this.call('tumble_catalogue');
    return JSON.parse(this.answer());
  }

  open(slot, request) {
    this.write(request);
    this.call('tumble_open', slot);
    return this.answer();
  }

  close(slot) {
    this.exports.tumble_close(slot);
  }

  step(slot, steps, dt) {
    this.call('tumble_step', slot, steps, dt);
  }

  throwBox(slot, {edge, mass, position, velocity}) {
    this.call('tumble_throw', slot, edge, mass, ...position, ...velocity);
  }

  takeAway(slot, id) {
    this.call('tumble_take_away', slot, id);
  }

  // Copies of the numbers: the memory may move with the next call.
  look(slot, wanted) {
    this.call('tumble_look', slot, wanted);
    const [bodies, contacts, numbers] = [0, 1, 2].map(what => {
      const at = this.exports.tumble_seen(slot, what);
      return new Float64Array(this.exports.memory.buffer, at, this.exports.tumble_seen_count(slot, what)).slice();
    });
    return {bodies, contacts, numbers};
  }

  hash(slot) {
    this.call('tumble_hash', slot);
    return this.answer();
  }

  scene(slot) {
    this.call('tumble_scene', slot);
    return this.answer();
  }
}
