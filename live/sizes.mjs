// Prints how large the page is, as it is and compressed: node sizes.mjs MODULE.wasm FOLDER.
//
// exit codes: 0 small enough, 1 too large, 2 bad input
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {brotliCompressSync, gzipSync} from 'node:zlib';

const MOST = 490;  // [kB] compressed, all that a reader has to wait for

const [moduleFile, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node sizes.mjs MODULE.wasm FOLDER');
  process.exit(2);
}

const kilobytes = bytes => bytes.length / 1000;
const row = (name, ...cells) =>
  console.log(name.padEnd(24), ...cells.map(cell => (cell.toFixed?.(1) ?? cell).padStart(8)));

row('kB', 'raw', 'gzip', 'brotli');
const compressed = (name, path) => {
  const bytes = readFileSync(path);
  const brotli = kilobytes(brotliCompressSync(bytes));
  row(name, kilobytes(bytes), kilobytes(gzipSync(bytes, {level: 9})), brotli);
  return brotli;
};
compressed('tumble.wasm', moduleFile);
const page = compressed('index.html', join(folder, 'index.html'));
const script = compressed('live.js, with the module', join(folder, 'live.js'));
const all = page + script;
console.log(`page and script: ${all.toFixed(1)} kB compressed; the limit is ${MOST} kB`);
if (all > MOST) {
  console.error('the live page is too large');
  process.exit(1);
}
