// Starts the page: the module in its worker, then everything that shows it.
import moduleText from 'module:';
import {App} from './app.js';
import {acceptFiles} from './files.js';
import {listen} from './keys.js';
import {Module} from './module.js';
import {Simulation} from './simulation.js';

// Nobody looks, at the tab or at the frame within another page: the clock stands.
function watch(app) {
  document.addEventListener('visibilitychange', () => {
    app.seen.tab = !document.hidden;
    app.run();
  });
  new IntersectionObserver(entries => {
    app.seen.frame = entries[entries.length - 1].isIntersecting;
    app.run();
  }).observe(document.getElementById('stage'));
  // Within another page the wheel scrolls that page; with Ctrl it is the scene's.
  addEventListener('wheel', event => {
    if (app.setup.embed && !event.ctrlKey) event.stopPropagation();
  }, {capture: true, passive: true});
  addEventListener('hashchange', () => {
    embed();
    app.follow(location.hash);
  });
}

// Within another page there is a thin bar and nothing else: known before anything is made.
const embed = () => document.body.classList.toggle('embed', /[#&]embed=1(&|$)/.test(location.hash));

async function begin() {
  embed();
  if (typeof WebAssembly === 'undefined' || typeof Worker === 'undefined')
    throw new Error('this browser cannot run WebAssembly in a worker; use a newer one.');
  const bytes = Uint8Array.from(moduleText, character => character.charCodeAt(0));
  let app;
  const simulation = new Simulation({
    onFrame: frame => app?.drawing.onFrame(frame),
    onStopped: (slot, sentence) => (app ? app.onStopped(slot, sentence) : globalThis.cannotStart(sentence)),
  });
  Object.assign(globalThis.tumble, {simulation, Module, bytes});
  app = new App(await simulation.start(bytes.slice()), simulation);
  globalThis.tumble.app = app;
  listen(app);
  acceptFiles(app);
  await app.follow(location.hash);
  watch(app);
  document.getElementById('starting').hidden = true;
  document.getElementById('waiting').remove();
}

// For consoles, and for the test that drives the page.
globalThis.tumble = {frames: 0};
globalThis.tumble.ready = begin();
globalThis.tumble.ready.catch(({message}) => {
  globalThis.cannotStart(`The simulation cannot start: ${message}`);
});
