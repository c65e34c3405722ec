#!/usr/bin/env python3
"""Opens the site from disk in a headless Chromium, as a reader with a desk and one with a phone would.

usage: site/check.py SITE [--pictures DIR]

On every page below: it loads without an error on the console and without a file that is missing, formulas are
typeset and fit the page, drawings can be dragged and cut off none of their words, nothing makes it scroll sideways, no listing is cut
off at a desk, no page of prose has more than 5000 words, each link and picture leads to something, and where the site
has the live page, each scene runs when it comes into sight. The search finds a word of the text, and its first hit
leads there.
With --pictures each page is also saved as it looks, light and dark.

exit codes: 0 all is well, 1 something is not, 2 bad input
"""
import argparse
import json
import pathlib
import re
import sys
import time
import urllib.parse

sys.dont_write_bytecode = True
from book import CHAPTERS  # noqa: E402, beside this file
from browser import PATIENCE, Browser  # noqa: E402

# Chapters of three pages: idea, algorithm, measured.
SPLIT = [f"{chapter}{page}" for chapter in CHAPTERS for page in ("", "_algorithm", "_measured")]
PAGES = ("index", "how_to_read", "thesis_map", "notation", "glossary",
         *SPLIT, "gallery", "figures_of_exterior_rotation", "ledger", "errata",
         "appendix_a", "left_open", "tolerances", "live_page", "choose_a_technique", "use_the_library",
         "add_a_technique", "algorithms", "verified", "deviations", "references", "pages", "classtumble_1_1Basic", "namespacetumble",
         "separation_8hpp")
PROSE = {"index", "how_to_read", "notation", "glossary", "choose_a_technique", "use_the_library", "add_a_technique", *SPLIT}  # the other pages are lists
MOST_WORDS = 5000
LARGEST = 40e6  # [bytes] of the whole site
SIZES = {"desk": (1400, 900), "phone": (390, 800)}  # CSS pixels
FORMULAS = {"add_a_technique", "choose_a_technique", "notation",
            *(page for page in SPLIT if not page.endswith("_measured")), "namespacetumble"}  # pages that must have some
WORD = "bisection"

# Resolves when MathJax has nothing left to do.
SETTLED = """new Promise(done => window.MathJax ? MathJax.Hub.Queue(() => done(true)) : done(false))"""
LOOK = r"""(() => {
  const content = document.getElementById('doc-content');
  const copy = content.cloneNode(true);
  copy.querySelectorAll('script, code, pre, .fragment, .MathJax_SVG').forEach(node => node.remove());
  const words = node => {
    node.querySelectorAll('table, figure, .toc').forEach(table => table.remove());
    return node.textContent.split(/\s+/).filter(word => /\w/.test(word)).length;
  };
  return {
    typeset: document.querySelectorAll('.MathJax_SVG svg').length,
    formulas: document.querySelectorAll('script[type^="math/tex"]').length,
    beyond: [...document.querySelectorAll('.MathJax_SVG_Display')].filter(box => box.scrollWidth > box.clientWidth + 2)
      .map(box => box.nextElementSibling.textContent.trim().slice(0, 40)),
    wrong: window.MathJax ? MathJax.Hub.getAllJax().filter(one => one.texError).map(one => one.originalText) : [],
    raw: (copy.textContent.match(/\\f[$\[{]|\\\(|\\\[|\\(ref|frac|mathbf)\b.{0,20}|\*\*\S.{0,20}|`.{0,20}|<\/?tt>.{0,20}/g) || []),
    wide: [document.documentElement, content].some(box => box.scrollWidth > box.clientWidth) ||
          document.documentElement.scrollWidth > innerWidth,
    widest: [...content.querySelectorAll('*')].filter(node => node.getBoundingClientRect().right > innerWidth + 1)
        .map(node => node.tagName + '.' + node.className).slice(0, 3),
    links: ['href', 'src', 'data'].flatMap(key => [...document.querySelectorAll(`body [${key}]`)].map(
        node => node.getAttribute(key))),
    pictures: [...document.querySelectorAll('img')].filter(node => node.complete && !node.naturalWidth)
        .map(node => node.getAttribute('src')).concat([...document.querySelectorAll('object')]
            .map(node => node.getAttribute('data')).filter(data => !data.endsWith('.svg'))),
    still: [...document.querySelectorAll('figure.drawing[data-drawing]:not(.dragged)')].map(one => one.dataset.drawing),
    height: content.scrollHeight,
    // A line of a listing that is wider than the listing: it would have to be moved to be read.
    cut: [...content.querySelectorAll('div.fragment')].filter(node => node.scrollWidth > node.clientWidth + 1)
        .map(node => node.textContent.trim().slice(0, 40)),
    // Words of a drawing that its edge cuts off.
    outside: [...content.querySelectorAll('figure.drawing svg')].flatMap(svg => {
      const view = svg.viewBox.baseVal, inside = (low, size, from, all) => low >= from - 2 && low + size <= from + all + 2;
      return [...svg.querySelectorAll('text')].filter(text => {
        const box = text.getBBox();
        return box.width && !(inside(box.x, box.width, view.x, view.width) && inside(box.y, box.height, view.y, view.height));
      }).map(text => text.textContent);
    }),
    words: words(copy),
  };
})()"""
# In a frame with the live page: 'runs' after its first frame, or what is wrong.
RUNS = """globalThis.tumble && tumble.ready.then(
    () => tumble.frames > 0 && (document.getElementById('alerts').textContent || 'runs'), error => error.message)"""
SEARCH = """new Promise(done => {
  const box = document.getElementById('search_words');
  box.focus(); box.value = %s; box.dispatchEvent(new Event('input'));
  const began = Date.now();
  (function look() {
    const hits = [...document.querySelectorAll('#search_results:not([hidden]) a')].map(node => node.href);
    if (hits.length || Date.now() - began > 10000) done(hits); else setTimeout(look, 20);
  })();
})"""


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
        elif target.parent.name == "live":
            continue  # what follows # is a set-up there, not a place
        elif parts.fragment and target.suffix == ".html" and not anchors.has(target, parts.fragment):
            yield f"leads to a place that is not there: {link}"


def check_page(browser, site, page, size, anchors, pictures):
    browser.resize(*SIZES[size], size == "phone")
    browser.open((site / f"{page}.html").as_uri() + "?undrawn")  # scenes run, although nothing draws them
    browser.value(SETTLED)
    seen = browser.value(LOOK)
    yield from check_live(browser)
    yield from browser.complaints()
    if seen["typeset"] < seen["formulas"]:
        yield f"{seen['formulas'] - seen['typeset']} of {seen['formulas']} formulas are not typeset"
    if page in FORMULAS and not seen["typeset"]:
        yield "has no formulas"
    yield from (f"formula with a mistake: {text}" for text in seen["wrong"])
    yield from (f"formula is cut off: {text} ..." for text in seen["beyond"])
    if seen["raw"]:
        yield f"shows {seen['raw'][0]} instead of what it means"
    yield from (f"drawing cannot be dragged: {name}" for name in seen["still"])
    yield from (f"drawing cuts off its text: {text}" for text in seen["outside"])
    if seen["wide"]:
        yield "scrolls sideways: " + ", ".join(seen["widest"])
    if size == "desk":
        yield from (f"a listing is cut off: {text} ..." for text in seen["cut"])
        if page in PROSE and seen["words"] > MOST_WORDS:
            yield f"has {seen['words']} words, more than {MOST_WORDS}"
    yield from (f"picture does not load: {name}" for name in seen["pictures"])
    yield from dead_links(site, page, seen["links"], anchors)
    if pictures:
        browser.resize(SIZES[size][0], min(seen["height"] + 200, 12000), size == "phone")
        for scheme in ("light", "dark"):
            browser.scheme(scheme)
            browser.value("new Promise(done => setTimeout(done, 400))")
            browser.picture(pictures / f"{page}_{size}_{scheme}.png")


def value_in_scene(browser):
    """What RUNS says in the frame with the live page that came last; nothing if there is none yet."""
    frames = [child["frame"] for child in browser.ask("Page.getFrameTree")["frameTree"].get("childFrames", ())]
    contexts = [event["params"]["context"] for event in browser.events
                if event["method"] == "Runtime.executionContextCreated"]  # of pages and of workers, which are in no frame
    found = [one["id"] for one in contexts
             if frames and one.get("auxData", {}).get("frameId") == frames[-1]["id"]]
    if not found:
        return None
    answer = browser.ask("Runtime.evaluate", expression=RUNS, contextId=found[-1], awaitPromise=True,
                         returnByValue=True)
    return answer["result"].get("value")


def check_live(browser):
    """Each scene of the page that is open runs when it comes into sight, and understands all of its link."""
    if browser.value("document.querySelectorAll('figure.live:not(.runs)').length"):
        yield "has scenes that stay pictures"
    for k in range(browser.value("document.querySelectorAll('figure.runs').length")):
        browser.value(f"document.querySelectorAll('figure.runs')[{k}].scrollIntoView({{block: 'center'}})")
        if not browser.wait_for(f"!!document.querySelectorAll('figure.runs')[{k}].querySelector('iframe')", 10):
            yield f"scene {k + 1} does not come"
            continue
        told, until = None, time.monotonic() + PATIENCE
        while not told and time.monotonic() < until:
            browser.wait(0.2)
            told = value_in_scene(browser)
        if told != "runs":
            yield f"scene {k + 1} does not run: {told or 'it does not start'}"


def check_search(browser, site, size, anchors, pictures):
    browser.resize(*SIZES[size], size == "phone")
    browser.open((site / "index.html").as_uri())
    browser.value(SETTLED)
    hits = browser.value(SEARCH % json.dumps(WORD))
    yield from browser.complaints()
    if pictures:
        browser.picture(pictures / f"search_{size}.png")
    if not hits:
        yield f"the search does not find '{WORD}'"
        return
    yield from dead_links(site, "index", [urllib.parse.unquote(hit).rsplit("/", 1)[1] for hit in hits], anchors)
    browser.open(hits[0])
    browser.value(SETTLED)
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

    faults, anchors = 0, Anchors()
    size = sum(file.stat().st_size for file in site.rglob("*") if file.is_file())
    if size > LARGEST:
        print(f"the site has {size / 1e6:.1f} MB, more than {LARGEST / 1e6:.0f}")
        faults += 1
    with Browser() as browser:
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
    print(f"{len(PAGES)} pages at {len(SIZES)} sizes in a browser: {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
