// Files that are dropped on the page or chosen: a scene, or a run to be played.
import {BadFile, LARGEST, Recording, readTrajectory} from './replay.js';

const text = size => `${Math.round(size / 1e6)} MB`;

// Takes what was dropped or chosen. The two files of a run may come one after the other.
async function take(app, files) {
  const scene = files.find(({name}) => name.endsWith('.toml'));
  const run = files.find(({name}) => name.endsWith('.csv'));
  const other = files.find(file => file !== scene && file !== run);
  if (other)
    app.say(`${other.name} is not used: expected trajectory.csv and scene.toml of a run, or a scene file.`);
  if (!scene && !run) return;
  const large = [scene, run].find(file => file?.size > LARGEST);
  if (large)
    throw new BadFile(`${large.name} has ${text(large.size)}, and a browser can take ${text(LARGEST)}: ` +
                      'record fewer frames with --every.');
  if (run) app.waiting = readTrajectory(await run.text(), run.name);
  if (scene) {
    const toml = {name: scene.name, text: await scene.text()};
    await app.change({toml, sceneSettings: {}});
    if (app.setup.toml?.text !== toml.text) {  // refused, and said so
      if (run) app.waiting = undefined;
      return;
    }
  }
  if (!app.waiting) return;
  if (!app.setup.toml)
    return app.say(`${app.waiting.file} has poses only: drop the scene.toml of the same run, too.`);
  const trajectory = app.waiting;
  app.waiting = undefined;
  if (trajectory.note) app.say(`${trajectory.file}, ${trajectory.note}`);
  await app.show(new Recording(trajectory, app.scene, app.setup.toml.name), app.scene);
}

export function acceptFiles(app) {
  const accept = async files => {
    if (files.length === 0) return;
    try {
      await take(app, files);
    } catch (error) {
      app.waiting = undefined;
      app.say(error instanceof BadFile ? error.message : `The file cannot be read: ${error.message}`);
    }
  };
  const choose = document.getElementById('choose');
  choose.onchange = async () => {
    const files = [...choose.files];
    await accept(files);
    choose.value = '';  // the same file may be chosen again
  };
  addEventListener('dragover', event => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  addEventListener('dragleave', ({relatedTarget}) => {
    if (!relatedTarget) document.body.classList.remove('dropping');
  });
  addEventListener('drop', event => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    accept([...event.dataTransfer.files]);
  });
}
