#!/usr/bin/env python3
"""Prints the pages Idea and Algorithm of all chapters as one PDF, by a headless Chromium.

usage: site/book.py SITE BOOK.pdf

SITE is what cmake/site wrote. The pages are put together as one, SITE/book.html: what is folded on the site is open, a
scene that runs there is its picture, and links between these pages lead to a place in the book.

exit codes: 0 done, 1 a page is not as expected, 2 bad input
"""
import base64
import pathlib
import re
import sys

sys.dont_write_bytecode = True
from browser import Browser  # noqa: E402, beside this file

DOXYFILE = pathlib.Path(__file__).parent.parent / "Doxyfile"
CHAPTERS = re.findall(r"chapters/(\w+)/idea\.md", DOXYFILE.read_text(encoding="utf-8"))  # in their order
PAGES = ("how_to_read", "notation", *[chapter + page for chapter in CHAPTERS for page in ("", "_algorithm")],
         "choose_a_technique", "glossary", "references")
STYLE = """
@page { size: A4; margin: 18mm 16mm 20mm; }
html { --content-maxwidth: none; --spacing-large: 0; }
body { background: #fff; color: #111; font-size: 10.5pt; margin: 0; padding: 0; }
#cover { height: 240mm; display: flex; flex-direction: column; justify-content: center; break-after: page; }
#cover h1 { font-size: 32pt; margin: 0; } #cover p { font-size: 13pt; max-width: 30em; }
nav.book { break-after: page; } nav.book li.inner { margin-left: 2em; list-style: none; }
section.page { break-before: page; } section.page > h1.title { font-size: 21pt; margin: 0 0 8mm; text-align: left; }
section.page .contents h1 { font-size: 15pt; } section.page .contents h2 { font-size: 12pt; } section.page .contents h3 { font-size: 11pt; }
.toc, .try, .controls, #nav-path { display: none !important; }
div.contents { margin: 0; padding: 0; max-width: none; }
div.fragment { break-inside: auto; } div.fragment div.line { white-space: pre-wrap; overflow-wrap: anywhere; }
figure, div.image, table tr, .formulaDsp { break-inside: avoid; } h1, h2, h3 { break-after: avoid; }
figure img, div.image img, div.image object { width: auto !important; max-width: 130mm !important; max-height: 150mm; }
a { color: #00558a; text-decoration: none; } details.fold { border: 0; padding: 0; }
"""
FOOTER = ('<div style="font:8px sans-serif;width:100%;text-align:center;color:#666">'
          '<span class="pageNumber"></span></div>')
PRINTED = """new Promise(done => MathJax.Hub.Queue(() =>
    document.fonts.ready.then(() => done([...document.images].filter(one => !one.naturalWidth).length))))"""


def parts_of(site, page):
    text = (site / f"{page}.html").read_text(encoding="utf-8")
    title = re.search(r'<div class="title">(.*?)\s*</div>', text, re.S)
    body = re.search(r'<div class="contents">(.*)</div><!-- contents -->', text, re.S)
    if not title or not body:
        raise ValueError(f"{page}.html has no title or no contents: is it Doxygen's?")
    return title.group(1), body.group(1)


def inner_link(match):
    page, place = match.group(1), match.group(2)
    if page and page not in PAGES:
        return ""  # what is not in the book has no link
    return f'href="#{place or page}"'


def book_of(site):
    head = (site / "basic_colliding.html").read_text(encoding="utf-8")
    keep = re.findall(r'<link href="[^"]*\.css"[^>]*>|<script src="formulas\.js"></script>', head)
    contents, sections = "", ""
    for page in PAGES:
        title, body = parts_of(site, page)
        body = re.sub(r'href="(?:(\w+)\.html)?(?:#(\w+))?"', inner_link, body)
        body = body.replace("<details", "<details open")
        contents += f'<li{" class=inner" if page.endswith("_algorithm") else ""}><a href="#{page}">{title}</a></li>\n'
        sections += f'<section class="page" id="{page}"><h1 class="title">{title}</h1><div class="contents">{body}</div></section>\n'
    return ('<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Tumble</title>' + "\n".join(keep) +
            f"<style>{STYLE}</style></head><body>" + '<div id="cover"><h1>Tumble</h1><p>Techniques for real-time rigid body '
            'simulation, computed. The ideas and the algorithms of all chapters; the measurements, the ledger of claims and '
            'the sources are on the site.</p></div><nav class="book"><h1>Contents</h1><ul>' + contents + "</ul></nav>" +
            sections + "</body></html>")


def main():
    if len(sys.argv) != 3 or not (pathlib.Path(sys.argv[1]) / "basic_colliding.html").is_file():
        print(__doc__, file=sys.stderr)
        return 2
    site, target = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    book = site / "book.html"
    book.write_text(book_of(site), encoding="utf-8")
    try:
        with Browser() as browser:
            browser.scheme("light")
            browser.open(book.as_uri())
            missing = browser.value(PRINTED, patience=600)
            complaints = list(browser.complaints())
            if missing or complaints:
                print(f"site/book.py: {missing} pictures are missing;", *complaints, sep="\n", file=sys.stderr)
                return 1
            printed = browser.ask("Page.printToPDF", patience=600, preferCSSPageSize=True, printBackground=True,
                                  displayHeaderFooter=True, headerTemplate="<span></span>", footerTemplate=FOOTER,
                                  scale=0.78, generateDocumentOutline=True, generateTaggedPDF=True)
    finally:
        book.unlink()
    target.write_bytes(base64.b64decode(printed["data"]))
    print(f"The book is {target}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
