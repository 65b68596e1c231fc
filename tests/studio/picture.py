"""picture.py PROGRAM FILE: FILE, a PNG, is the studio with the pipe tee, a question
and why, as docs/studio.png has it. It needs a browser."""
import os
import shutil
import sys
import tempfile
import time

sys.path[:0] = [os.path.dirname(os.path.abspath(__file__))]
from browser import Browser  # noqa: E402
from front import Front  # noqa: E402

program, out = map(os.path.abspath, sys.argv[1:3])
folder = tempfile.mkdtemp()
shutil.copy("facts/pipe_tee.pl", folder)
front = Front(program, folder, "pipe_tee.pl", (),
              dict(os.environ, XDG_STATE_HOME=folder))
browser = Browser(1440, 900, "en")
try:
    browser.open(front.address)
    browser.wait("studio.ready && studio.ports.ports.every(p => p.picture"
                 ".shown)", seconds=30)
    browser.script("document.querySelectorAll('.tree .row')[2].click()")
    browser.script("studio.asking.set('p(10, P, _Es), length(_Es, N), N > 60')"
                   "; studio.asking.ask()")
    browser.wait("studio.asking.answered")
    browser.script("studio.chosen(['s10e21'], studio.ports.ports[0])")
    browser.wait("document.querySelector('.why pre')")
    time.sleep(1)
    browser.script("document.activeElement.blur()")
    browser.picture(out)
finally:
    browser.end()
    front.process.kill()
    front.process.communicate()
    shutil.rmtree(folder)
