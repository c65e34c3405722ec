"""The module against the native programs: same bits, no leak, and how fast."""
import resource
import statistics
import subprocess

STEPS = 300  # of each comparison of hashes: all has landed and met by then

HOURS = 7200  # [s] of patience: a heap at full size
HOUR = 216000  # steps
SLOWER = 2.0  # what the last quarter of an hour may take over the first: a clock is no verdict, but a leak doubles it
RATIO_WANTED, RATIO_MOST = 1.5, 3.0  # of the module's step time to the native one

PREPARE = """(async () => {
  const {Module, bytes} = globalThis.tumble;
  globalThis.bench = await Module.from(bytes);
  const names = bench.catalogue().numbers;
  const steps = () => bench.look(0, 0).numbers[names.indexOf('steps')];
  // What live_hashes prints for a scene, its settings and a technique.
  globalThis.outcome = (scene, settings, technique, count) => {
    try {
      const set = settings.map(setting => `set scene.${setting}\\n`).join('');
      bench.open(0, `scene ${scene}\\ntechnique ${technique}\\n${set}`);
    } catch (error) {
      return `refused ${error.message}`;
    }
    try {
      bench.step(0, count, 1 / 60);
    } catch (error) {
      if (steps() === 0) return `refused ${error.message}`;
    }
    return `${steps()} ${bench.hash(0)}`;
  };
})()"""

# Steps with a look at each tenth, as a page takes that draws slowly.
IDLE = """(() => {
  for (let k = 0; k < %d; ++k) {
    bench.step(0, 1, 1 / 60);
    if (k %% 10 === 0) bench.look(0, 31);
  }
  return bench.memory;
})()"""

RUN = """(() => {
  bench.open(0, 'scene %s\\ntechnique contact_damped\\n');
  bench.step(0, %d, 1 / 60);
})()"""


def check_hashes(browser, hashes, full):
    """Every pair of scene and technique comes to the same state, or is refused in the same words."""
    browser.value(PREPARE)
    pairs, different = 0, 0
    # The native program runs on while the browser does the pairs that it has printed.
    command = [hashes, str(STEPS), *(["full"] if full else [])]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as native:
        try:
            for line in native.stdout:
                scene, size, technique, right = line.rstrip("\n").split(" ", 3)
                settings = [] if size == "-" else size.split(",")
                found = browser.value(f"outcome('{scene}', {settings}, '{technique}', {STEPS})", patience=HOURS)
                pairs += 1
                if found != right:
                    different += 1
                    yield f"{scene} {size} {technique}: the module comes to {found}, the native program to {right}"
            native.wait()
        finally:
            native.kill()
    print(f"  {pairs - different} of {pairs} pairs of scene and technique come to the same state after {STEPS} steps")
    if native.returncode != 0 or not pairs:
        yield f"live_hashes has ended with code {native.returncode} after {pairs} pairs"


def thread_time(browser):
    """What the page's thread has computed so far [s], whatever else the machine does."""
    browser.ask("Performance.enable", timeDomain="threadTicks")
    return next(one["value"] for one in browser.ask("Performance.getMetrics")["metrics"] if one["name"] == "ThreadTime")


def check_hour(browser, steps=HOUR, chunks=60):
    """A stack that is left alone for an hour takes no more memory and no more time at its end."""
    browser.value(PREPARE)
    browser.value("bench.open(0, 'scene stack\\ntechnique contact_damped\\n')")
    memory, times = [], [thread_time(browser)]
    for _ in range(chunks):
        memory.append(browser.value(IDLE % (steps // chunks), patience=HOURS))
        times.append(thread_time(browser))
    spent = [b - a for a, b in zip(times, times[1:])]
    quarter = chunks // 4
    first, last = statistics.median(spent[:quarter]), statistics.median(spent[-quarter:])
    print(f"  an hour of a stack: {sum(spent):.0f} s, last quarter over first {last / first:.2f}, "
          f"{memory[-1] / 2**20:.0f} MiB")
    if memory[-1] > memory[0]:
        yield f"memory has grown from {memory[0]} to {memory[-1]} bytes in an hour"
    if last > SLOWER * first:
        yield f"a step takes {last / first:.1f} times as long after an hour"


def module_time(browser, scene, steps):
    before = thread_time(browser)
    browser.value(RUN % (scene, steps), patience=HOURS)
    return thread_time(browser) - before


def native_time(hashes, scene, steps):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([hashes, str(steps), "full", scene, "contact_damped"], check=True, capture_output=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def check_speed(browser, hashes, rounds=5):
    """How long a step takes, beside the native one, in turns; the fastest counts."""
    browser.value(PREPARE)
    for scene, steps, what in (("pyramid", 3000, "the pyramid at rest"), ("fig6_6", 600, "the pyramid hit by a cube")):
        module_time(browser, scene, steps)  # the browser compiles what is used much once more
        pairs = [(module_time(browser, scene, steps), native_time(hashes, scene, steps)) for _ in range(rounds)]
        module, native = (1000 * min(times) / steps for times in zip(*pairs))
        ratio = module / native
        print(f"  a step of {what}: {module:.3f} ms in the module, {native:.3f} ms native, ratio {ratio:.2f} "
              f"(goal: at most {RATIO_WANTED})")
        if ratio > RATIO_MOST:
            yield f"a step of {what} takes {ratio:.1f} times as long in the module"
