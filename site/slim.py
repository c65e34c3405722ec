#!/usr/bin/env python3
"""Takes out of the site what no reader sees: a quarter of its bytes is left, and each page looks as before.

usage: site/slim.py SITE

Pictures are there once, in figures/, and each in one form: SVG, or PNG where the SVG of a scene of many boxes has
over 150 kB. Anchors have eight letters, and the lines of a source count themselves (custom.css). Of a source file that
documents nothing but itself the listing is left; a class has no second list of its members; the side bar leads to
pages, not to members.
"""
import pathlib
import re
import sys

LARGE = 150_000  # [bytes] of an SVG
HASH = re.compile(r"\ba([0-9a-f]{32})\b")  # the name that Doxygen gives to a member
UNSEEN = [(re.compile(pattern), replacement) for pattern, replacement in (
    (r'#l0+(\d+)"', r'#l\1"'),
    (r' id="([^"]*)" name="\1"', r' id="\1"'),
    (r'<span class="\w+"></span>', ""),
    (r'<tr class="separator:\w*"><td class="memSeparator" colspan="2">&#160;</td></tr>\n', ""),
    (r'<a href="[^"]*-members\.html">List of all members</a>', ""),
    (r' align="(left|right)" valign="(top|bottom)"', ""),
    (r"<!--(?! contents -->).*?-->", ""),
    (r"/\* @license(-end|[^*]* MIT) \*/\n", ""),  # about the line between them; each file of its own has its licence
)]
LISTED = [(re.compile(pattern), replacement) for pattern, replacement in (
    (r'<div class="fragment">', '<div class="fragment numbered">'),
    (r'<div class="line"><a id="l0*(\d+)" name="l\d+"></a><span class="lineno">.*?</span>', r'<div id="l\1">'),
    (r'<a class="code[^"]*" href="([^"]*)"(?: title="[^"]*")?>', r'<a href="\1">'),
    *((rf'<span class="{kind}">([^<]*)</span>', rf"<{tag}>\1</{tag}>") for kind, tag in (
        ("comment", "i"), ("keyword", "b"), ("keywordtype", "u"), ("keywordflow", "em"))),  # coloured in custom.css
    (r'<a href="[^"]*">Go to the documentation of this file.</a>', ""),
)]
# gnuplot opens groups that stay empty, and says in each what holds for all.
DRAWN = [(re.compile(pattern), replacement) for pattern, replacement in (
    (r"(<g [^>]*>\n</g>\n)+", ""),
    (r"\t<g stroke='none' shape-rendering='crispEdges'>\n\t\t(<polygon [^>]*)/>\n\t</g>\n",
     r"\1 stroke='none' shape-rendering='crispEdges'/>"),
    (r' stroke-linecap="butt" stroke-linejoin="miter"| font-family="sans-serif"', ""),
    (r'<g fill="none" color="black" stroke="currentColor"', "<g"),
    (r'(<rect x="0" y="0" [^>]*)/>', r'\1 stroke="none"/>'),
    (r"\s*\n\s*", "\n"),
    (r'<g id="gnuplot_canvas">', '<g id="gnuplot_canvas" fill="none" color="black" stroke="currentColor" stroke-linecap="butt" '
                                 'stroke-linejoin="miter" font-family="sans-serif">'),
)]


# Its coordinates have hundredths of a point.
POINTS = re.compile(r"\b(points = |d=|transform=)(['\"])[^'\"]*\2")
HUNDREDTH = re.compile(r"(\.\d)\d\b")


def replaced(text, rules):
    for pattern, replacement in rules:
        text = pattern.sub(replacement, text)
    return text


def slim_pictures(site):
    """Returns which file each picture has become: a dict from its name to a path in the site."""
    now = {}
    for svg in sorted((site / "figures").glob("*.svg")):
        text = replaced(svg.read_text(encoding="utf-8"), DRAWN)
        svg.write_text(POINTS.sub(lambda match: HUNDREDTH.sub(r"\1", match.group(0)), text), encoding="utf-8")
        (site / svg.name).unlink(missing_ok=True)
        png = svg.with_suffix(".png")
        kept, other = (png, svg) if svg.stat().st_size > max(LARGE, png.stat().st_size) else (svg, png)
        other.unlink()
        now[svg.name] = now[png.name] = f"figures/{kept.name}"
    for film in (site / "figures").glob("*.gif"):
        (site / film.name).unlink(missing_ok=True)
        now[film.name] = f"figures/{film.name}"
    return now


def addresses(site):
    """Returns the pages that go, and what gives a text with the addresses of those that stay.

    A hash gets eight letters, or as many as tell all of them apart."""
    texts = {page.name: page.read_text(encoding="utf-8") for page in site.glob("*.html")}
    names = {name for text in texts.values() for name in HASH.findall(text)}
    length = next(n for n in range(7, 33) if len({name[:n] for name in names}) == len(names))
    gone = {name for name, text in texts.items() if name.endswith("_8cpp.html") and '<div class="memitem">' not in text}
    source = re.compile(r"\b\w+_8cpp\.html")

    def now(text):
        text = HASH.sub(lambda match: "a" + match.group(1)[:length], text)
        return source.sub(lambda match: match.group(0)[:-5] + ("_source.html" if match.group(0) in gone else ".html"), text)

    return gone, now


def slim_pages(site, pictures, gone, now):
    named = re.compile(r'"(?:figures/)?([\w.]+\.(?:svg|png|gif))"')
    # Doxygen shows an SVG as an object, in which a PNG would not be scaled.
    shown = re.compile(r'<object type="image/svg\+xml" data="([^"]+\.png)"[^>]*></object>')
    links = re.compile(r' · <a href="figures/(\w+)\.(svg|png)">\2</a>')
    for page in site.glob("*.html"):
        if page.name in gone or page.stem.endswith("-members"):
            page.unlink()
            continue
        text = links.sub(lambda m: m.group(0) if pictures[m.group(1) + ".svg"].endswith(m.group(2)) else "",
                         page.read_text(encoding="utf-8"))
        text = named.sub(lambda m: f'"{pictures.get(m.group(1), m.group(0)[1:-1])}"', text)
        text = shown.sub(r'<img src="\1" alt="" />', text)
        if page.stem.endswith("_source"):
            text = replaced(text, LISTED)
        page.write_text(now(replaced(text, UNSEEN)), encoding="utf-8")


def slim_side_bar(site, now):
    leaf = re.compile(r'"(?:class|struct|union)\w+"(?= \])|"\w+_8[hc]pp"(?= \])')
    row = re.compile(r'"([^"]*)":\[([\d,]*)\]')
    leaves, places = set(), {}
    for file in sorted(site.glob("*.js")):
        text = file.read_text(encoding="utf-8")
        if file.stem.startswith("navtreeindex"):
            places.update({url: path for url, path in row.findall(text)})
            file.unlink()
        elif re.fullmatch(r"(class|struct|union)\w+|\w+_8[hc]pp", file.stem):
            leaves.add(f"{file.stem}.html")
            file.unlink()
        elif file.stem not in ("site", "jquery"):
            file.write_text(now(leaf.sub("null", text)), encoding="utf-8")
    ends = {places[url] for url in leaves if url in places}

    def cut(path):
        parts = path.split(",")
        return next((start for n in range(1, len(parts)) if (start := ",".join(parts[:n])) in ends), path)

    kept = {now(url): cut(path) for url, path in places.items()
            if not HASH.search(url.partition("#")[2])}
    rows = ",\n".join(f'"{url}":[{path}]' for url, path in sorted(kept.items()))
    (site / "navtreeindex0.js").write_text(f"var NAVTREEINDEX0 =\n{{\n{rows}\n}};\n", encoding="utf-8")
    data = site / "navtreedata.js"
    data.write_text(re.sub(r"(var NAVTREEINDEX =\n)\[.*?\];", r'\1[""];', data.read_text(encoding="utf-8"), flags=re.S),
                    encoding="utf-8")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    site = pathlib.Path(sys.argv[1])
    gone, now = addresses(site)
    slim_pages(site, slim_pictures(site), gone, now)
    slim_side_bar(site, now)
    for file in (*site.glob("*.md5"), *site.glob("*.map")):
        file.unlink()
    text = "".join(page.read_text(encoding="utf-8") for page in site.glob("*.html"))
    for file in (site / "figures").iterdir():
        if f"figures/{file.name}" not in text:
            file.unlink()
    size = sum(file.stat().st_size for file in site.rglob("*") if file.is_file())
    print(f"The site has {size / 1e6:.1f} MB")


main()
