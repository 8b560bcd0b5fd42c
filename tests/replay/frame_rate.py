# SPDX-License-Identifier: BSL-1.0
"""Frames per second of the page, as fast as it can draw them: python3 frame_rate.py PAGE...
Headless Chromium draws with the processor alone."""

import pathlib
import sys

import browser

MEASURE = """
const done = arguments[0];
const from = Math.max(firstOfShear, 0), seconds = 5;
let count = 0, spent = 0;
const begun = performance.now();
function next() {
  setFrame(from + count % (frameCount - from));
  const start = performance.now();
  draw();
  context.getImageData(0, 0, 1, 1); // waits until it is drawn
  spent += performance.now() - start;
  ++count;
  if (performance.now() - begun < 1000 * seconds) requestAnimationFrame(next);
  else done([frameState(show.frame).n, count / (performance.now() - begun) * 1000, spent / count]);
}
requestAnimationFrame(next);
"""

for page in sys.argv[1:]:
    for chains in (0, 1):
        with browser.Browser(1400, 900) as chromium:
            chromium.open(pathlib.Path(page).resolve().as_uri() + f"#chains={chains}")
            particles, rate, milliseconds = chromium.wait_for(MEASURE)
            print(f"{page}: {particles} particles, chains {'on' if chains else 'off'}: "
                  f"{rate:.1f} frames/s, {milliseconds:.1f} ms to draw one")
