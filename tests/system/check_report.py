#!/usr/bin/env python3
"""check_report.py CHROMIUM PAGE...

Opens reports in a headless Chromium without network, by its debugging protocol, and fails if one
asks for anything from elsewhere, has an error in its console, a picture that is not drawn or cut
off, a slider that keys do not move, or does not fit on paper."""
import base64
import json
import os
import pathlib
import subprocess
import sys
import tempfile

KEYS = 7  # the arrow key is hit as often
A4_WIDTH = 794  # pixels

PICTURES = """[...document.images].map(i => [i.complete, i.naturalWidth, i.alt])"""
SLIDER = """(n => { const s = document.querySelectorAll('input[type=range]')[n];
  const over = s.parentNode.querySelector('.over.shown');
  return {value: Number(s.value), clip: getComputedStyle(over).clipPath}; })"""
CHECKERBOARD = """document.querySelector('input[value=checkerboard]').click();
  [...document.querySelectorAll('.over')].filter(i => getComputedStyle(i).display != 'none')
    .map(i => i.dataset.kind)"""
# What is drawn beyond the view box of a chart is cut off where the chart is made smaller.
CUT_OFF = """[...document.querySelectorAll('svg')].filter(s => { const b = s.getBBox(),
  v = s.viewBox.baseVal; return !v || !v.width || b.x < v.x - 1 || b.y < v.y - 1
    || b.x + b.width > v.x + v.width + 1 || b.y + b.height > v.y + v.height + 1; })
  .map(s => s.getAttribute('aria-label') || 'a chart')"""


class Browser:
    """Chromium, which reads messages from its descriptor 3 and writes to 4, each ended by a 0."""

    def __init__(self, program, profile):
        to_read, self.to = os.pipe()
        self.back, to_write = os.pipe()
        moved = [os.dup(to_read), os.dup(to_write)]  # so that neither is 3 or 4 itself

        def give():
            os.dup2(moved[0], 3)
            os.dup2(moved[1], 4)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe",
             f"--user-data-dir={profile}"],
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            close_fds=False, preexec_fn=give)
        for end in [to_read, to_write, *moved]:
            os.close(end)
        self.rest, self.number, self.events = b"", 0, []
        self.session = None

    def message(self):
        while b"\0" not in self.rest:
            part = os.read(self.back, 1 << 20)
            if not part:
                sys.exit("Chromium has ended.")
            self.rest += part
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def ask(self, method, **arguments):
        self.number += 1
        request = {"id": self.number, "method": method, "params": arguments}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.to, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == self.number:
                if "error" in answer:
                    sys.exit(f"{method}: {answer['error']['message']}")
                return answer["result"]
            self.events.append(answer)

    def wait(self, method):
        while all(event.get("method") != method for event in self.events):
            self.events.append(self.message())

    def value(self, script):
        result = self.ask("Runtime.evaluate", expression=script, returnByValue=True)
        if "exceptionDetails" in result:
            sys.exit(f"{script}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def open(self, page):
        self.session, self.events = None, []
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ["Page", "Runtime", "Log", "Network"]:
            self.ask(f"{domain}.enable")
        self.ask("Network.emulateNetworkConditions", offline=True, latency=0,
                 downloadThroughput=0, uploadThroughput=0)
        self.events = []
        self.ask("Page.navigate", url=pathlib.Path(page).absolute().as_uri())
        self.wait("Page.loadEventFired")


def complaints(events):
    """What was asked for from elsewhere, and what went wrong."""
    for event in events:
        method, what = event.get("method"), event.get("params", {})
        if method == "Network.requestWillBeSent":
            address = what["request"]["url"]
            if not address.startswith(("file:", "data:")):
                yield f"asks for {address}"
        elif method == "Runtime.exceptionThrown":
            yield f"script: {what['exceptionDetails']}"
        elif method == "Runtime.consoleAPICalled" and what["type"] in ("error", "warning"):
            yield f"console: {what['args']}"
        elif method == "Log.entryAdded" and what["entry"]["level"] in ("error", "warning"):
            yield f"log: {what['entry']['text']}"


def check(browser, page):
    browser.open(page)
    pictures = browser.value(PICTURES)
    assert len(pictures) >= 12, f"there are {len(pictures)} pictures"
    for complete, width, name in pictures:
        assert complete and width > 100, f"the picture '{name}' is not drawn"
    sliders = browser.value("document.querySelectorAll('input[type=range]').length")
    assert sliders == 3, f"there are {sliders} sliders"
    for n in range(sliders):
        before = browser.value(f"{SLIDER}({n})")
        browser.value(f"document.querySelectorAll('input[type=range]')[{n}].focus()")
        for _ in range(KEYS):
            for kind in ["rawKeyDown", "keyUp"]:
                browser.ask("Input.dispatchKeyEvent", type=kind, key="ArrowRight",
                            code="ArrowRight", windowsVirtualKeyCode=39)
        after = browser.value(f"{SLIDER}({n})")
        assert after["value"] == before["value"] + KEYS, f"keys move slider {n} to {after}"
        assert after["clip"] != before["clip"], f"slider {n} moves no picture"
    shown = browser.value(CHECKERBOARD)
    assert shown == ["checkerboard"] * 3, f"chosen is the checkerboard, seen are {shown}"
    cut_off = browser.value(CUT_OFF)
    assert not cut_off, f"cut off are {cut_off}"
    browser.ask("Emulation.setEmulatedMedia", media="print")
    browser.ask("Emulation.setDeviceMetricsOverride", width=A4_WIDTH, height=1123,
                deviceScaleFactor=1, mobile=False)
    width = browser.value("document.documentElement.scrollWidth")
    assert width <= A4_WIDTH, f"it is {width} pixels wide on paper"
    paper = base64.b64decode(browser.ask("Page.printToPDF", printBackground=True)["data"])
    assert paper.startswith(b"%PDF") and len(paper) > 100000, f"{len(paper)} bytes are printed"
    wrong = list(complaints(browser.events))
    assert not wrong, "; ".join(wrong)
    return len(pictures)


def main():
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = Browser(sys.argv[1], profile)
        try:
            for page in sys.argv[2:]:
                try:
                    print(f"{page}: {check(browser, page)} pictures, all as they should be.")
                except AssertionError as error:
                    sys.exit(f"{page}: {error}.")
        finally:
            browser.process.kill()
            browser.process.wait()


main()
