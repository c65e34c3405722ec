// Writes down what a built page is and does: node record.mjs MODULE.wasm ARCHIVE <RIGHT >RECORD.
//
// RIGHT is what `live_hashes record` prints. The lines that come out are the module's own answers to the same
// questions; then the hashes of what the page is made of and of the archive that holds it.
// verification/live/ready_test.cpp compares.
//
// exit codes: 0 done, 1 the module answers otherwise than the native program
import {readdirSync, readFileSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {Module} from './page/module.js';

const here = dirname(fileURLToPath(import.meta.url));
const [moduleFile, archive] = process.argv.slice(2);
const module = await Module.from(readFileSync(moduleFile));
const {scenes, techniques, numbers} = module.catalogue();

const declared = kind => ({name, settings}) =>
  [kind, name, ...settings.map(({key}) => key)].join(' ');

// What becomes of SCENE SIZE TECHNIQUE STEPS, in live_hashes' words.
function outcome(question) {
  const [scene, size, technique, steps] = question;
  const settings = size === '-' ? [] : size.split(',');
  const done = () => module.look(0, 0).numbers[numbers.indexOf('steps')];
  try {
    const set = settings.map(it => `set scene.${it}\n`).join('');
    module.open(0, `scene ${scene}\ntechnique ${technique}\n${set}`);
  } catch {
    return 'refused';
  }
  try {
    module.step(0, Number(steps), 1 / 60);
  } catch {
    if (done() === 0) return 'refused';
  }
  return module.hash(0);
}

// FNV-1a, 32 bits wide.
function fnv(...parts) {
  let hash = 0x811c9dc5;
  for (const part of parts) for (const byte of part) hash = Math.imul(hash ^ byte, 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, '0');
}
const named = (folder, wanted) => readdirSync(join(here, folder)).filter(name => wanted.test(name))
  .map(name => folder + name);
const sources = [...named('', /\.[ch]pp$|^build\.mjs$|^package-lock\.json$/), ...named('page/', /./)].sort();

const right = readFileSync(0, 'utf8').trimEnd().split('\n');
const pairs = right.slice(scenes.length + techniques.length);
const found = [
  ...scenes.map(declared('scene')), ...techniques.map(declared('technique')),
  ...pairs.map(line => line.split(' ').slice(0, 4)).map(asked => [...asked, outcome(asked)].join(' ')),
];
const wrong = found.findIndex((line, k) => line !== right[k]);
if (wrong >= 0 || found.length !== right.length) {
  console.error(`record.mjs: the module says "${found[wrong]}", the native program "${right[wrong]}"`);
  process.exit(1);
}
const bytes = path => readFileSync(join(here, path));
found.push(`sources ${fnv(...sources.map(bytes))}`, `archive ${fnv(readFileSync(archive))}`);
console.log(found.join('\n'));
