"""A real browser for tests, by WebDriver: Browser().open(address), script(...),
click, keys, picture."""
import base64
import http.client
import json
import shutil
import subprocess
import time

ELEMENT = "element-6066-11e4-a52e-4f735466cecf"


def there():
    return shutil.which("chromedriver") and shutil.which("chromium")


class Browser:
    def __init__(self, width=1440, height=900, language="en", arguments=(),
                 mobile=False):
        self.driver = subprocess.Popen(
            ["chromedriver", "--port=0"], stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL)
        self.port = None
        for line in self.driver.stdout:
            if b"started successfully on port" in line:
                self.port = int(line.split()[-1].rstrip(b"."))
                break
        options = {"binary": shutil.which("chromium"), "args": [
            "--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
            "--disable-gpu", "--no-first-run", "--disable-extensions",
            "--force-device-scale-factor=1", "--lang=" + language,
            "--window-size=%d,%d" % (width, height), *arguments],
            "prefs": {"intl.accept_languages": language}}
        if mobile:
            options["mobileEmulation"] = {"deviceMetrics": {
                "width": width, "height": height, "pixelRatio": 2}}
        made = self.do("POST", "/session", {"capabilities": {"alwaysMatch": {
            "browserName": "chrome", "goog:chromeOptions": options,
            "goog:loggingPrefs": {"browser": "ALL"}}}})
        self.session = "/session/" + made["sessionId"]
        if not mobile:
            self.size(width, height)

    def do(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port,
                                                timeout=60)
        connection.request(method, path, None if body is None
                           else json.dumps(body),
                           {"Content-Type": "application/json"})
        value = json.loads(connection.getresponse().read())["value"]
        connection.close()
        if isinstance(value, dict) and "error" in value:
            raise RuntimeError("%s: %s" % (value["error"],
                                           value["message"][:400]))
        return value

    def ask(self, method, path, body=None):
        return self.do(method, self.session + path, body)

    def size(self, width, height):
        """Of the page, not of the window."""
        for _ in range(2):
            inner = self.script("return [innerWidth, innerHeight]")
            outer = self.ask("GET", "/window/rect")
            self.ask("POST", "/window/rect", {
                "width": outer["width"] + width - inner[0],
                "height": outer["height"] + height - inner[1]})

    def open(self, address):
        self.ask("POST", "/url", {"url": address})

    def script(self, text, *given):
        return self.ask("POST", "/execute/sync",
                        {"script": text, "args": list(given)})

    def wait(self, text, *given, seconds=60):
        """Until the expression is true; what it is then, or None."""
        end = time.time() + seconds
        while time.time() < end:
            try:
                found = self.script("return (%s)" % text, *given)
                if found:
                    return found
            except RuntimeError:
                pass
            time.sleep(0.03)
        return None

    def element(self, css):
        return self.ask("POST", "/element", {"using": "css selector",
                                             "value": css})[ELEMENT]

    def click(self, css):
        self.ask("POST", "/element/%s/click" % self.element(css), {})

    def keys(self, text, css=None):
        if css:
            self.ask("POST", "/element/%s/value" % self.element(css),
                     {"text": text})
        else:
            actions = []
            for key in text:
                actions += [{"type": "keyDown", "value": key},
                            {"type": "keyUp", "value": key}]
            self.ask("POST", "/actions", {"actions": [
                {"type": "key", "id": "keys", "actions": actions}]})

    def chord(self, *keys):
        actions = [{"type": "keyDown", "value": key} for key in keys] + [
            {"type": "keyUp", "value": key} for key in reversed(keys)]
        self.ask("POST", "/actions", {"actions": [
            {"type": "key", "id": "keys", "actions": actions}]})

    def pointer(self, *steps):
        """Steps: (x, y) moves there, "down" and "up" press and release."""
        actions = []
        for step in steps:
            if step == "down":
                actions.append({"type": "pointerDown", "button": 0})
            elif step == "up":
                actions.append({"type": "pointerUp", "button": 0})
            else:
                actions.append({"type": "pointerMove", "duration": 0,
                                "x": round(step[0]), "y": round(step[1])})
        self.ask("POST", "/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "actions": actions,
             "parameters": {"pointerType": "mouse"}}]})

    def touch(self, x, y, seconds=0):
        """A finger that stays so long."""
        self.ask("POST", "/actions", {"actions": [
            {"type": "pointer", "id": "finger",
             "parameters": {"pointerType": "touch"}, "actions": [
                 {"type": "pointerMove", "duration": 0, "x": round(x),
                  "y": round(y)},
                 {"type": "pointerDown", "button": 0},
                 {"type": "pause", "duration": round(1000 * seconds)},
                 {"type": "pointerUp", "button": 0}]}]})

    def picture(self, path):
        with open(path, "wb") as out:
            out.write(base64.b64decode(self.ask("GET", "/screenshot")))

    def tool(self, command, **given):
        """As the developer tools do: Page.setBypassCSP, ..."""
        self.ask("POST", "/goog/cdp/execute", {"cmd": command, "params": given})

    def emulate(self, command, **given):
        self.tool("Emulation." + command, **given)

    def media(self, **features):
        self.emulate("setEmulatedMedia", features=[
            {"name": name.replace("_", "-"), "value": value}
            for name, value in features.items()])

    def log(self):
        """What the page complained of."""
        return [entry["message"] for entry in
                self.ask("POST", "/se/log", {"type": "browser"})]

    def end(self):
        try:
            self.ask("DELETE", "")
        finally:
            self.driver.terminate()
            self.driver.wait()
            self.driver.stdout.close()
