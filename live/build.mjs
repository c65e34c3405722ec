// Bundles the page: node build.mjs MODULE.wasm FOLDER writes index.html and live.js there.
//
// All of it is in these two files, the module too, since a page that is opened from disk may not load others.
import {build} from 'esbuild';
import {readFile, writeFile, mkdir} from 'node:fs/promises';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = join(dirname(fileURLToPath(import.meta.url)), 'page');
const [moduleFile, folder] = process.argv.slice(2);
if (!folder) {
  console.error('usage: node build.mjs MODULE.wasm FOLDER');
  process.exit(2);
}
const common = {bundle: true, minify: true, format: 'iife', target: 'es2021', charset: 'utf8', legalComments: 'none'};

const embedded = {
  name: 'embedded',
  setup(it) {
    // `text:FILE`: a script, bundled, as a string: the worker's.
    it.onResolve({filter: /^text:/}, ({path}) => ({path: join(here, path.slice(5)), namespace: 'text'}));
    it.onLoad({filter: /.*/, namespace: 'text'}, async ({path}) => {
      const {outputFiles} = await build({...common, entryPoints: [path], write: false});
      return {contents: outputFiles[0].text, loader: 'text'};
    });
    // `module:`: the WebAssembly module as a string with a character for each byte. Compressed it is as
    // small as the bytes; base64 is a quarter larger.
    it.onResolve({filter: /^module:$/}, ({path}) => ({path, namespace: 'module'}));
    it.onLoad({filter: /.*/, namespace: 'module'}, async () => ({
      contents: (await readFile(moduleFile)).toString('latin1'), loader: 'text',
    }));
  },
};

await mkdir(folder, {recursive: true});
await build({...common, entryPoints: [join(here, 'main.js')], outfile: join(folder, 'live.js'), plugins: [embedded]});
const [page, style] = await Promise.all(['index.html', 'style.css'].map(name => readFile(join(here, name), 'utf8')));
await writeFile(join(folder, 'index.html'), page.replace('/* style.css */', () => style));
