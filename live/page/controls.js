// The bar under the picture and the panel beside it: what is set up is shown there, and changed there.
import {COLOURS as COLOUR_NAMES} from './view.js';
import {COLOURS, SHOWS, SPEEDS, STEPS, THROW, encode, numberOf, recipeOf} from './link.js';
import {Form, choices, fillSelect, make} from './settings.js';
import {withUnit} from './plots.js';

const SHOW_NAMES = {
  contacts: 'Contact points', normals: 'Normals', forces: 'Forces and impulses',
  pivots: 'Pivots (thesis 6.2)',
};
const NAMES = {
  ...COLOUR_NAMES, stable: 'Geometrically stable (figure 5.6)', balanced: 'Stable by balance too',
};
const FORCES = [
  ['', 'as long as suits'], ['0.0001', '0.1 mm for 1 N'], ['0.001', '1 mm for 1 N'],
  ['0.01', '1 cm for 1 N'], ['0.1', '10 cm for 1 N'], ['1', '1 m for 1 N'],
];
const FILE = '(file)';  // the choice that stands for a scene file

const find = id => document.getElementById(id);

export class Controls {
  constructor(app) {
    this.app = app;
    const {scenes, techniques, version} = app.catalogue;
    find('version').textContent = `Tumble ${version}.`;
    fillSelect(find('scene'), choices(scenes));
    for (const id of ['technique', 'versus']) fillSelect(find(id), choices(techniques));
    this.forms = {
      scene: this.form('scene', values => app.change({sceneSettings: values})),
      technique: this.form('technique', values => app.change({techniqueSettings: values})),
      versus: this.form('versus', values => app.change({versusSettings: values})),
      throw: this.form('throw', values => this.setThrow(values)),
    };
    this.makeShow();
    this.listen();
    this.foldOnPhone();
  }

  form(name, onChange) {
    return new Form(find(`${name}-form`), name, onChange);
  }

  setThrow(values) {
    const numbers = Object.entries(values).map(([key, text]) => [key, Number(text)]);
    this.app.look({throw: Object.fromEntries(numbers)});
  }

  makeShow() {
    const {app} = this;
    const toggle = what => {
      const {show} = app.setup;
      app.look({show: show.includes(what) ? show.filter(one => one !== what) : SHOWS.filter(
        one => one === what || show.includes(one))});
    };
    const option = (type, group, value, text, onchange) => make('label', {className: 'check'},
      make('input', {type, name: group, value, onchange}), ` ${text}`);
    find('colours').replaceChildren(...COLOURS.map(
      colour => option('radio', 'colour', colour, NAMES[colour], () => app.look({colour}))));
    find('shows').replaceChildren(...SHOWS.map(
      what => option('checkbox', 'show', what, SHOW_NAMES[what], () => toggle(what))));
    fillSelect(find('force-scale'), FORCES, '');
    this.toggleShow = toggle;
  }

  listen() {
    const {app} = this;
    const click = (id, task) => { find(id).onclick = task; };
    click('play', () => app.play());
    click('step', () => app.step());
    click('back', () => app.step(-1));
    click('reset', () => app.reset());
    click('throw', () => app.throwAlong(app.stage.ray()));
    click('take', () => this.setTaking(!app.taking));
    click('help-open', () => {
      find('help').showModal();
      find('help-title').focus();  // else the button below would have it, and the top be out of sight
    });
    click('panel-toggle', () => this.fold());
    click('camera', () => app.stage.fitCamera());
    click('replay-close', () => app.open(true));
    // After a click of the pointer the space bar plays again; who came by keyboard stays on the button.
    find('bar').addEventListener('click', ({detail, target}) => {
      if (detail > 0) target.closest('button')?.blur();
    });
    const select = (id, task) => { find(id).onchange = event => task(event.target.value); };
    select('speed', value => app.setSpeed(Number(value)));
    select('scene', scene => scene !== FILE && app.change({scene, sceneSettings: {}, toml: undefined}));
    select('technique', technique => app.change({technique, techniqueSettings: {}}));
    select('versus', versus => app.change({versus, versusSettings: {}}));
    select('dt', dt => app.change({dt}));
    select('force-scale', value => app.look({force: value === '' ? undefined : Number(value)}));
    find('versus-on').onchange = () => this.compare();
    find('seed').onchange = ({target}) => {
      target.setAttribute('aria-invalid', String(!target.validity.valid || target.value === ''));
      if (target.getAttribute('aria-invalid') === 'false') app.change({seed: Number(target.value)});
    };
    find('scrub').oninput = ({target}) => {
      app.play(false);
      app.replay.to(Number(target.value));
    };
  }

  // A second technique, at first the most different one: one that only knows collisions.
  compare() {
    const {setup, catalogue} = this.app;
    const other = setup.technique === 'basic' ? catalogue.default_technique : 'basic';
    find('compare').open = true;
    return this.app.change({versus: setup.versus ? undefined : other, versusSettings: {}});
  }

  setTaking(on) {
    this.app.taking = on;
    find('take').setAttribute('aria-pressed', String(on));
    document.body.classList.toggle('taking', on);
  }

  // On a phone the panel is a sheet over the lower half, closed at first.
  foldOnPhone() {
    const phone = matchMedia('(max-width: 700px)');
    const fit = () => this.fold(phone.matches);
    phone.onchange = fit;
    fit();
  }

  fold(folded = !document.body.classList.contains('folded')) {
    document.body.classList.toggle('folded', folded);
    find('panel-toggle').setAttribute('aria-expanded', String(!folded));
  }

  // Everything as the set-up says.
  showSetup() {
    const {app} = this;
    const {setup, catalogue: {scenes, techniques}} = app;
    const scene = setup.toml ? undefined : recipeOf(scenes, setup.scene);
    this.showScene(scene);
    this.showTechnique('technique', recipeOf(techniques, setup.technique), setup.techniqueSettings);
    find('versus-on').checked = setup.versus !== undefined;
    find('versus-part').hidden = setup.versus === undefined;
    if (setup.versus) this.showTechnique('versus', recipeOf(techniques, setup.versus), setup.versusSettings);
    find('seed').value = setup.seed;
    this.showOneOf('dt', STEPS.map(step => [step, `${step} s`]), setup.dt, text => `${text} s`);
    this.showOneOf('speed', SPEEDS.map(([text, value]) => [value, text]), setup.speed, String);
    this.showOneOf('force-scale', FORCES, setup.force ?? '', text => `${text} m for 1 N`);
    const chosen = [setup.colour, ...setup.show];
    for (const one of document.querySelectorAll('[name=colour], [name=show]'))
      one.checked = chosen.includes(one.value);
    this.showThrow();
    const replay = app.replay !== undefined;
    document.body.classList.toggle('replaying', replay);
    find('scrubber').hidden = !replay;
    find('back').hidden = !replay;
    find('replay-note').hidden = true;  // until it is drawn
    find('full-page').hidden = !setup.embed;
    find('full-page').href = `#${encode({...setup, embed: false}, app.catalogue)}`;
    for (const [id, values] of [['scene', setup.sceneSettings], ['technique', setup.techniqueSettings],
                                ['versus', setup.versusSettings]])
      find(`${id}-options`).open ||= Object.keys(values).length > 0;
    document.title = `${setup.toml?.name ?? setup.scene}: Tumble`;
  }

  showScene(recipe) {
    const {setup, catalogue} = this.app;
    const list = choices(catalogue.scenes);
    if (setup.toml) list.unshift([FILE, `${setup.toml.name} (file)`]);
    if (find('scene').options.length !== list.length || setup.toml)
      fillSelect(find('scene'), list, recipe ? setup.scene : FILE);
    find('scene').value = recipe ? setup.scene : FILE;
    find('scene-note').textContent = recipe ? `${recipe.summary}; thesis ${recipe.section}` : 'A scene file.';
    this.forms.scene.show(recipe?.settings ?? [], setup.sceneSettings);
  }

  showTechnique(id, recipe, values) {
    find(id).value = recipe.name;
    this.forms[id].show(recipe.settings, values);
    find(`${id}-note`).textContent = `${recipe.summary}; thesis ${recipe.section}`;
  }

  // What techniques leave out, once they have seen the scene.
  showIgnored(ignored) {
    const {techniques} = this.app;
    ['technique-ignores', 'versus-ignores'].forEach((id, slot) => {
      const what = ignored[slot];
      find(id).textContent = what ? `${techniques[slot]} ignores ${what} of this scene.` : '';
    });
    find('compare').open ||= techniques.length > 1;
  }

  showThrow() {
    const suits = this.app.hand({});
    this.forms.throw.show(Object.entries(THROW).map(([key, [unit, low, high, meaning]]) => (
      {key, kind: 'number', value: String(suits[key]), unit, low, high, meaning})), this.app.setup.throw);
    this.app.stage.thrownEdge = this.app.hand().edge;
  }

  // A select that can hold a value of a link which is not among the usual ones.
  showOneOf(id, pairs, value, name) {
    const same = one => one === value || numberOf(String(one)) === numberOf(String(value));
    const usual = pairs.find(([one]) => same(one));
    fillSelect(find(id), usual ? pairs : [...pairs, [value, name(value)]], usual ? usual[0] : value);
  }

  showPlaying() {
    find('play').textContent = this.app.playing ? 'Pause' : 'Play';
  }

  showFrame({playing, reached}, {time, steps}) {
    const share = Math.round(100 * reached * this.app.setup.speed);
    const pace = playing ? `${share} % of real time` : 'paused';
    find('status').textContent = `${time.toFixed(3)} s · step ${steps} · ${pace}`;
    find('status').classList.toggle('late', playing && reached < 0.9);
    const {scales} = this.app.stage;
    const {show} = this.app.setup;
    find('arrow-note').textContent = show.includes('forces') && scales?.force > 0
      ? `An arrow as long as 1 m is a force of ${withUnit(1 / scales.force, 'N')}.` : '';
  }

  showReplay({recording: {frames, times, file, note}, frame, time}) {
    const scrub = find('scrub');
    scrub.max = frames - 1;
    scrub.value = frame;
    find('scrub-time').textContent = `frame ${frame} of ${frames - 1}`;
    find('status').textContent = `${time.toFixed(3)} s of ${times[frames - 1].toFixed(3)} s`;
    find('replay-note').hidden = false;
    const early = note && ` L${note.slice(1)}`;  // as a sentence
    find('replay-note').textContent = `Playing ${file}, ${frames} frames.${early}`;
  }
}
