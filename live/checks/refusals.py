"""What cannot be done is said in a sentence."""
import pathlib
import tempfile

from browser import Browser
from checks.hands import run

# A link, and words that the sentence has to have: what is wrong, and what would be right.
LINKS = (
    ("scene=pyramyd", ("pyramyd", "pyramid")),
    ("technique=dampd", ("dampd", "damped")),
    ("scene=stack&vs=dampd", ("dampd", "damped")),
    ("scene=stack&scene.cout=3", ("cout", "count")),
    ("scene=stack&scene.count=-3", ("count=-3", "1 to ")),
    ("scene=stack&technique=damped&technique.damping=much", ("much", "tilt")),
    ("scene=stack&technique=damped&technique.repaired=none%0Atoml", ("repaired", "one line")),
    ("scene=stack&dt=0", ("dt=0", "expected")),
    ("scene=stack&seed=x", ("seed=x", "expected")),
    ("scene=stack&colour=red", ("red", "stable")),
    ("scene=stack&show=ghosts", ("ghosts", "contacts")),
    ("scene=stack&camera=here", ("camera=here",)),
    ("scene=stack&ball=1", ("ball", "technique")),
    ("scene=pyramid&scene.spacing=1&scene.scatter=0.1", ()),
    ("%%%", ()),
)

ALERTS = "[...document.querySelectorAll('#alerts .alert span')].map(node => node.textContent)"
RUNS = "tumble.app.drawing.last.slots[0].bodies.length > 0"


def wrong_sentence(said, words):
    text = " ".join(said)
    if not said:
        return "nothing is said"
    if not text.rstrip().endswith((".", "!")) or not text[0].isalnum():
        return f"this is no sentence: {text}"
    missing = [word for word in words if word not in text]
    return f"{text!r} does not say {missing[0]}" if missing else None


def check_links(page):
    page.open("scene=stack&play=0")
    for link, words in LINKS:
        page.follow(link + "&play=0")
        if words:
            page.browser.wait_for(f"{ALERTS}.length", 5)
        fault = wrong_sentence(page.browser.value(ALERTS), words) if words else None
        if fault:
            yield f"#{link}: {fault}"
        if not page.browser.value(RUNS):
            yield f"#{link}: nothing is shown instead"
    page.follow(LINKS[0][0] + "&play=0")
    page.picture("bad_link")
    page.browser.value("document.querySelector('#alerts button').focus()")
    page.browser.key("Enter")
    if page.browser.wait_for(f"{ALERTS}.length === 0", 5) is not True:
        yield "the sentence cannot be taken off the page by keyboard"
    print(f"  {len(LINKS)} bad links")
    yield from page.faults()


def broken_files(folder):
    """(what, files, words of the sentence) made of a run."""
    rows, scene = (folder / "trajectory.csv").read_text(), (folder / "scene.toml").read_text()
    lines = rows.splitlines(keepends=True)

    def files(name, rows=rows, scene=scene):
        home = folder / name
        home.mkdir()
        paths = []
        for end, text in (("trajectory.csv", rows), ("scene.toml", scene)):
            if text is not None:
                (home / end).write_text(text)
                paths.append(home / end)
        return paths

    yield "a file that is cut off", files("cut", rows="".join(lines[:9]) + lines[9][:40]), ("line 10", "cells")
    high = rows.replace(lines[5].split(",")[3], "high", 1)
    yield "a word for a number", files("word", rows=high), ("expected", "high")
    yield "other columns", files("columns", rows=rows.replace("time_s", "t", 1)), ("line 1", "time_s")
    yield "an empty file", files("empty", rows=""), ("trajectory.csv",)
    yield "a header alone", files("header", rows=lines[0]), ("no rows",)
    yield "another scene", files("other", scene=scene.replace('name = "', 'name = "other', 1)), ("scene.toml", "no box")
    yield "no scene", files("alone", scene=None), ("scene.toml",)
    yield "a broken scene", files("toml", scene=scene.replace("size = [", "size = {", 1)), ("scene.toml:", "expected")
    picture = folder / "picture.png"
    picture.write_bytes(b"\x89PNG")
    yield "a picture", [picture], ("picture.png", "expected")


def check_files(page, tumble):
    count = 0
    with tempfile.TemporaryDirectory() as home:
        folder = pathlib.Path(home) / "run"
        run(tumble, ["stack", "--set", "count=2", "--duration", "0.2"], folder)
        for what, files, words in broken_files(folder):
            page.open("scene=box_drop&play=0")
            page.browser.drop(files, *page.middle())
            page.browser.wait_for(f"{ALERTS}.length", 10)
            fault = wrong_sentence(page.browser.value(ALERTS), words)
            if fault:
                yield f"{what}: {fault}"
            if not page.browser.value(f"tumble.app.replay === undefined && {RUNS}"):
                yield f"{what}: it is shown all the same, or nothing is"
            yield from (f"{what}: {fault}" for fault in page.faults())
            count += 1
    print(f"  {count} broken files")


def check_no_webgl(page_of):
    """page_of(browser): the page in it."""
    with Browser() as browser:
        page = page_of(browser)
        page.open("scene=stack&play=1")
        said = browser.value("[...document.querySelectorAll('.failed')].filter(node => node.checkVisibility())"
                             ".map(node => node.textContent)")
        page.picture("no_webgl")
        fault = wrong_sentence(said, ("WebGL",))
        if fault:
            yield fault
        steps = page.steps()
        browser.wait(3)
        if page.steps() < steps + 20:
            yield "without WebGL time stands still"
        print(f"  without WebGL: {' '.join(said)}")
        yield from page.faults()
