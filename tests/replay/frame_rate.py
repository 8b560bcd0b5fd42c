# SPDX-License-Identifier: BSL-1.0
"""Frames per second of the page, as fast as it can draw them, and the processor time that a frame
takes: python3 frame_rate.py PAGE... Headless Chromium draws with the processor alone."""

import os
import pathlib
import sys

import browser

MEASURE = """
const done = arguments[0];
const from = Math.max(firstOfShear, 0), seconds = 5;
let count = 0;
const begun = performance.now();
function next() {
  setFrame(from + count++ % (frameCount - from));
  draw();
  const now = performance.now();
  if (now - begun < 1000 * seconds) requestAnimationFrame(next);
  else done([frameState(show.frame).n, count, 1000 * count / (now - begun)]);
}
requestAnimationFrame(next);
"""



def processor_seconds(pid):
    """Of a process and all that came from it, on Linux."""
    parents, used = {}, {}
    for entry in os.listdir("/proc"):
        try:
            with open(f"/proc/{int(entry)}/stat") as file:
                fields = file.read().rsplit(")", 1)[1].split()
        except (ValueError, OSError):
            continue  # no process, or one that has ended
        parents[int(entry)] = int(fields[1])
        used[int(entry)] = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    family, grown = {pid}, True
    while grown:
        more = {child for child, parent in parents.items() if parent in family} - family
        family |= more
        grown = bool(more)
    return sum(used.get(member, 0) for member in family)


for page in sys.argv[1:]:
    for chains in (0, 1):
        with browser.Browser(1400, 900) as chromium:
            chromium.open(pathlib.Path(page).resolve().as_uri() + f"#chains={chains}")
            before = processor_seconds(chromium.driver.pid)
            particles, count, rate = chromium.wait_for(MEASURE)
            used = processor_seconds(chromium.driver.pid) - before
            print(f"{page}: {particles} particles, chains {'on' if chains else 'off'}: "
                  f"{rate:.1f} frames/s, {1000 * used / count:.0f} ms of processor time a frame")
