#!/usr/bin/env python3
"""Writes search_index.js, the words of every page of the site, for search.js.

usage: site/search_index.py SITE

A row of the index is a section of a page, or a documented member: address, title, title of the page, text, and
whether it belongs to the reference rather than to a chapter. Source listings and Doxygen's own lists are left out.
"""
import html.parser
import json
import pathlib
import re
import sys
import textwrap

# Pages that only list others.
LISTS = re.compile(r"^(annotated|classes|files|functions|globals|graph_legend|hierarchy|inherits|namespaces|"
                   r"namespacemembers|pages|dir_)|_source$|-members$|_8cpp$")
REFERENCE = re.compile(r"^(class|struct|union|namespace|concept)|_8hpp$")
PROSE = {"textblock", "memdoc"}
SKIPPED = {"toc", "fragment", "permalink", "mlabels", "definition"}
VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source", "track", "wbr"}
BLOCKS = {"p", "div", "td", "th", "li", "dt", "dd", "tr"}
INCLUDES = re.compile(r"^(#include \S+ )*(Include dependency graph for \S+ ?)?")
FORMULA = re.compile(r"\\\(.*?\\\)|\\\[.*?\\\]", re.DOTALL)


class Page(html.parser.HTMLParser):
    """Collects the sections of one page as [anchor, title, text]."""

    def __init__(self, title):
        super().__init__()
        self.sections = [["", title, ""]]
        self.stack = []          # (tag, in prose, skipped) of the elements that are open
        self.heading = None      # tag of the heading that is being read
        self.anchor = ""         # the last one that was read
        self.article = ""        # id of an article whose heading is still to come

    def handle_starttag(self, tag, attributes):
        found = dict(attributes)
        classes = set((found.get("class") or "").split())
        if tag == "a" and found.get("id"):
            self.anchor = found["id"]
            if self.heading:
                self.sections[-1][0] = self.anchor
        _, prose, skipped = self.stack[-1] if self.stack else ("", False, False)
        if tag in VOID:
            self.sections[-1][2] += " "
            return
        member = "memtitle" in classes
        prose = prose or member or bool(classes & PROSE)
        skipped = skipped or tag in ("script", "style", "iframe", "object") or bool(classes & SKIPPED)
        self.stack.append((tag, prose, skipped))
        if not prose or skipped:
            return
        if tag == "article":
            self.article = found.get("id", "")
        elif tag in ("h1", "h2", "h3"):
            self.heading = tag
            self.sections.append([self.anchor if member else self.article, "", ""])
            self.article = ""
        elif tag == "figure" and found.get("id"):
            self.sections.append([found["id"], "", ""])
        elif "entry" in classes:
            self.sections.append([self.anchor, "", ""])
        elif tag in BLOCKS:
            self.sections[-1][2] += " "

    def handle_endtag(self, tag):
        if tag in VOID or tag not in (name for name, _, _ in self.stack):
            return
        while self.stack.pop()[0] != tag:
            pass
        if tag == self.heading:
            self.heading = None

    def handle_data(self, data):
        _, prose, skipped = self.stack[-1] if self.stack else ("", False, False)
        if prose and not skipped:
            self.sections[-1][1 if self.heading else 2] += data


def plain(text):
    return " ".join(FORMULA.sub(" ", text).split())


def rows_of(path):
    source = path.read_text(encoding="utf-8")
    title = html.unescape(re.search(r"<title>(.*?)</title>", source, re.DOTALL).group(1))
    title = re.sub(r"^Tumble: | (Class|Struct|Namespace|File|Union)( Template)? Reference$", "", title.strip())
    page = Page(title)
    page.feed(source)
    for anchor, heading, text in page.sections:
        heading, text = plain(heading), INCLUDES.sub("", plain(text))
        heading = heading or textwrap.shorten(text, 70, placeholder=" …")
        if heading and (text or anchor):
            address = path.name + ("#" + anchor if anchor else "")
            yield [address, heading, title, text, int(bool(REFERENCE.search(path.stem)))]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    site = pathlib.Path(sys.argv[1])
    pages = sorted(path for path in site.glob("*.html") if not LISTS.search(path.stem))
    rows = [row for path in pages for row in rows_of(path)]
    lines = ",\n".join(json.dumps(row, ensure_ascii=False, separators=(",", ":")) for row in rows)
    (site / "search_index.js").write_text("Search.take([\n" + lines + "\n]);\n", encoding="utf-8")
    print(f"{len(rows)} sections of {len(pages)} pages can be searched")


main()
