# SPDX-License-Identifier: BSL-1.0
"""The page of a replay in headless Chromium: python3 page_test.py PAGE [PICTURE].
The exit code is 77, which CTest takes for skipped, where there is no Chromium or no ChromeDriver."""

import hashlib
import pathlib
import sys

import browser

checks = 0


def check(holds, what):
    global checks
    checks += 1
    if not holds:
        sys.exit(f"page_test: failed: {what}")


class Page:
    """What the tests ask of the page; the names are those of its program."""

    def __init__(self, chromium):
        self.chromium = chromium

    def value(self, expression):
        return self.chromium.run(f"return {expression}")

    def frame(self):
        return self.value("show.frame")

    def picture(self):
        """A digest of the pixels of the sample, drawn anew."""
        data = self.value("(stale.view = true, draw(), view.canvas.toDataURL())")
        return hashlib.sha256(data.encode()).hexdigest()

    def place(self, element, x=0.5, y=0.5):
        """A point of the window: shares of the width and the height of an element."""
        left, top, width, height = self.value(
            f"(({{x, y, width, height}}) => [x, y, width, height])"
            f"(document.querySelector('{element}').getBoundingClientRect())")
        return left + x * width, top + y * height

    def place_of_particle(self, condition):
        """Of the first particle at this frame that fulfils a condition of k and s, and its id."""
        return self.value(
            "(() => { const s = frameState(show.frame), box = view.canvas.getBoundingClientRect();"
            f"for (let k = 0; k < s.n; ++k) if ({condition}) {{ const [x, y] = toScreen(s.x[k], s.y[k]);"
            "return [s.ids[k], box.x + x, box.y + y]; } return null; })()")


def test_opens(page):
    check(page.value("frameCount") > 50, "frames are there")
    check(page.value("document.querySelectorAll('script[src], link[rel=stylesheet], img').length") == 0,
          "nothing is loaded")
    check(page.frame() == page.value("firstOfShear"), "it opens at the start of shear")
    colours = page.value("new Set(context.getImageData(0, 0, view.canvas.width, view.canvas.height)"
                         ".data.filter((_, k) => k % 4 === 0)).size")
    check(colours > 10, "the sample is drawn")
    # After the first readings Chromium draws the canvas by other means, with other round-off.
    for _ in range(5):
        page.picture()
    check(page.picture() == page.picture(), "the same state gives the same picture")


def test_slider(page):
    before = page.picture()
    page.chromium.click(*page.place("#slider", 0.9))
    check(page.frame() > 0.8 * page.value("frameCount"), "a click on the slider goes there")
    check(page.picture() != before, "the slider moves the sample")
    check(page.value("document.getElementById('slider').getAttribute('aria-valuetext')")
          .startswith("frame"), "the slider says what it shows")


def test_keys(page):
    press = page.chromium.press
    press("Home")
    check(page.frame() == 0, "Home")
    press("Right")
    check(page.frame() == 1, "right")
    press("Right", "Left", "Left")
    check(page.frame() == 0, "left")
    press("End")
    check(page.frame() == page.value("frameCount") - 1, "End")
    scale = page.value("view.camera.scale")
    press("+")
    check(abs(page.value("view.camera.scale") / scale - 1.25) < 1e-9, "+")
    press("-", "f")
    check(abs(page.value("view.camera.scale") / scale - 1) < 0.2, "fit")
    speed = page.value("show.speed")
    press("Up")
    check(page.value("show.speed") > speed, "up is faster")
    press("Down")
    check(page.value("show.speed") == speed, "down is slower")
    press("?")
    check(page.value("document.getElementById('help').open"), "? opens the help")
    press("Escape")
    check(not page.value("document.getElementById('help').open"), "Escape closes it")


def test_colours(page):
    pictures = {page.picture()}
    modes = page.value("colourModes.length")
    for n in range(1, modes):
        page.chromium.press("c")
        check(page.value("show.mode") == n, "c is the next colour")
        check(page.value("document.getElementById('legend').textContent").startswith(
            page.value(f"colourModes[{n}].title")), "the legend follows")
        pictures.add(page.picture())
    check(len(pictures) == modes, "each colour looks different")
    page.chromium.press("c")
    before = page.picture()
    page.chromium.press("g")
    check(page.picture() != before, "force chains are drawn")
    all_chains = page.picture()
    page.chromium.press("s")
    check(page.picture() not in (before, all_chains), "those of the strong network are fewer")
    check("above the mean" in page.value("document.getElementById('legend').textContent"), "as the legend says")
    page.chromium.press("s")
    check(page.picture() == all_chains, "and all come back")
    page.chromium.press("g")
    check(page.picture() == before, "and go")
    page.chromium.press("s")
    check(page.value("show.chains"), "the strong network alone is drawn without force chains before")
    page.chromium.press("s", "g")
    check(page.picture() == before, "and goes")
    page.chromium.press("t")
    check(page.picture() != before, "dark")
    page.chromium.press("t")
    check(page.picture() == before, "and light again")


def test_play(page):
    page.chromium.press("Home", " ")
    page.chromium.wait_for("setTimeout(arguments[0], 700)")
    check(page.value("show.playing"), "it plays")
    # 20 frames a second.
    check(3 <= page.frame() <= 40, f"at about its speed: {page.frame()} frames in 0.7 s")
    page.chromium.press(" ")
    check(not page.value("show.playing"), "it pauses")


def test_pointer(page):
    page.chromium.press("f")
    x, y = page.place("#view")
    camera = page.value("view.camera.x")
    page.chromium.drag([(x, y), (x + 40, y + 10), (x + 80, y + 20)])
    moved = (camera - page.value("view.camera.x")) * page.value("view.camera.scale")
    check(abs(moved - 80) < 1, "a drag moves the sample along")
    check(page.value("show.selected") == -1, "and selects nothing")
    here = page.value("toWorld(100, 100)")
    corner = page.place("#view", 0, 0)
    scale = page.value("view.camera.scale")
    page.chromium.wheel(corner[0] + 100, corner[1] + 100, -300)
    check(page.value("view.camera.scale") > 1.3 * scale, "the wheel zooms")
    there = page.value("toWorld(100, 100)")
    # To the pixel: the pointer is at whole ones, the sample is not.
    check(all(abs(a - b) * scale < 1 for a, b in zip(here, there)), "about the pointer")
    page.chromium.press("f")


def test_particle(page):
    page.chromium.press("End", "f")
    found = page.place_of_particle("arrays.motion[s.ids[k]] === 0 && arrays.generation[s.ids[k]] > 0 && "
                                   "arrays.area[s.ids[k]] > 0.5 * Math.max(...arrays.area.slice(60))")
    found = found or page.place_of_particle("arrays.generation[s.ids[k]] > 0")
    check(found is not None, "there is a piece")
    identity, x, y = found
    page.chromium.click(x, y)
    check(page.value("show.selected") == identity, "a click selects the particle under it")
    text = page.value("document.getElementById('particle').textContent")
    for part in (f"Particle {identity}", "Parent", "Area", "Speed", "Rat", "Contacts",
                 "It came from the break of", "elements failed"):
        check(part in text, f"its panel has '{part}'")
    inked = page.value("(() => { const c = document.querySelector('#born canvas');"
                       "return c.getContext('2d').getImageData(0, 0, c.width, c.height).data"
                       ".filter((v, k) => k % 4 === 3 && v > 0).length; })()")
    check(inked > 2000, "its mesh is drawn")
    page.chromium.click_element("#born button[data-break]")
    parent = page.value(f"arrays.parent[{identity}]")
    check(page.value("show.selected") == parent, "'go there' selects the particle that broke")
    check(page.frame() == page.value(f"breakOf.get({parent}).frame"), "before its break")
    page.chromium.press("Escape")
    check(page.value("show.selected") == -1, "Escape selects nothing")


def test_breaks(page):
    page.chromium.click_element("#tab-breaks")
    count = page.value("run.breaks.length")
    check(page.value("document.querySelectorAll('#breaks tbody tr').length") == count, "all are listed")
    n = count // 2
    page.chromium.click_element(f"#breaks tr[data-break='{n}'] button")
    broken = page.value(f"run.breaks[{n}].id")
    check(page.frame() == page.value(f"run.breaks[{n}].frame"), "a click on a break jumps to it")
    check(page.value("show.selected") == broken, "and selects the particle")
    check(page.value(f"isPresent({broken}, show.frame)"), "which is whole")
    dx, dy = page.value(f"[view.camera.x - run.breaks[{n}].pose[0], view.camera.y - run.breaks[{n}].pose[1]]")
    check(abs(dx) < 1e-9 and abs(dy) < 1e-9, "in the middle")
    ends = page.value(f"crackOf(run.breaks[{n}]).length")
    check(ends == 2, "its line crosses it")
    page.chromium.press("n")
    check(page.value("show.currentBreak") == n + 1, "n is the next break")
    page.chromium.press("p")
    check(page.value("show.currentBreak") == n, "p the one before")
    page.chromium.press("Escape", "f")


def test_curves(page):
    page.chromium.click(*page.place("#chart-0", 0.5))
    middle = page.frame()
    first, last = page.value("firstOfShear"), page.value("frameCount") - 1
    check(first + 0.3 * (last - first) < middle < first + 0.7 * (last - first), "a click on a curve goes there")
    page.chromium.drag([page.place("#chart-1", 0.5), page.place("#chart-1", 0.7), page.place("#chart-1", 0.85)])
    check(page.frame() > middle, "a drag as well")
    page.chromium.click_element("#axis-all")
    page.chromium.click(*page.place("#chart-0", 0.15))
    check(page.frame() < first, "with all stages, to a frame before shear")
    page.chromium.click_element("#axis-shear")


def test_numbers(page):
    """What the page unpacks adds up: the area that contacts carry as stress."""
    page.chromium.press("End")
    # sigma_11 + sigma_22 = sum of f . l / (A t); along a contact f . l is about the normal force
    # times the distance of the centroids, for the normals of sharp polygons within some per cent.
    ratio = page.value(
        "(() => { const s = frameState(show.frame); let sum = 0;"
        "for (let i = 0; i < s.contacts; ++i) { const a = s.a(i), b = s.b(i);"
        "sum += s.normal(i) * Math.hypot(s.x[a] - s.x[b], s.y[a] - s.y[b]); }"
        "let area = 0; for (let k = 0; k < s.n; ++k) area += arrays.area[s.ids[k]];"
        "const [s11, s22] = s.frame.stress; return sum / (area / 0.85 * run.thickness * (s11 + s22)); })()")
    # The sample fills 0.8 to 0.9 of its area, and normals are off the branches by up to 30 degrees.
    check(0.7 < ratio < 1.5, f"forces and stress agree: {ratio}")
    mean = page.value("(() => { const s = frameState(show.frame); let sum = 0, n = 0;"
                      "for (let i = 0; i < s.contacts; ++i) if (s.normal(i) > 0) { sum += s.normal(i); ++n; }"
                      "return sum / n / s.frame.meanForce; })()")
    # Forces are rounded to a 65,535th of the largest; those that become 0 are not counted here.
    check(abs(mean - 1) < 0.02, f"the mean force is that of the contacts: {mean}")
    # Over all frames: free particles with one loaded contact at most, not counting other rattlers, are
    # rattlers. Small forces beside the largest one are rounded to nothing here, rarely.
    wrong, rattlers, free = page.value(
        "(() => { let wrong = 0, rattlers = 0, free = 0;"
        "for (let f = firstOfShear; f < frameCount; ++f) {"
        "  const s = makeState(f), loaded = new Uint16Array(s.n);"
        "  for (let i = 0; i < s.contacts; ++i) { const a = s.a(i), b = s.b(i);"
        "    if (s.normal(i) > 0 && !s.rattler(b)) ++loaded[a];"
        "    if (s.normal(i) > 0 && !s.rattler(a)) ++loaded[b]; }"
        "  for (let k = 0; k < s.n; ++k) if (arrays.motion[s.ids[k]] === 0) {"
        "    ++free; rattlers += s.rattler(k); wrong += (loaded[k] < 2) !== (s.rattler(k) === 1); } }"
        "return [wrong, rattlers, free]; })()")
    check(0 < rattlers < 0.5 * free, f"some particles carry no load: {rattlers} of {free}")
    check(wrong <= 0.002 * free, f"which are those with fewer than two loaded contacts: {wrong} wrong")
    # The sample has eps_1 - eps_2, which is twice the axial strain less the volumetric one; the mean of
    # the local one, never below zero, is somewhat larger, and at the edge there is none.
    strain = page.value("(() => { const s = frameState(show.frame); let sum = 0, area = 0;"
                        "for (let k = 0; k < s.n; ++k) if (arrays.motion[s.ids[k]] === 0) {"
                        "  const a = arrays.area[s.ids[k]]; sum += a * s.strain(k); area += a; }"
                        "return sum / area / (2 * s.frame.strain - s.frame.volumetric); })()")
    check(0.8 < strain < 1.6, f"local strain is about that of the sample: {strain}")
    check(page.value("frameState(firstOfShear).strain(70)") == 0, "and begins with shear")


def test_small_window(page):
    narrow = page.chromium.run("return document.documentElement.scrollWidth <= window.innerWidth")
    check(narrow, "nothing is cut off at the side")


def main():
    absent = browser.missing()
    if absent:
        print(f"page_test: skipped, for there is no {' and no '.join(absent)}")
        sys.exit(77)
    address = pathlib.Path(sys.argv[1]).resolve().as_uri()
    for width, height, tests in ((1400, 900, (test_opens, test_slider, test_keys, test_colours, test_play,
                                              test_pointer, test_particle, test_breaks, test_curves,
                                              test_numbers)),
                                 (420, 760, (test_opens, test_small_window))):
        with browser.Browser(width, height) as chromium:
            chromium.open(address)
            for test in tests:
                test(Page(chromium))
            if len(sys.argv) > 2:
                pathlib.Path(sys.argv[2].replace(".png", f"_{width}.png")).write_bytes(chromium.screenshot())
            errors = chromium.errors()
            check(not errors, f"no error in the console: {errors}")
    print(f"page_test: {checks} checks passed")


if __name__ == "__main__":
    main()
