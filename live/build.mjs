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
const bytes = await readFile(moduleFile);
// page/module.js has these; the others are what C would tell an operating system, and come to nothing.
const ASKED = ['page.number', 'page.text', 'env.emscripten_notify_memory_growth'];
for (const {module, name} of WebAssembly.Module.imports(new WebAssembly.Module(bytes))) {
  if (module === 'wasi_snapshot_preview1' || ASKED.includes(`${module}.${name}`)) continue;
  console.error(`build.mjs: the module asks for ${module}.${name}, which page/module.js does not have`);
  process.exit(1);
}
const THREE = '[/\\\\]three[/\\\\]src[/\\\\]';
const SHADERS = THREE + 'renderers[/\\\\]shaders[/\\\\]';
const UNUSED_CHUNKS = new RegExp(SHADERS + 'ShaderChunk[/\\\\].*(physical|transmission|iridescence|clearcoat|' +
    'lightprobes|toon|phong|tonemapping|metalness|roughness|bumpmap|normalmap|morph|skin|displacement|alphahash|' +
    'alphamap|aomap|batching|clipping|dithering|emissivemap|envmap|fog|gradientmap|lightmap|logdepth|uv_).*');
const UNUSED_PROGRAMS = new RegExp(SHADERS + 'ShaderLib[/\\\\]' +
    '(background|backgroundCube|cube|distance|equirect|linedashed|meshbasic|meshmatcap|meshnormal|meshphong|' +
    'meshphysical|meshtoon|points|sprite|vsm)\\.');
const USED_SHADERS = new RegExp(SHADERS + 'Shader(Chunk|Lib)[/\\\\]');
// What the renderer asks of parts that the page has no use for: headsets, reflections, morph targets, buffers of uniforms,
// effects on the finished picture.
const IDLE_PARTS = {
  WebXRManager: `export class WebXRManager {
    enabled = false; isPresenting = false;
    setAnimationLoop() {} addEventListener() {} removeEventListener() {} getEnvironmentBlendMode() {} dispose() {}
  }`,
  PMREMGenerator: 'export class PMREMGenerator {}',
  DFGLUTData: 'export const getDFGLUT = () => null;',
  WebGLMorphtargets: 'export function WebGLMorphtargets() { return {update() {}}; }',
  WebGLEnvironments: 'export function WebGLEnvironments() { return {get: () => null, dispose() {}}; }',
  WebGLUniformsGroups: 'export function WebGLUniformsGroups() { return {dispose() {}}; }',
  WebGLOutput: 'export class WebGLOutput {}',
};
// Nor does it write objects of three.js into files, or read them.
const FILED = /\n\t(to|from)JSON\([^\n]*\{\n[^]*?\n\t\}\n/g;
const common = {bundle: true, minify: true, format: 'iife', target: 'es2021', charset: 'utf8', legalComments: 'none'};

// A character for each byte, and no more escapes than a string needs: compressed that is about as small as the
// bytes themselves. base64 is a quarter larger.
const PLACE = 'place of the module';
const ESCAPES = {'\n': '\\n', '\r': '\\r', "'": "\\'", '\\': '\\\\'};
const literal = `'${bytes.toString('latin1').replace(/[\n\r'\\]/g, it => ESCAPES[it])}'`;

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
    it.onLoad({filter: UNUSED_CHUNKS}, () => ({contents: 'export default "";', loader: 'js'}));
    it.onLoad({filter: UNUSED_PROGRAMS}, () => ({
      contents: 'export const vertex = "", fragment = "";', loader: 'js',
    }));
    // Comments and indents of the shaders in use are text to the bundler, which leaves them as they are.
    it.onLoad({filter: USED_SHADERS}, async ({path}) => ({
      contents: (await readFile(path, 'utf8')).replace(/\/\/.*$/gm, '').replace(/\n\s+/g, '\n'), loader: 'js',
    }));
    const idle = new RegExp(`${THREE}.*[/\\\\](${Object.keys(IDLE_PARTS).join('|')})\\.js$`);
    it.onLoad({filter: idle}, ({path}) => ({contents: IDLE_PARTS[idle.exec(path)[1]], loader: 'js'}));
    it.onLoad({filter: new RegExp(THREE)}, async ({path}) => ({
      contents: (await readFile(path, 'utf8')).replace(FILED, '\n'), loader: 'js',
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
