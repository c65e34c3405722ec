"""What hands do in the page: throws, whole sessions that `tumble run` repeats, and recordings that are played."""
import csv
import json
import pathlib
import shlex
import subprocess
import tempfile

PYRAMID = "scene=pyramid&scene.rows=10&technique=contact_damped"
MOVED = 0.05  # [m] farther than a pyramid that nobody hits gets

# Where the boxes of a scene are that were not thrown, by their number: in the page, and after as many steps of the
# same set-up without a throw.
SEEN = """(() => {
  const {bodies} = tumble.app.drawing.last.slots[0];
  const found = {};
  for (let at = 0; at < bodies.length; at += 24)
    if (!(bodies[at + 18] & 8)) found[bodies[at]] = [...bodies.slice(at + 1, at + 4)];
  return found;
})()"""
UNTHROWN = """(async () => {
  const module = await tumble.Module.from(tumble.bytes);
  module.open(0, 'scene pyramid\\ntechnique contact_damped\\n');
  module.step(0, %d, 1 / 60);
  const {bodies} = module.look(0, 0);
  const found = {};
  for (let at = 0; at < bodies.length; at += 24) found[bodies[at]] = [...bodies.slice(at + 1, at + 4)];
  return found;
})()"""

ACT = """(async acts => {
  const {app, simulation} = tumble;
  const look = () => app.drawing.last.slots[0];
  const boxes = () => look().bodies.length / 24;
  let [steps, count] = [0, boxes()];
  for (const act of acts) {
    if (act.steps) await simulation.steps(act.steps);
    else if (act.throw) await simulation.throwBox(act.throw);
    else await simulation.takeAway(look().bodies[24 * act.take]);
    steps += act.steps ?? 0;
    count += act.throw ? 1 : act.steps ? 0 : -1;
    while (app.plots.named(look().numbers).steps !== steps || boxes() !== count)
      await new Promise(done => setTimeout(done, 20));
  }
  return steps;
})(%s)"""
SAVED = """[...document.querySelectorAll('#saved input')].map(one => [one.getAttribute('aria-label'), one.value])"""


def run(tumble, words, folder):
    """Runs the command `tumble run` and returns its summary."""
    words = [tumble, "run", *words, "--out", folder, "--quiet"]
    said = subprocess.run(words, capture_output=True, text=True)
    summary = pathlib.Path(folder) / "summary.json"
    if not summary.is_file():
        raise RuntimeError(f"{shlex.join(map(str, words))}: {said.stderr.strip()}")
    return json.loads(summary.read_text())


def check_throw(page, size, tumble, downloads):
    """A click, or on a phone a tap, throws a box that hits the pyramid; what was thrown is repeated by the command."""
    browser = page.browser
    page.open(PYRAMID + "&play=1", size)
    frames = page.state()["frames"]
    if not browser.wait_for(f"tumble.frames > {frames + 10}"):
        yield "frames do not advance"
    page.picture("start")
    (browser.tap if size == "phone" else browser.click)(*page.middle())
    if not browser.wait_for("tumble.app.drawing.last.slots[0].bodies.length === 24 * 56", 20):
        yield "a click adds no box"
    began = page.state()["slots"][0]["time"]
    page.must(f"tumble.app.plots.named(tumble.app.drawing.last.slots[0].numbers).time > {began + 2}")
    page.play(False)
    browser.wait(1)
    page.picture("thrown")
    seen, without = browser.value(SEEN), browser.value(UNTHROWN % page.steps())
    far = [max(abs(a - b) for a, b in zip(seen[name], without[name])) for name in without]
    hit = sum(distance > MOVED for distance in far)
    print(f"  at {size} size a click moves {hit} of {len(far)} boxes of the pyramid, one by {max(far):.2f} m")
    if not hit:
        yield "the box that is thrown does not hit the pyramid"
    yield from repeat(page, tumble, downloads)
    yield from page.faults()


def repeat(page, tumble, downloads):
    """Saves what was thrown and runs it natively, once for each technique of the page."""
    browser = page.browser
    browser.downloads(downloads)
    browser.value("document.getElementById('save').click()")
    page.must("!document.getElementById('saved').hidden")
    saved = browser.value(SAVED)
    files = []
    for _ in range(100):
        files = [path for path in downloads.iterdir() if path.suffix == ".toml"]
        if files:
            break
        browser.wait(0.1)
    if not files:
        yield "no file is saved"
        return
    for (what, command), (_, right) in zip(saved[::2], saved[1::2]):
        _, _, name, *words = shlex.split(command)
        if name != files[0].name:
            yield f"the command names {name}, the file is called {files[0].name}"
        with tempfile.TemporaryDirectory() as home:
            summary = run(tumble, [files[0], *words, "--every", "1000000"], f"{home}/run")
        if summary["state_hash"] != right:
            yield f"{what}: the page has {right}, `{command}` ends in {summary['state_hash']}"
    files[0].unlink()


def check_sessions(page, tumble, downloads):
    """Sessions of a file, done in the page, come to the same state when `tumble run` repeats what was saved."""
    sessions = json.loads((pathlib.Path(__file__).parent / "sessions.json").read_text())
    for number, session in enumerate(sessions):
        page.open(session["link"])
        steps = page.browser.value(ACT % json.dumps(session["acts"]))
        page.picture(f"session{number + 1}")
        faults = [*repeat(page, tumble, downloads), *page.faults()]
        yield from (f"{session['what']}: {fault}" for fault in faults)
        if not faults:
            print(f"  {session['what']}: the same state in the page and natively after {steps} steps")


def check_replay(page, tumble):
    """A trajectory of `tumble run` is played, and each frame has the poses of the file."""
    browser = page.browser
    with tempfile.TemporaryDirectory() as home:
        folder = pathlib.Path(home) / "run"
        run(tumble, ["projectile", "--set", "rows=4", "--set", "appears=0.2", "--duration", "1"], folder)
        page.open("scene=box_drop&play=0")
        browser.drop([folder / "trajectory.csv", folder / "scene.toml"], *page.middle())
        page.must("tumble.app.replay !== undefined")
        page.must("tumble.app.replay.time > 0.5")
        page.play(False)
        page.picture("replay")
        with (folder / "trajectory.csv").open() as lines:
            rows = list(csv.DictReader(lines))
    times = sorted({float(row["time_s"]) for row in rows})
    for frame in (0, 5, len(times) - 1):
        right = [[float(row[key]) for key in ("px_m", "py_m", "pz_m", "qx", "qy", "qz", "qw")]
                 for row in rows if float(row["time_s"]) == times[frame]]
        found = browser.value(f"""(() => {{
          const bodies = tumble.app.replay.recording.bodiesOf({frame});
          return [...Array(bodies.length / 24).keys()].map(k => [...bodies.slice(24 * k + 1, 24 * k + 8)]);
        }})()""")
        if found != right:
            yield f"frame {frame} of the recording is not that of the file"
    browser.value("document.getElementById('scrub').focus()")
    for key, step in (("Home", 0), ("ArrowRight", 1), ("End", len(times) - 1)):
        browser.key(key)
        if not browser.wait_for(f"tumble.app.replay.frame === {step}", 5):
            yield f"the key {key} does not move the recording to frame {step}"
    browser.value("document.querySelector('canvas').focus()")
    browser.key(",")
    if not browser.wait_for(f"tumble.app.replay.frame === {len(times) - 2}", 5):
        yield "the comma key does not go a frame back"
    browser.value("document.getElementById('replay-close').focus()")
    browser.key("Enter")
    if not browser.wait_for("tumble.app.replay === undefined", 20):
        yield "the recording is not closed by keyboard"
    print(f"  a recording of {len(times)} frames is played")
    yield from page.faults()
