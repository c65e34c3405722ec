"""The live page in a browser: opening it, and what a look at it tells."""
import json
import urllib.parse

SIZES = {"desk": (1280, 720), "phone": (390, 780)}  # CSS pixels

STATE = """(() => {
  const {app, frames} = globalThis.tumble;
  const {last} = app.drawing;
  const slots = last ? last.slots.map(seen => ({
    ...app.plots.named(seen.numbers), boxes: seen.bodies.length / 24, contacts: seen.contacts.length / 14,
  })) : [];
  return {frames, playing: app.playing, slots,
          alerts: [...document.querySelectorAll('#alerts span')].map(node => node.textContent)};
})()"""


class Page:
    """The page of a folder, opened by links."""

    def __init__(self, browser, folder, pictures=None):
        self.browser, self.folder, self.pictures = browser, folder.resolve(), pictures
        self.address = (self.folder / "index.html").as_uri()

    def open(self, link, size="desk"):
        """Loads the page at a size, and waits until its scene is shown."""
        self.size = size
        self.browser.resize(*SIZES[size], size == "phone")
        self.browser.open(f"{self.address}#{link}")
        self.browser.value("tumble.ready.then(() => true)")
        self.settle()

    def follow(self, link):
        """Sets up something else in the page that is open, as a link does."""
        self.browser.value("document.querySelectorAll('#alerts button').forEach(button => button.click())")
        self.browser.value(f"tumble.app.follow({json.dumps('#' + link)}).then(() => true)")
        self.settle()

    def settle(self):
        self.must("tumble.app && !tumble.app.busy && tumble.app.placed && "
                  "(tumble.app.replay || tumble.app.drawing.last) !== undefined")

    def must(self, expression, patience=60):
        found = self.browser.wait_for(expression, patience)
        if not found:
            raise RuntimeError(f"in {patience} s this has not become true: {expression}")
        return found

    def state(self):
        return self.browser.value(STATE)

    def steps(self, slot=0):
        return self.state()["slots"][slot]["steps"]

    def play(self, on):
        self.browser.value(f"tumble.app.play({json.dumps(on)}).then(() => true)")

    def middle(self, selector="#half0 canvas"):
        """The middle of what can be seen of an element."""
        return self.browser.value(f"""(() => {{
          const box = document.querySelector({json.dumps(selector)}).getBoundingClientRect();
          return [box.x + box.width / 2, box.y + box.height / 2];
        }})()""")

    def picture(self, name):
        if self.pictures:
            self.browser.wait(0.5)
            self.browser.picture(self.pictures / f"{name}_{self.size}.png")

    def faults(self):
        """What was complained about since the page was opened; it asks for its two files and nothing else."""
        yield from self.browser.complaints()
        own = {(self.folder / name).as_uri() for name in ("index.html", "live.js")}
        for address in self.browser.requests():
            parts = urllib.parse.urlsplit(address)
            known = ("blob", "data", "http", "https", "ws", "wss")  # in the page, or complained about
            if parts.scheme not in known and parts._replace(fragment="").geturl() not in own:
                yield f"asks for {address[:200]}"
