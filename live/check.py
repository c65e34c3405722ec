#!/usr/bin/env python3
"""Opens the live page from disk in a headless Chromium and does to it what people do.

usage: live/check.py BUILD_LIVE --tumble COMMAND --hashes LIVE_HASHES [--pictures DIR] [--full] [--only PART,...] [--skip PART,...]

The parts: throw (a click at the pyramid), keyboard (every control), links and files (bad ones get a sentence), webgl
(its lack, too), replay (a run of the command), gltf (such a run in a glTF file, which three.js reads in node),
sessions (repeated by the command to the same state), drawing (slow), alone (left for long), hashes (every scene under
every technique, as the native program has it; with --full at full size, which takes hours), hour (of steps), speed
(beside the native one: a ratio, no verdict below 3).

exit codes: 0 all is well, 1 something is not, 2 bad input
"""
import argparse
import pathlib
import sys
import tempfile
import time

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "site"))
from browser import Browser  # noqa: E402
from checks import gltf, hands, keyboard, module, refusals, time as clocks  # noqa: E402
from checks.page import SIZES, Page  # noqa: E402


def parts(said, page, downloads):
    """Name and task of each part, in the order in which they are done."""
    for size in SIZES:
        yield "throw", lambda: hands.check_throw(page, size, said.tumble, downloads)
    for size in SIZES:
        yield "keyboard", lambda: keyboard.check_keyboard(page, size, downloads)
    yield "links", lambda: refusals.check_links(page)
    yield "files", lambda: refusals.check_files(page, said.tumble)
    yield "webgl", lambda: refusals.check_no_webgl(lambda browser: Page(browser, said.folder, said.pictures))
    yield "replay", lambda: hands.check_replay(page, said.tumble)
    yield "gltf", lambda: gltf.check_gltf(said.tumble)
    yield "sessions", lambda: hands.check_sessions(page, said.tumble, downloads)
    yield "drawing", lambda: clocks.check_slow_drawing(page)
    yield "alone", lambda: clocks.check_alone(page)
    for name, task in (("hashes", lambda: module.check_hashes(page.browser, said.hashes, said.full)),
                       ("hour", lambda: module.check_hour(page.browser)),
                       ("speed", lambda: module.check_speed(page.browser, said.hashes))):
        def opened(task=task):
            page.open("scene=box_drop&play=0")
            yield from task()
            yield from page.faults()
        yield name, opened


def main():
    ask = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ask.add_argument("folder", type=pathlib.Path, metavar="BUILD_LIVE")
    ask.add_argument("--tumble", type=pathlib.Path, required=True)
    ask.add_argument("--hashes", type=pathlib.Path, required=True)
    ask.add_argument("--pictures", type=pathlib.Path)
    ask.add_argument("--full", action="store_true")
    ask.add_argument("--only", default="")
    ask.add_argument("--skip", default="")
    said = ask.parse_args()
    for path in (said.folder / "index.html", said.folder / "live.js", said.tumble, said.hashes):
        if not path.is_file():
            ask.error(f"{path} is missing; make live and make command write the page and the programs")
    said.tumble, said.hashes = said.tumble.resolve(), said.hashes.resolve()
    if said.pictures:
        said.pictures.mkdir(parents=True, exist_ok=True)
    only, skip = ({name for name in names.split(",") if name} for names in (said.only, said.skip))

    faults, began = 0, time.monotonic()
    with Browser(webgl=True) as browser, tempfile.TemporaryDirectory() as downloads:
        page = Page(browser, said.folder, said.pictures)
        for name, task in parts(said, page, pathlib.Path(downloads)):
            if name in skip or (only and name not in only):
                continue
            print(f"{name} ({time.monotonic() - began:.0f} s)", flush=True)
            try:
                for fault in task():
                    faults += 1
                    print(f"  FAULT: {fault}", flush=True)
            except RuntimeError as error:
                faults += 1
                print(f"  FAULT: {error}", flush=True)
    print(f"the live page in a browser: {faults} faults, {time.monotonic() - began:.0f} s")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
