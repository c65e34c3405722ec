// The keyboard: everything that the pointer does, and short cuts for the buttons.
import {SPEEDS, COLOURS} from './link.js';
import {make} from './settings.js';

const TURN = 0.08;  // [rad] for a press
const MOVE = 0.02;  // of the picture, for a press
const ZOOM = 1.1;

// Keys, what they do, and the task. Those with `view` count only while no control has the focus, since it may
// need them.
function bindings(app) {
  const {stage, controls} = app;
  const orbit = (dx, dy) => () => stage.each(view => view.orbit(dx * TURN, dy * TURN));
  const aim = (dx, dy) => () => stage.moveCrosshair(dx * MOVE, dy * MOVE);
  const click = id => () => document.getElementById(id).click();
  const pace = by => () => {
    const at = SPEEDS.findIndex(([, value]) => value <= app.setup.speed);
    app.setSpeed(SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, (at < 0 ? SPEEDS.length - 1 : at) + by))][1]);
  };
  const view = true;
  return [
    {keys: [' '], says: 'play or pause', task: () => app.play(), view},
    {keys: ['.'], says: 'one step', task: () => app.step()},
    {keys: [','], says: 'one frame back, in a recording', task: () => app.step(-1)},
    {keys: ['r'], says: 'reset', task: () => app.reset()},
    {keys: ['['], says: 'slower', task: pace(1)},
    {keys: [']'], says: 'faster', task: pace(-1)},
    {keys: ['t'], says: 'throw a box at the crosshair', task: () => app.throwAlong(stage.ray())},
    {keys: ['Enter'], task: () => app.throwAlong(stage.ray()), view,
     says: 'the same, while the picture has the focus'},
    {keys: ['x'], says: 'take away the box at the crosshair', task: () => app.take(stage.ray()?.id)},
    {keys: ['Shift+ArrowLeft'], task: aim(-1, 0), view},
    {keys: ['Shift+ArrowRight'], task: aim(1, 0), view},
    {keys: ['Shift+ArrowUp'], task: aim(0, -1), view},
    {keys: ['Shift+ArrowDown'], task: aim(0, 1), view, shown: 'Shift+arrows', says: 'move the crosshair'},
    {keys: ['ArrowLeft'], task: orbit(-1, 0), view},
    {keys: ['ArrowRight'], task: orbit(1, 0), view},
    {keys: ['ArrowUp'], task: orbit(0, -1), view},
    {keys: ['ArrowDown'], task: orbit(0, 1), view, shown: 'arrows', says: 'turn the view'},
    {keys: ['+', '='], says: 'nearer', task: () => stage.each(one => one.zoom(ZOOM))},
    {keys: ['-'], says: 'farther', task: () => stage.each(one => one.zoom(1 / ZOOM))},
    {keys: ['h'], says: 'fit the view, crosshair in the middle', task: () => stage.fitCamera()},
    {keys: ['c'], says: 'contact points', task: () => controls.toggleShow('contacts')},
    {keys: ['n'], says: 'normals', task: () => controls.toggleShow('normals')},
    {keys: ['f'], says: 'forces', task: () => controls.toggleShow('forces')},
    {keys: ['p'], says: 'pivots', task: () => controls.toggleShow('pivots')},
    ...COLOURS.map((colour, k) => ({keys: [String(k + 1)], task: () => app.look({colour})})),
    {keys: [], shown: `1 to ${COLOURS.length}`, says: 'colours, in the order of the panel'},
    {keys: ['v'], says: 'compare with a second technique, or not', task: () => controls.compare()},
    {keys: ['s'], says: 'save what was thrown', task: click('save')},
    {keys: ['m'], says: 'fold the panel', task: () => controls.fold()},
    {keys: ['?'], says: 'these keys', task: click('help-open')},
  ];
}

export function listen(app) {
  const all = bindings(app);
  const byKey = new Map(all.flatMap(one => one.keys.map(key => [key, one])));
  const name = ({keys, shown}) => shown ?? keys.map(key => (key === ' ' ? 'Space' : key)).join(' ');
  document.getElementById('keys').append(...all.filter(({says}) => says).map(
    one => make('p', {}, make('kbd', {textContent: name(one)}), ` ${one.says}`)));

  addEventListener('keydown', event => {
    const {key, target, shiftKey} = event;
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector('dialog[open]')) return;
    // Whoever types or chooses means the field, not the page.
    if (target.closest?.('textarea, select, input:not([type=checkbox], [type=radio], [type=range])')) return;
    const free = target === document.body || target.closest?.('#stage');
    const found = byKey.get(shiftKey && key.startsWith('Arrow') ? `Shift+${key}` : key);
    if (!found || (found.view && !free)) return;
    event.preventDefault();
    if (!event.repeat || found.view || '+-=.,'.includes(key)) found.task();
  });
}
