"""Every control of the page is reached with the Tab key and does something by keys alone."""
import json

from browser import SHIFT

LINK = "scene=stack&technique=damped&vs=basic&play=0"
MOST_TABS = 400

# All that a control can change. A name for each control comes with it: see NAME.
PRINT = """(() => {
  const {app} = tumble;
  const all = selector => [...document.querySelectorAll(selector)];
  const slots = (app.drawing.last?.slots ?? []).map(seen => [...seen.numbers.slice(0, 2), seen.bodies.length]);
  return JSON.stringify([app.setup, app.playing, app.taking, slots, app.stage.camera, app.stage.crosshair,
    document.body.className, all('details').map(one => one.open), all('#alerts span').map(one => one.textContent),
    all('dialog[open]').length, all('button').map(one => one.textContent), document.getElementById('saved').hidden,
    document.getElementById('link').value, all('[hidden]').length, app.replay?.frame]);
})()"""

NAME = """globalThis.nameOf = node =>
  node.localName === 'summary' ? `summary ${node.textContent}` :
  node.type === 'radio' ? node.name :
  node.id || (node.value && node.name ? `${node.name} ${node.value}` : '') ||
  node.getAttribute('aria-label') || node.textContent"""

CONTROLS = """(() => {
  const controls = document.querySelectorAll('button, input, select, summary, textarea, [tabindex], a[href]');
  return [...new Map([...controls].filter(node => node.checkVisibility({checkVisibilityCSS: true}) && !node.disabled)
    .map(node => [nameOf(node), {name: nameOf(node), kind: node.localName, type: node.type ?? '',
                                 only: node.readOnly === true}])).values()];
})()"""

FOCUS = """(() => {
  const wanted = [...document.querySelectorAll('button, input, select, summary, textarea, [tabindex], a[href]')].filter(
    node => nameOf(node) === %s && node.checkVisibility());
  (wanted.find(node => node.checked) ?? wanted[0]).focus();
})()"""

# For each kind of control the keys that are tried until something changes.
TRIES = {"button": ("Enter",), "summary": ("Enter",), "canvas": ("Enter",), "select": ("ArrowDown", "ArrowUp"),
         "checkbox": (" ",), "radio": ("ArrowDown",), "number": ("ArrowUp", "ArrowDown"), "file": ("Enter",),
         "text": ()}
FIRST = {"reset": (".",), "camera": ("+",)}  # keys that make something to undo

# Short cuts, while the picture has the focus: the last of each group has to do something, after the others.
KEYS = (" ", ".", ". r", "[", "[ ]", "t", "Enter", "x", "+", "-", "+ h", "c", "n", "f", "p", "2 1", "2", "3", "4", "5",
        "6", "v", "s", "m", "?", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Shift+ArrowLeft",
        "Shift+ArrowRight", "Shift+ArrowUp", "Shift+ArrowDown")


def press(browser, key):
    browser.key(key.removeprefix("Shift+"), SHIFT if key.startswith("Shift+") else 0)


def changes(page, keys):
    """Whether one of the keys changes something, once nothing changes by itself any more."""
    before = None
    while before != (before := page.browser.value(PRINT)):
        page.browser.wait(0.1)
    for key in keys:
        press(page.browser, key)
        if page.browser.wait_for(f"{PRINT} !== {json.dumps(before)}", 5):
            return True
    return False


def typed(page):
    """Whether something changes when other words or another number are typed into the field that has the focus."""
    page.browser.value("document.activeElement.select()")
    page.browser.type(page.browser.value("document.activeElement.max || 'all'"))
    return changes(page, ("Enter",))


def start_over(page):
    page.browser.value("document.querySelectorAll('dialog[open]').forEach(one => one.close())")
    page.browser.value("tumble.app.taking && document.getElementById('take').click()")
    page.browser.value("document.body.classList.contains('folded') && document.getElementById('panel-toggle').click()")
    page.follow(LINK)
    page.browser.value("document.querySelectorAll('details').forEach(one => { one.open = true; })")


def reached(browser):
    """The names of what has the focus after each press of Tab, until it comes round."""
    names = []
    browser.value("document.activeElement?.blur()")
    while len(names) < MOST_TABS:
        browser.key("Tab")
        name = browser.value("document.activeElement === document.body ? '' : nameOf(document.activeElement)")
        if name and names and name == names[0]:
            break
        names.append(name)
    return names


def check_keyboard(page, size, downloads):
    browser = page.browser
    page.open(LINK, size)
    browser.value(NAME)
    browser.downloads(downloads)
    browser.ask("Page.setInterceptFileChooserDialog", enabled=True)
    start_over(page)
    controls = browser.value(CONTROLS)
    found = reached(browser)
    lost = [control["name"] for control in controls if control["name"] not in found]
    if lost:
        yield f"the Tab key does not lead to {', '.join(lost)}"
    for control in controls:
        keys = TRIES.get(control["type"] if control["kind"] == "input" else control["kind"])
        if control["only"]:
            continue
        if keys is None:
            yield f"do not know how to try {control['name']}, {control['kind']} {control['type']}"
            continue
        start_over(page)
        if control["name"] in FIRST:
            browser.value("document.querySelector('#half0 canvas').focus()")
            changes(page, FIRST[control["name"]])
        browser.value(FOCUS % json.dumps(control["name"]))
        if control["type"] == "file":
            press(browser, keys[0])
            browser.wait(1)
            done = any(event["method"] == "Page.fileChooserOpened" for event in browser.events)
        else:
            done = changes(page, keys) or (control["type"] in ("text", "number") and typed(page))
        if not done:
            yield f"by keyboard {control['name']} does nothing"
    for keys in KEYS:
        *before, key = [" "] if keys == " " else keys.split(" ")
        start_over(page)
        browser.value("document.querySelector('#half0 canvas').focus()")
        for other in before:
            changes(page, (other,))
        if not changes(page, (key,)):
            yield f"the key {key} does nothing"
    print(f"  {len(controls)} controls and {len(KEYS)} keys at {size} size")
    start_over(page)
    yield from page.faults()
