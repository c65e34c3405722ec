"""A headless Chromium for checks of pages, spoken to through its debugging pipe."""
import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

PATIENCE = 60  # [s] for one answer of the browser

QUIET = ("--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--hide-scrollbars")
# WebGL is drawn by the processor, so that it looks the same with every graphics card and without one.
WEBGL = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist")
NO_WEBGL = ("--disable-gpu", "--disable-3d-apis")

# What the keys are to Chromium, besides letters and digits: code, number, text.
KEYS = {"Tab": ("Tab", 9, ""), "Enter": ("Enter", 13, "\r"), "Escape": ("Escape", 27, ""), " ": ("Space", 32, " "),
        "PageUp": ("PageUp", 33, ""), "PageDown": ("PageDown", 34, ""), "End": ("End", 35, ""),
        "Home": ("Home", 36, ""), "ArrowLeft": ("ArrowLeft", 37, ""), "ArrowUp": ("ArrowUp", 38, ""),
        "ArrowRight": ("ArrowRight", 39, ""), "ArrowDown": ("ArrowDown", 40, ""), "Delete": ("Delete", 46, ""),
        "Backspace": ("Backspace", 8, ""), "+": ("Equal", 187, "+"), "-": ("Minus", 189, "-"),
        ",": ("Comma", 188, ","), ".": ("Period", 190, "."), "?": ("Slash", 191, "?"), "/": ("Slash", 191, "/"),
        "[": ("BracketLeft", 219, "["), "]": ("BracketRight", 221, "]")}
SHIFT, CONTROL = 8, 2


class Browser:
    """One window of Chromium, in a folder of its own that goes with it."""

    def __init__(self, webgl=False):
        self.home = tempfile.mkdtemp()
        command_out, self.commands = os.pipe()
        self.answers, answer_in = os.pipe()
        # Chromium reads commands from descriptor 3 and answers on descriptor 4.
        command = ["chromium", *QUIET, *(WEBGL if webgl else NO_WEBGL), f"--user-data-dir={self.home}",
                   "--remote-debugging-pipe", "about:blank"]
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
        for domain in ("Page", "Runtime", "Log", "Network", "DOM"):
            self.ask(domain + ".enable")
        self.ask("Page.setLifecycleEventsEnabled", enabled=True)
        self.ask("Emulation.setFocusEmulationEnabled", enabled=True)
        # A worker waits until it is listened to: no request of it is missed.
        self.ask("Target.setAutoAttach", autoAttach=True, waitForDebuggerOnStart=True, flatten=True)

    def close(self):
        os.close(self.commands)
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
        shutil.rmtree(self.home, ignore_errors=True)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    # --- messages ---------------------------------------------------------------------------------------------

    def send(self, method, parameters, session):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if session:
            request["sessionId"] = session
        data = json.dumps(request).encode() + b"\0"
        while data:
            data = data[os.write(self.commands, data):]
        return self.number

    def receive(self, patience=PATIENCE):
        """The next message, of which events are kept; nothing if there is none for so long."""
        while b"\0" not in self.rest:
            if not select.select([self.answers], [], [], patience)[0]:
                return None
            more = os.read(self.answers, 1 << 20)
            if not more:
                raise RuntimeError("chromium has ended")
            self.rest += more
        data, self.rest = self.rest.split(b"\0", 1)
        message = json.loads(data)
        if "method" in message:
            self.events.append(message)
        if message.get("method") == "Target.attachedToTarget" and self.session:
            for task in ("Runtime.enable", "Network.enable", "Runtime.runIfWaitingForDebugger"):
                self.send(task, {}, message["params"]["sessionId"])
        return message

    def ask(self, method, patience=PATIENCE, **parameters):
        number = self.send(method, parameters, self.session)
        while True:
            message = self.receive(patience)
            if message is None:
                raise RuntimeError(f"chromium has not answered {method} for {patience} s")
            if message.get("id") == number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]

    def value(self, expression, patience=PATIENCE):
        answer = self.ask("Runtime.evaluate", patience, expression=expression, awaitPromise=True, returnByValue=True,
                          userGesture=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(answer["exceptionDetails"].get("exception", {}).get("description", "a script failed"))
        return answer["result"].get("value")

    def wait(self, seconds):
        until = time.monotonic() + seconds
        while (left := until - time.monotonic()) > 0:
            self.receive(left)

    def wait_for(self, expression, patience=PATIENCE):
        """Looks until the expression is true. Returns its last value, which is not true if patience ran out."""
        until = time.monotonic() + patience
        while not (found := self.value(expression)) and time.monotonic() < until:
            self.wait(0.05)
        return found

    # --- pages ------------------------------------------------------------------------------------------------

    def open(self, address):
        self.ask("Page.navigate", url="about:blank")
        self.events.clear()
        answer = self.ask("Page.navigate", url=address)
        if "errorText" in answer:
            raise RuntimeError(answer["errorText"])
        loaded = (answer["loaderId"], "load")
        while not any(event["method"] == "Page.lifecycleEvent" and
                      (event["params"]["loaderId"], event["params"]["name"]) == loaded for event in self.events):
            if self.receive() is None:
                raise RuntimeError(f"{address} has not loaded for {PATIENCE} s")

    def before_pages(self, script):
        """Runs a script in each page before the page's own; returns what ends that."""
        name = self.ask("Page.addScriptToEvaluateOnNewDocument", source=script)["identifier"]
        return lambda: self.ask("Page.removeScriptToEvaluateOnNewDocument", identifier=name)

    def requests(self):
        """What the page and its workers have asked for since it was opened."""
        return [event["params"]["request"]["url"] for event in self.events
                if event["method"] == "Network.requestWillBeSent"]

    def complaints(self):
        """What the browser had to complain about since the page was opened."""
        for event in self.events:
            data = event["params"]
            if event["method"] == "Runtime.exceptionThrown":
                details = data["exceptionDetails"]
                yield "error in a script: " + details.get("exception", {}).get("description", details["text"])
            elif event["method"] == "Runtime.consoleAPICalled" and data["type"] in ("error", "assert"):
                yield "error on the console: " + " ".join(str(item.get("value")) for item in data["args"])
            elif event["method"] == "Log.entryAdded" and data["entry"]["level"] == "error":
                yield "error: " + data["entry"]["text"] + " " + data["entry"].get("url", "")
        for address in self.requests():
            if address.startswith(("http", "ws")):
                yield "asks the network for " + address

    def resize(self, width, height, phone=False):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)
        self.ask("Emulation.setTouchEmulationEnabled", enabled=phone)

    def scheme(self, name):
        """Light or dark."""
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": name}])

    def picture(self, path):
        path.write_bytes(base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"]))

    # --- hands ------------------------------------------------------------------------------------------------

    def key(self, name, modifiers=0):
        code, number, text = KEYS[name] if name in KEYS else (
            ("Digit" if name.isdigit() else "Key") + name.upper(), ord(name.upper()), name)
        data = {"key": name, "code": code, "windowsVirtualKeyCode": number, "modifiers": modifiers}
        self.ask("Input.dispatchKeyEvent", type="keyDown" if text else "rawKeyDown", text=text, **data)
        self.ask("Input.dispatchKeyEvent", type="keyUp", **data)

    def type(self, text):
        self.ask("Input.insertText", text=text)

    def mouse(self, kind, x, y, **more):
        self.ask("Input.dispatchMouseEvent", type="mouse" + kind, x=x, y=y, **more)

    def click(self, x, y, button="left", modifiers=0):
        self.drag((x, y), button=button, modifiers=modifiers)

    def drag(self, *points, button="left", modifiers=0):
        """Presses at the first point and lets go at the last."""
        held = {"left": 1, "right": 2, "middle": 4}[button]
        self.mouse("Moved", *points[0])
        self.mouse("Pressed", *points[0], button=button, buttons=held, clickCount=1, modifiers=modifiers)
        for point in points[1:]:
            self.mouse("Moved", *point, button=button, buttons=held, modifiers=modifiers)
        self.mouse("Released", *points[-1], button=button, clickCount=1, modifiers=modifiers)

    def tap(self, x, y):
        self.ask("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def drop(self, paths, x, y):
        """Drags files over the page, as hands do not at one moment alone, and lets go of them."""
        data = {"items": [], "files": [str(path) for path in paths], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "dragOver", "dragOver", "drop"):
            self.ask("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)
            self.value("0")  # it has said whether it takes them
            self.wait(0.1)

    def choose(self, selector, paths):
        """Puts files into an input for them."""
        found = self.ask("Runtime.evaluate", expression=f"document.querySelector({json.dumps(selector)})")["result"]
        self.ask("DOM.setFileInputFiles", files=[str(path) for path in paths], objectId=found["objectId"])

    def downloads(self, folder):
        """From now on, files that the page saves go there."""
        self.ask("Page.setDownloadBehavior", behavior="allow", downloadPath=str(folder))
