// The set-up of the page as a link, a link as a set-up, and a set-up as a request to the module.

export const STEPS = ['1/30', '1/60', '1/120', '1/240', '1/480'];  // [s]
export const SPEEDS = [['1', 1], ['1/2', 0.5], ['1/4', 0.25], ['1/10', 0.1], ['1/50', 0.02]];
export const COLOURS = ['boxes', 'stable', 'balanced', 'islands', 'overlap', 'asleep'];
export const SHOWS = ['contacts', 'normals', 'forces', 'pivots'];
export const THROW = {  // [unit, least, most, meaning]
  speed: ['m/s', 0.01, 1000, 'speed at which a box is thrown'],
  mass: ['kg', 1e-6, 1e6, 'mass of a thrown box'],
  edge: ['m', 0.001, 100, 'edge of a thrown cube'],
};
const WORDS = ['scene', 'technique', 'vs', 'seed', 'dt', 'speed', 'show', 'colour', 'force', 'throw.speed',
  'throw.mass', 'throw.edge', 'play', 'camera', 'embed'];
const MOST_SEED = 2 ** 53 - 1;  // larger ones are not exact in a script

export function defaults(catalogue) {
  return {
    scene: 'pyramid', sceneSettings: {},
    toml: undefined,  // {name, text} of a scene file, instead of scene
    technique: catalogue.default_technique, techniqueSettings: {},
    versus: undefined, versusSettings: {},
    seed: 1, dt: '1/60', speed: 1,  // force [m/N] of an arrow; undefined: what suits
    show: [], colour: 'boxes', force: undefined, throw: {}, camera: '', play: undefined, embed: false,
  };
}

export const recipeOf = (list, name) => list.find(one => one.name === name);

// A number, or a fraction such as 1/60; NaN if it is neither.
export function numberOf(text) {
  const parts = text.split('/');
  if (parts.length > 2 || parts.some(part => part.trim() === '')) return NaN;
  return parts.length === 2 ? Number(parts[0]) / Number(parts[1]) : Number(text);
}

// Short decimal text of a value of the catalogue: 3e+01 is 30.
export const plain = (setting, text = setting.value) =>
  setting.kind === 'number' || setting.kind === 'whole' ? String(Number(text)) : text;

// What is wrong with a value of a setting; nothing if it is right.
export function fault(setting, text) {
  const {kind, low, high, choices} = setting;
  if (kind === 'number' || kind === 'whole') {
    const value = text.trim() === '' ? NaN : Number(text);
    const whole = kind === 'number' || Number.isInteger(value);
    return whole && value >= low && value <= high ? ''
      : `expected a ${kind === 'whole' ? 'whole ' : ''}number from ${low} to ${high}`;
  }
  // A line end would begin a line of its own in the request to the module.
  if (/[\u0000-\u001f\u007f]/.test(text)) return 'expected one line without control characters';
  return choices && !choices.includes(text) ? `expected one of ${choices.join(', ')}` : '';
}

class Reader {
  constructor(catalogue) {
    this.catalogue = catalogue;
    this.setup = defaults(catalogue);
    this.mistakes = [];
  }

  mistake(text) {
    this.mistakes.push(text);
  }

  // instead: what is done without it.
  oneOf(kind, list, text, instead) {
    if (recipeOf(list, text)) return text;
    const names = list.map(one => one.name).join(', ');
    this.mistake(`There is no ${kind} called ${text}: ${instead}. There are: ${names}.`);
    return undefined;
  }

  settings(prefix, list, name, given, out) {
    const {settings} = recipeOf(list, name);
    for (const [word, text] of given) {
      if (!word.startsWith(`${prefix}.`)) continue;
      const key = word.slice(prefix.length + 1);
      const setting = settings.find(one => one.key === key);
      if (!setting) {
        this.mistake(`${name} has no setting ${key}. It has: ${settings.map(one => one.key).join(', ')}.`);
        continue;
      }
      const wrong = fault(setting, text);
      if (wrong) this.mistake(`${word}=${text}: ${wrong}.`);
      else if (plain(setting, text) !== plain(setting)) out[key] = text;
    }
  }

  number(word, text, low, high) {
    const value = numberOf(text);
    if (value >= low && value <= high) return value;
    this.mistake(`${word}=${text}: expected a number from ${low} to ${high}.`);
    return undefined;
  }

  list(word, text, known) {
    return text.split(',').filter(item => item !== '').filter(item => {
      if (known.includes(item)) return true;
      this.mistake(`${word}=${item}: expected one of ${known.join(', ')}.`);
      return false;
    });
  }

  flag(word, text) {
    if (text === '0' || text === '1') return text === '1';
    this.mistake(`${word}=${text}: expected 0 or 1.`);
    return undefined;
  }

  read(given) {
    const {setup, catalogue: {scenes, techniques}} = this;
    const asked = {};  // by word, the last one counts
    for (const [word, text] of given) {
      if (WORDS.includes(word)) asked[word] = text;
      else if (!/^(scene|technique|vs)\./.test(word))
        this.mistake(`${word} is no word of such a link. There are: ${WORDS.join(', ')}, and scene.KEY, ` +
                     'technique.KEY, vs.KEY for settings.');
    }
    const take = (word, read, into = word) => {
      if (asked[word] === undefined) return;
      const value = read(asked[word]);
      if (value !== undefined) setup[into] = value;
    };
    const stays = name => `${name} is taken instead`;
    take('scene', text => this.oneOf('scene', scenes, text, stays(setup.scene)));
    take('technique', text => this.oneOf('technique', techniques, text, stays(setup.technique)));
    take('vs', text => this.oneOf('technique', techniques, text, 'nothing is compared'), 'versus');
    // Settings of something unknown cannot be looked at; that it is unknown has been said.
    if (!asked.scene || asked.scene === setup.scene)
      this.settings('scene', scenes, setup.scene, given, setup.sceneSettings);
    if (!asked.technique || asked.technique === setup.technique)
      this.settings('technique', techniques, setup.technique, given, setup.techniqueSettings);
    if (setup.versus) this.settings('vs', techniques, setup.versus, given, setup.versusSettings);
    else if (!asked.vs && given.some(([word]) => word.startsWith('vs.')))
      this.mistake('vs.KEY is set, but vs does not say for which technique.');
    take('seed', text => {
      if (/^\d+$/.test(text) && Number(text) <= MOST_SEED) return Number(text);
      return this.mistake(`seed=${text}: expected a whole number from 0 to ${MOST_SEED}.`);
    });
    take('dt', text => this.number('dt', text, 1e-5, 0.1) && text);
    take('speed', text => this.number('speed', text, 0.001, 1));
    take('force', text => this.number('force', text, 1e-9, 1e3));
    take('show', text => this.list('show', text, SHOWS));
    take('colour', text => this.list('colour', text, COLOURS)[0]);
    for (const [key, [, low, high]] of Object.entries(THROW)) {
      const word = `throw.${key}`;
      const value = asked[word] === undefined ? undefined : this.number(word, asked[word], low, high);
      if (value !== undefined) setup.throw[key] = value;
    }
    take('play', text => this.flag('play', text));
    take('embed', text => this.flag('embed', text));
    take('camera', text => text);  // the view knows what is right
  }
}

// The set-up of a link's part after #, and a sentence for everything in it that was left out.
export function decode(hash, catalogue) {
  const reader = new Reader(catalogue);
  // A plus means a plus here: damping=scale+small.
  reader.read([...new URLSearchParams(hash.replace(/^#/, '').replaceAll('+', '%2B'))]);
  return {setup: reader.setup, mistakes: reader.mistakes};
}

// The part of a link after #: what differs from the defaults, and always the scene and the technique.
export function encode(setup, catalogue) {
  const usual = defaults(catalogue);
  const words = [];
  const add = (word, value) => {
    words.push(`${word}=${encodeURIComponent(value).replace(/%2[FC]/g, decodeURIComponent)}`);
  };
  const addAll = (prefix, values) => {
    for (const [key, value] of Object.entries(values)) add(`${prefix}.${key}`, value);
  };
  if (!setup.toml) {
    add('scene', setup.scene);
    addAll('scene', setup.sceneSettings);
  }
  add('technique', setup.technique);
  addAll('technique', setup.techniqueSettings);
  if (setup.versus) {
    add('vs', setup.versus);
    addAll('vs', setup.versusSettings);
  }
  for (const word of ['seed', 'dt', 'speed', 'colour', 'force', 'camera'])
    if (setup[word] !== usual[word]) add(word, setup[word]);
  if (setup.show.length) add('show', setup.show.join(','));
  addAll('throw', setup.throw);
  if (setup.play !== undefined) add('play', setup.play ? 1 : 0);
  if (setup.embed) add('embed', 1);
  return words.join('&');
}

// What the module is asked to open; slot 1 is what is compared.
export function request(setup, slot) {
  const settings = slot === 0 ? setup.techniqueSettings : setup.versusSettings;
  const lines = [`technique ${slot === 0 ? setup.technique : setup.versus}`, `seed ${setup.seed}`];
  for (const [key, value] of Object.entries(settings)) lines.push(`set technique.${key}=${value}`);
  if (setup.toml) return [...lines, 'toml', setup.toml.text].join('\n');
  for (const [key, value] of Object.entries(setup.sceneSettings)) lines.push(`set scene.${key}=${value}`);
  return [...lines, `scene ${setup.scene}`].join('\n');
}
