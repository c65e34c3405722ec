// Reads a glTF file by three.js, as viewers do, and prints as JSON where its nodes are.
//
// usage: node live/checks/gltf.mjs FILE TIME...     times in seconds
import {readFile} from 'node:fs/promises';
import {AnimationMixer} from 'three';
import {GLTFLoader} from 'three/examples/jsm/loaders/GLTFLoader.js';

globalThis.self = globalThis; // which browsers have
globalThis.ProgressEvent = class extends Event {};
const [file, ...times] = process.argv.slice(2);
const {scene, animations} = await new GLTFLoader().parseAsync(await readFile(file, 'utf8'), '');
const mixer = new AnimationMixer(scene);
for (const animation of animations) {
  const action = mixer.clipAction(animation);
  action.clampWhenFinished = true;
  action.setLoop(2200, 1); // once
  action.play();
}
const moments = times.map(Number).map(time => {
  mixer.setTime(time);
  return scene.children.map(({name, position, quaternion, scale}) => ({
    name, position: position.toArray(), quaternion: quaternion.toArray(), scale: scale.toArray(),
  }));
});
console.log(JSON.stringify({moments, seconds: Math.max(0, ...animations.map(one => one.duration))}));
