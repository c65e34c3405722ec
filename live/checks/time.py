"""Time in the page: slow drawing does not hold it up, and long use costs nothing."""

SLOW = 300  # [ms] that a frame takes
LEAST = 0.8  # of real time; the machine may have other things to do
LEAST_FRAMES = 3
MOST_HEAP, MOST_NODES = 3e6, 200  # [bytes], [-] by which a page may grow that is left alone

BUSY = """(() => {
  const real = globalThis.requestAnimationFrame;
  globalThis.requestAnimationFrame = task => real(now => {
    const began = performance.now();
    while (performance.now() - began < %d) ;
    task(now);
  });
})()"""
CLOCKS = """(() => ({real: performance.now() / 1000, frames: tumble.frames,
                      time: tumble.app.plots.named(tumble.app.drawing.last.slots[0].numbers).time}))()"""


def check_slow_drawing(page):
    page.open("scene=stack&technique=contact_damped&play=1")
    browser = page.browser
    browser.value(BUSY % SLOW)
    browser.wait(2)
    before = browser.value(CLOCKS)
    browser.wait(8)
    after = browser.value(CLOCKS)
    real, time, frames = (after[key] - before[key] for key in ("real", "time", "frames"))
    print(f"  with {SLOW} ms for a frame: {time / real:.2f} of real time, {frames} frames in {real:.1f} s")
    if time < LEAST * real:
        yield f"with frames of {SLOW} ms simulated time goes at {time / real:.2f} of real time"
    if frames < LEAST_FRAMES:
        yield f"with frames of {SLOW} ms only {frames} were drawn in {real:.1f} s"
    yield from page.faults()


def check_alone(page, seconds=20, speed=60):
    """A page that is left alone, in fast motion, keeps neither memory nor elements."""
    browser = page.browser
    page.open("scene=stack&technique=contact_damped&show=contacts,forces,pivots&colour=islands&play=1")
    browser.ask("HeapProfiler.enable")
    browser.value(f"tumble.simulation.speed({speed}).then(() => true)")

    def used():
        browser.ask("HeapProfiler.collectGarbage")
        return browser.ask("Runtime.getHeapUsage")["usedSize"], browser.ask("Memory.getDOMCounters")["nodes"]

    browser.wait(5)
    before, began = used(), browser.value(CLOCKS)
    browser.wait(seconds)
    after, ended = used(), browser.value(CLOCKS)
    heap, nodes = (b - a for a, b in zip(before, after))
    minutes, frames = (ended["time"] - began["time"]) / 60, ended["frames"] - began["frames"]
    print(f"  left alone for {minutes:.0f} simulated minutes, {frames} frames: {heap / 1e6:+.2f} MB, {nodes:+d} elements")
    if heap > MOST_HEAP or nodes > MOST_NODES:
        yield f"a page that is left alone grows by {heap / 1e6:.1f} MB and {nodes} elements"
    yield from page.faults()
