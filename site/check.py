#!/usr/bin/env python3
"""Opens the site from disk in a headless Chromium, as a reader with a desk and one with a phone would.

usage: site/check.py SITE [--pictures DIR]

On every page below: it loads without an error on the console and without a file that is missing, formulas are
typeset, nothing makes it scroll sideways, and each link and picture leads to something. The search finds a word
of the text, and its first hit leads there. With --pictures each page is also saved as it looks, light and dark.

exit codes: 0 all is well, 1 something is not, 2 bad input
"""
import argparse
import base64
import json
import os
import pathlib
import re
import select
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

PAGES = ("index", "how_to_read", "notation", "basic_colliding", "analytic_lcp", "impulse_damped",
         "geometric_stability", "timewarp", "filtering", "exterior_rotation", "gallery", "ledger", "errata",
         "tolerances", "algorithms", "verified", "deviations", "references", "pages", "classtumble_1_1Basic", "namespacetumble",
         "separation_8hpp")
SIZES = {"desk": (1400, 900), "phone": (390, 800)}  # CSS pixels
FORMULAS = {"notation", "basic_colliding", "analytic_lcp", "impulse_damped", "geometric_stability", "timewarp",
            "filtering", "exterior_rotation", "namespacetumble"}  # pages that must have some
WORD = "bisection"
PATIENCE = 60  # [s] for one answer of the browser

# Resolves when MathJax has nothing left to do.
SETTLED = """new Promise(done => window.MathJax ? MathJax.Hub.Queue(() => done(true)) : done(false))"""
LOOK = r"""(() => {
  const content = document.getElementById('doc-content');
  const copy = content.cloneNode(true);
  copy.querySelectorAll('script, code, pre, .fragment, .MathJax_SVG').forEach(node => node.remove());
  return {
    typeset: document.querySelectorAll('.MathJax_SVG svg').length,
    formulas: document.querySelectorAll('script[type^="math/tex"]').length,
    wrong: window.MathJax ? MathJax.Hub.getAllJax().filter(one => one.texError).map(one => one.originalText) : [],
    raw: (copy.textContent.match(/\\f[$\[{]|\\\(|\\\[|\\(ref|frac|mathbf)\b.{0,20}/g) || []),
    wide: [document.documentElement, content].some(box => box.scrollWidth > box.clientWidth) ||
          document.documentElement.scrollWidth > innerWidth,
    widest: [...content.querySelectorAll('*')].filter(node => node.getBoundingClientRect().right > innerWidth + 1)
        .map(node => node.tagName + '.' + node.className).slice(0, 3),
    links: ['href', 'src', 'data'].flatMap(key => [...document.querySelectorAll(`body [${key}]`)].map(
        node => node.getAttribute(key))),
    pictures: [...document.querySelectorAll('img')].filter(node => node.complete && !node.naturalWidth)
        .map(node => node.getAttribute('src')),
    height: content.scrollHeight,
  };
})()"""
SEARCH = """new Promise(done => {
  const box = document.getElementById('search_words');
  box.focus(); box.value = %s; box.dispatchEvent(new Event('input'));
  const began = Date.now();
  (function look() {
    const hits = [...document.querySelectorAll('#search_results:not([hidden]) a')].map(node => node.href);
    if (hits.length || Date.now() - began > 10000) done(hits); else setTimeout(look, 20);
  })();
})"""


class Browser:
    """A headless Chromium, spoken to through its debugging pipe."""

    def __init__(self):
        self.home = tempfile.mkdtemp()
        command_out, self.commands = os.pipe()
        self.answers, answer_in = os.pipe()
        # Chromium reads commands from descriptor 3 and answers on descriptor 4.
        command = ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                   "--hide-scrollbars", f"--user-data-dir={self.home}", "--remote-debugging-pipe", "about:blank"]
        shell = ["sh", "-c", f'exec "$@" 3<&{command_out} 4>&{answer_in}', "sh"]
        self.process = subprocess.Popen(shell + command, pass_fds=(command_out, answer_in),
                                        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        os.close(command_out)
        os.close(answer_in)
        self.rest, self.number, self.events, self.session = b"", 0, [], None
        target = next(item for item in self.ask("Target.getTargets")["targetInfos"] if item["type"] == "page")
        attached = self.ask("Target.attachToTarget", targetId=target["targetId"], flatten=True)
        self.session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")
        self.ask("Page.setLifecycleEventsEnabled", enabled=True)
        self.ask("Emulation.setFocusEmulationEnabled", enabled=True)

    def close(self):
        os.close(self.commands)
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
        shutil.rmtree(self.home, ignore_errors=True)

    def receive(self):
        while b"\0" not in self.rest:
            if not select.select([self.answers], [], [], PATIENCE)[0]:
                raise RuntimeError(f"chromium has not answered for {PATIENCE} s")
            more = os.read(self.answers, 1 << 20)
            if not more:
                raise RuntimeError("chromium has ended")
            self.rest += more
        message, self.rest = self.rest.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.commands, data):]
        while True:
            message = self.receive()
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            self.events.append(message)

    def value(self, expression):
        answer = self.ask("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", "a script failed"))
        return answer["result"].get("value")

    def open(self, address):
        self.ask("Page.navigate", url="about:blank")
        self.events.clear()
        answer = self.ask("Page.navigate", url=address)
        if "errorText" in answer:
            raise RuntimeError(answer["errorText"])
        loaded = (answer["loaderId"], "load")
        while not any(event.get("method") == "Page.lifecycleEvent" and
                      (event["params"]["loaderId"], event["params"]["name"]) == loaded for event in self.events):
            self.events.append(self.receive())
        self.value(SETTLED)

    def complaints(self):
        """What the browser had to complain about since the page was opened."""
        for event in self.events:
            data = event.get("params", {})
            if event.get("method") == "Runtime.exceptionThrown":
                details = data["exceptionDetails"]
                yield "error in a script: " + details.get("exception", {}).get("description", details["text"])
            elif event.get("method") == "Runtime.consoleAPICalled" and data["type"] in ("error", "assert"):
                yield "error on the console: " + " ".join(str(item.get("value")) for item in data["args"])
            elif event.get("method") == "Log.entryAdded" and data["entry"]["level"] == "error":
                yield "error: " + data["entry"]["text"] + " " + data["entry"].get("url", "")
            elif event.get("method") == "Network.requestWillBeSent" and data["request"]["url"].startswith("http"):
                yield "asks the network for " + data["request"]["url"]

    def resize(self, width, height, phone):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)

    def picture(self, path):
        path.write_bytes(base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"]))


class Anchors:
    """Which names the pages have that a link can lead to; each page is read once."""

    def __init__(self):
        self.known = {}

    def has(self, path, name):
        if path not in self.known:
            text = path.read_text(encoding="utf-8", errors="replace")
            self.known[path] = set(re.findall(r'\b(?:id|name)="([^"]*)"', text))
        return name in self.known[path]


def dead_links(site, page, links, anchors):
    for link in sorted(set(links)):
        parts = urllib.parse.urlsplit(link)
        if parts.scheme or link.startswith("javascript:"):
            continue
        target = site / urllib.parse.unquote(parts.path) if parts.path else site / f"{page}.html"
        if not target.is_file():
            yield f"leads nowhere: {link}"
        elif parts.fragment and target.suffix == ".html" and not anchors.has(target, parts.fragment):
            yield f"leads to a place that is not there: {link}"


def check_page(browser, site, page, size, anchors, pictures):
    browser.resize(*SIZES[size], size == "phone")
    browser.open((site / f"{page}.html").as_uri())
    seen = browser.value(LOOK)
    yield from browser.complaints()
    if seen["typeset"] < seen["formulas"]:
        yield f"{seen['formulas'] - seen['typeset']} of {seen['formulas']} formulas are not typeset"
    if page in FORMULAS and not seen["typeset"]:
        yield "has no formulas"
    yield from (f"formula with a mistake: {text}" for text in seen["wrong"])
    if seen["raw"]:
        yield f"shows {seen['raw'][0]} instead of what it means"
    if seen["wide"]:
        yield "scrolls sideways: " + ", ".join(seen["widest"])
    yield from (f"picture does not load: {name}" for name in seen["pictures"])
    yield from dead_links(site, page, seen["links"], anchors)
    if pictures:
        browser.resize(SIZES[size][0], min(seen["height"] + 200, 12000), size == "phone")
        for scheme in ("light", "dark"):
            browser.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
            browser.value("new Promise(done => setTimeout(done, 400))")
            browser.picture(pictures / f"{page}_{size}_{scheme}.png")


def check_search(browser, site, size, anchors, pictures):
    browser.resize(*SIZES[size], size == "phone")
    browser.open((site / "index.html").as_uri())
    hits = browser.value(SEARCH % json.dumps(WORD))
    yield from browser.complaints()
    if pictures:
        browser.picture(pictures / f"search_{size}.png")
    if not hits:
        yield f"the search does not find '{WORD}'"
        return
    yield from dead_links(site, "index", [urllib.parse.unquote(hit).rsplit("/", 1)[1] for hit in hits], anchors)
    browser.open(hits[0])
    yield from browser.complaints()
    if WORD not in browser.value("document.getElementById('doc-content').textContent.toLowerCase()"):
        yield f"the first hit for '{WORD}' does not have the word: {hits[0]}"


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("site", type=pathlib.Path)
    ask.add_argument("--pictures", type=pathlib.Path)
    said = ask.parse_args()
    site = said.site.resolve()
    if not (site / "index.html").is_file():
        ask.error(f"{site} holds no site; make site writes one into build/site")
    if said.pictures:
        said.pictures.mkdir(parents=True, exist_ok=True)

    faults, anchors, browser = 0, Anchors(), Browser()
    try:
        for size in SIZES:
            for page in PAGES:
                if not (site / f"{page}.html").is_file():
                    found = ["there is no such page"]
                else:
                    found = list(check_page(browser, site, page, size, anchors, said.pictures))
                for fault in found:
                    print(f"{page}.html ({size}): {fault}")
                faults += len(found)
            for fault in check_search(browser, site, size, anchors, said.pictures):
                print(f"search ({size}): {fault}")
                faults += 1
    finally:
        browser.close()
    print(f"{len(PAGES)} pages at {len(SIZES)} sizes in a browser: {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
