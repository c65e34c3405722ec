// What leaves the page: a link to the set-up, and the scene with what was thrown.
import {encode, numberOf} from './link.js';
import {make} from './settings.js';

const find = id => document.getElementById(id);
const FILE = 'thrown.toml';

// A word for a shell.
const word = text => (/^[\w.,=+:-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

// The command that repeats a run of so many steps of dt [s]. The duration is the product that the run divides
// by dt again, and numbers are written so that they read back to the same bits.
export function command(technique, settings, seed, dt, steps) {
  const set = Object.entries(settings).flatMap(([key, value]) => ['--set', `technique.${key}=${value}`]);
  const seeded = seed === 1 ? [] : ['--seed', String(seed)];
  const time = ['--dt', String(dt), '--duration', String(steps * dt)];
  return ['tumble', 'run', FILE, '--technique', technique, ...set, ...seeded, ...time].map(word).join(' ');
}

// A field with a text and a button that copies it. Pages from disk may not use the clipboard: then the text
// is selected, for the browser's own copying.
export function copy(field, button) {
  field.focus();
  field.select();
  const said = button.textContent;
  const say = text => {
    button.textContent = text;
    setTimeout(() => { button.textContent = said; }, 2000);
  };
  const selected = () => say(document.execCommand?.('copy') ? 'Copied' : 'Selected: copy it');
  if (navigator.clipboard) navigator.clipboard.writeText(field.value).then(() => say('Copied'), selected);
  else selected();
}

function copied(label, value) {
  const field = make('input', {type: 'text', readOnly: true, value, 'aria-label': label});
  const button = make('button', {type: 'button', textContent: 'Copy', 'aria-label': `Copy: ${label}`});
  button.onclick = () => copy(field, button);
  return make('div', {className: 'row copied'}, make('span', {textContent: label}), field, button);
}

export class Share {
  constructor(app) {
    this.app = app;
    find('link-copy').onclick = () => copy(find('link'), find('link-copy'));
    find('link-camera').onchange = () => this.showLink();
    find('save').onclick = () => app.attempt(this.save());
  }

  showLink() {
    const {setup, catalogue, stage} = this.app;
    const file = setup.toml !== undefined;
    const camera = find('link-camera').checked ? stage.camera : setup.camera;
    const link = `${location.href.split('#')[0]}#${encode({...setup, camera}, catalogue)}`;
    find('link').value = file ? `A link cannot hold ${setup.toml.name}: send the file.` : link;
    find('link-copy').disabled = file;
  }

  // Writes the scene with what was thrown and taken away, and says how to repeat the run.
  async save() {
    const {app} = this;
    const {simulation, setup, drawing, plots} = app;
    if (app.replay) return app.say('This is a recording, which is in a file already.');
    await app.play(false);
    let frame = await drawing.stillFrame();
    let scene = await simulation.scene(0);
    // Who comes or goes at this very time is seen by the next step, here and in a run of the file.
    const {time, steps} = plots.named(frame.slots[0].numbers);
    const changes = [...scene.matchAll(/^(?:dis)?appears = (.*)$/gm)];
    const more = steps > 0 && changes.some(([, when]) => Number(when) >= time);
    if (more) {
      await simulation.steps(1);
      frame = await drawing.stillFrame();
      scene = await simulation.scene(0);
    }
    const own = [setup.techniqueSettings, setup.versusSettings];
    const rows = await Promise.all(app.techniques.map(async (technique, slot) => [
      copied(`Command, ${technique}`, command(technique, own[slot], setup.seed, numberOf(setup.dt),
        plots.named(frame.slots[slot].numbers).steps)),
      copied(`State hash, ${technique}`, await simulation.hash(slot)),
    ]));
    const address = URL.createObjectURL(new Blob([scene], {type: 'application/toml'}));
    make('a', {href: address, download: FILE}).click();
    setTimeout(() => URL.revokeObjectURL(address), 60e3);
    find('share').open = true;
    find('saved').hidden = false;
    const note = `Saved as ${FILE}. ${more ? 'One step more was made, which sees what came last. ' : ''}` +
      'A command ends in the state hash below it:';
    find('saved').replaceChildren(make('p', {className: 'note', textContent: note}), ...rows.flat());
    return undefined;
  }
}
