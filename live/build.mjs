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
const SHADERS = '[/\\\\]three[/\\\\]src[/\\\\]renderers[/\\\\]shaders[/\\\\]';
const UNUSED_SHADERS = new RegExp(SHADERS + 'ShaderChunk[/\\\\].*(physical|transmission|iridescence|clearcoat|' +
    'lightprobes|toon|phong|tonemapping|metalness|roughness|bumpmap|normalmap|morph|skin|displacement).*');
const UNUSED_PROGRAMS = new RegExp(SHADERS + 'ShaderLib[/\\\\]' +
    '(background|backgroundCube|cube|equirect|linedashed|meshmatcap|meshnormal|meshphong|meshphysical|meshtoon|' +
    'sprite)\\.');
const common = {bundle: true, minify: true, format: 'iife', target: 'es2021', charset: 'utf8', legalComments: 'none'};

// A character for each byte, and no more escapes than a string needs: compressed that is about as small as the
// bytes themselves. base64 is a quarter larger.
const PLACE = 'place of the module';
const ESCAPES = {'\n': '\\n', '\r': '\\r', "'": "\\'", '\\': '\\\\'};
const literal = `'${(await readFile(moduleFile)).toString('latin1').replace(/[\n\r'\\]/g, it => ESCAPES[it])}'`;

const embedded = {
  name: 'embedded',
  setup(it) {
    // `text:FILE`: a script, bundled, as a string: the worker's.
    it.onResolve({filter: /^text:/}, ({path}) => ({path: join(here, path.slice(5)), namespace: 'text'}));
    it.onLoad({filter: /.*/, namespace: 'text'}, async ({path}) => {
      const {outputFiles} = await build({...common, entryPoints: [path], write: false});
      return {contents: outputFiles[0].text, loader: 'text'};
    });
    // `module:`: the WebAssembly module as a string, put in when all else is written.
    it.onResolve({filter: /^module:$/}, ({path}) => ({path, namespace: 'module'}));
    it.onLoad({filter: /.*/, namespace: 'module'}, () => ({contents: PLACE, loader: 'text'}));
    // three.js by its sources, so that what its materials for metal, glass, skies and toys say to the graphics card
    // can be left out: the page draws with MeshLambertMaterial, ShadowMaterial and shaders of its own.
    it.onResolve({filter: /^three$/}, ({kind, resolveDir}) => it.resolve('three/src/Three.js', {kind, resolveDir}));
    it.onLoad({filter: UNUSED_SHADERS}, () => ({contents: 'export default "";', loader: 'js'}));
    it.onLoad({filter: UNUSED_PROGRAMS}, () => ({
      contents: 'export const vertex = "", fragment = "";', loader: 'js',
    }));
  },
};

await mkdir(folder, {recursive: true});
const {outputFiles} =
    await build({...common, entryPoints: [join(here, 'main.js')], write: false, plugins: [embedded]});
await writeFile(join(folder, 'live.js'),
                outputFiles[0].text.replace(new RegExp(`["'\`]${PLACE}["'\`]`), () => literal));
const [page, style] = await Promise.all(['index.html', 'style.css'].map(name => readFile(join(here, name), 'utf8')));
await writeFile(join(folder, 'index.html'), page.replace('/* style.css */', () => style));
