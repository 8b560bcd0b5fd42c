# SPDX-License-Identifier: BSL-1.0
"""A page in headless Chromium, driven through ChromeDriver's HTTP interface (W3C WebDriver).
Needs nothing but Python's own library."""

import base64
import json
import shutil
import subprocess
import tempfile
import urllib.error
import urllib.request

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
DRIVER = shutil.which("chromedriver")
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # the key of an element, by the standard

# Keys that have no character.
KEYS = {"Home": "\ue011", "End": "\ue010", "Left": "\ue012", "Right": "\ue014", "Up": "\ue013",
        "Down": "\ue015", "Escape": "\ue00c"}


def missing():
    """What is not there; empty if the browser can be started."""
    return [name for name, path in (("chromium", CHROMIUM), ("chromedriver", DRIVER)) if not path]


class Browser:
    def __init__(self, width=1400, height=900):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.driver = subprocess.Popen([DRIVER, "--port=0"], stdout=subprocess.PIPE, text=True,
                                       stderr=subprocess.DEVNULL)
        self.session = None
        try:
            self.address = f"http://127.0.0.1:{self._port()}"
            options = {"binary": CHROMIUM,
                       "args": ["--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                                "--hide-scrollbars", "--force-device-scale-factor=1",
                                f"--window-size={width},{height}",
                                f"--user-data-dir={self.profile.name}"]}
            answer = self._send("POST", "/session", {"capabilities": {"alwaysMatch": {
                "goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"},
                "timeouts": {"script": 120000, "pageLoad": 120000}}}})
            self.session = f"/session/{answer['sessionId']}"
            self._resize(width, height)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        try:
            if self.session:
                self._send("DELETE", self.session)
        except OSError:
            pass  # the browser has gone already
        self.driver.terminate()
        self.driver.wait(10)
        self.profile.cleanup()

    def open(self, address):
        self._send("POST", f"{self.session}/url", {"url": address})

    def run(self, script, *arguments):
        """The value of a JavaScript function body."""
        return self._send("POST", f"{self.session}/execute/sync", {"script": script, "args": arguments})

    def wait_for(self, script):
        """The value of a script that calls its last argument when it is done."""
        return self._send("POST", f"{self.session}/execute/async", {"script": script, "args": []})

    def press(self, *keys):
        actions = []
        for key in keys:
            value = KEYS.get(key, key)
            actions += [{"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}]
        self._act({"type": "key", "id": "keyboard", "actions": actions})

    def click(self, x, y):
        self.drag([(x, y)])

    def drag(self, points):
        """Presses the button at the first point and releases it at the last."""
        moves = [{"type": "pointerMove", "duration": 30, "x": round(x), "y": round(y)} for x, y in points]
        self._act({"type": "pointer", "id": "mouse", "actions":
                   [moves[0], {"type": "pointerDown", "button": 0}, *moves[1:],
                    {"type": "pointerUp", "button": 0}]})

    def wheel(self, x, y, by):
        self._act({"type": "wheel", "id": "wheel", "actions": [
            {"type": "scroll", "x": round(x), "y": round(y), "deltaX": 0, "deltaY": by, "duration": 0}]})

    def click_element(self, selector):
        found = self._send("POST", f"{self.session}/element", {"using": "css selector", "value": selector})
        self._send("POST", f"{self.session}/element/{found[ELEMENT]}/click", {})

    def screenshot(self):
        """PNG."""
        return base64.b64decode(self._send("GET", f"{self.session}/screenshot"))

    def errors(self):
        """What the console has of errors and warnings since the last call."""
        entries = self._send("POST", f"{self.session}/se/log", {"type": "browser"})
        return [e["message"] for e in entries if e["level"] in ("SEVERE", "WARNING")]

    def _port(self):
        # "ChromeDriver was started successfully on port 12345."
        for line in self.driver.stdout:
            if "successfully on port" in line:
                return int(line.split("port")[1].strip(" .\n"))
        raise RuntimeError("chromedriver did not start")

    def _resize(self, width, height):
        # The window has a frame: the page is to have this size.
        inner = self.run("return [window.innerWidth, window.innerHeight]")
        self._send("POST", f"{self.session}/window/rect",
                   {"width": 2 * width - inner[0], "height": 2 * height - inner[1]})

    def _act(self, source):
        self._send("POST", f"{self.session}/actions", {"actions": [source]})
        self.wait_for("const done = arguments[0]; requestAnimationFrame(() => requestAnimationFrame(done))")

    def _send(self, method, path, body=None):
        data = None if body is None and method != "POST" else json.dumps(body or {}).encode()
        request = urllib.request.Request(self.address + path, data, {"Content-Type": "application/json"},
                                         method=method)
        try:
            with urllib.request.urlopen(request, timeout=180) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            value = json.load(error).get("value", {})
            raise RuntimeError(f"{path}: {value.get('error')}: {value.get('message')}") from None
