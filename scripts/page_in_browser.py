"""Opens report.html of result folders in a headless Chromium and uses it as a reader would.

usage: page_in_browser.py [--pictures FOLDER] RESULT...

Fails with a sentence at the first thing that is not as it must be. Prints size and time to the first picture.
"""

import argparse
import json
import pathlib
import shutil
import subprocess
import sys

from playwright.sync_api import sync_playwright

# WebGL2 by software where there is no graphics card
OPTIONS = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--no-sandbox"]
LARGEST = 5_000_000

# Pixels by part colour: the shading scales a colour, so that its proportions stay.
COUNT = """(canvas) => {
  const gl = canvas.getContext("webgl2");
  const [w, h] = [canvas.width, canvas.height];
  const pixels = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const scene = JSON.parse(document.getElementById("scene").textContent);
  const unit = (c) => { const l = Math.hypot(...c) || 1; return c.map((x) => x / l); };
  const counts = scene.parts.map((p) => {
    const want = unit(p.colour);
    let [count, x, y] = [0, 0, 0];
    for (let i = 0; i < pixels.length; i += 4) {
      const c = [pixels[i], pixels[i + 1], pixels[i + 2]];
      if (Math.max(...c) < 60 || Math.min(...c) > 250) continue;
      const u = unit(c);
      if (Math.hypot(u[0] - want[0], u[1] - want[1], u[2] - want[2]) > 0.012) continue;
      count++;
      const k = i / 4;
      // a place well inside: its neighbours have the colour too
      if (count === 40) [x, y] = [k % w, Math.floor(k / w)];
    }
    return { name: p.name, group: p.group, count, x: x / w, y: 1 - y / h };
  });
  let sum = 0;
  for (let i = 0; i < pixels.length; i++) sum = (sum * 31 + pixels[i]) % 4294967291;
  return { counts, sum, corner: [...pixels.slice(0, 3)] };
}"""


def fail(what):
    print(f"page: {what}", file=sys.stderr)
    sys.exit(1)


class Page:
    """A page that is open, with everything that went wrong in it."""

    def __init__(self, browser, path, **options):
        self.context = browser.new_context(viewport={"width": 1300, "height": 1000}, **options)
        self.context.set_offline(True)
        self.faults = []
        self.page = self.context.new_page()
        self.page.on("console", lambda m: self.faults.append(f"console {m.type}: {m.text}"))
        self.page.on("pageerror", lambda e: self.faults.append(f"error: {e}"))
        self.page.on("request", self.request)
        self.page.goto(path.resolve().as_uri())

    def request(self, request):
        if not request.url.startswith(("file:", "data:")):
            self.faults.append(f"request to {request.url}")

    def has(self, name):
        return self.page.locator(f'[data-is="{name}"]')

    def settle(self):
        self.page.evaluate("() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def look(self):
        self.settle()
        return self.has("canvas").evaluate(COUNT)

    def end(self):
        if self.faults:
            fail("; ".join(self.faults))
        self.context.close()


def check_view(browser, folder, result, pictures):
    path = folder / "report.html"
    page = Page(browser, path)
    canvas = page.has("canvas")
    page.page.wait_for_function("() => document.querySelector('canvas').dataset.drawn")
    drawn = canvas.get_attribute("data-drawn")
    if pictures:
        page.page.locator("#view").screenshot(path=pictures / f"{folder.name}_view.png")
    fields = page.has("field").locator("option").all_text_contents()
    if len(fields) < 3:
        fail(f"{path}: only the fields {fields}")
    for i in range(1, len(fields)):
        page.has("field").select_option(index=i)
        page.look()
        if pictures:
            canvas.screenshot(path=pictures / f"{folder.name}_field{i}.png")

    # every part in its colour, once they stand apart
    page.has("field").select_option("-1")
    closed = page.look()
    page.has("explode").fill("0.7")
    apart = page.look()
    missing = [c["name"] for c in apart["counts"] if c["count"] < 40]
    if missing or apart["sum"] == closed["sum"]:
        fail(f"{path}: no pixel in the colours of {missing}, or parts that do not move apart")

    # a click on a bolt shows its force
    page.has("only-bolts").click()
    shown = page.look()
    wrong = [c["name"] for c in shown["counts"] if c["group"] != "BOLT" and c["count"] > 0]
    if wrong:
        fail(f"{path}: hidden parts are still drawn: {wrong}")
    bolt = next(c for c in shown["counts"] if c["group"] == "BOLT")
    box = canvas.bounding_box()
    page.page.mouse.click(box["x"] + bolt["x"] * box["width"], box["y"] + bolt["y"] * box["height"])
    about = page.has("about").inner_text()
    forces = {
        b["bolt"]: b["tension"]
        for c in result["cases"] for b in c.get("static_forces", {}).get("bolts", [])
    }
    name = about.split("\n")[0]
    if name not in forces or f"{forces[name] / 1e3:.1f} kN" not in about:
        fail(f"{path}: a click on a bolt shows `{about}`, its forces are {forces}")

    # section, motion, keys
    page.has("show-all").click()
    page.has("explode").fill("0")
    before = page.look()
    page.has("axis").select_option("0")
    cut = page.look()
    if pictures:
        page.page.locator("#view").screenshot(path=pictures / f"{folder.name}_cut.png")
    canvas.focus()
    page.page.keyboard.press("ArrowLeft")
    turned = page.look()
    if len({before["sum"], cut["sum"], turned["sum"]}) != 3:
        fail(f"{path}: the section or the arrow keys change nothing")
    moving = [i for i, f in enumerate(fields) if "mechanism" in f or "displacement" in f]
    if moving:
        page.has("field").select_option(index=moving[0])
        page.has("animate").click()
        sums = set()
        for _ in range(4):
            page.page.wait_for_timeout(150)
            sums.add(page.look()["sum"])
        page.has("animate").click()
        if len(sums) < 3:
            fail(f"{path}: the mechanism does not move")

    # every control has a name that a screen reader speaks
    unnamed = page.page.evaluate(
        "() => [...document.querySelectorAll('input, select, button, img')].filter((e) =>"
        " !(e.labels && e.labels.length) && !e.getAttribute('aria-label') && !e.textContent.trim()"
        " && !e.alt).map((e) => e.outerHTML.slice(0, 80))"
    )
    if unnamed:
        fail(f"{path}: without a name: {unnamed}")

    page.page.emulate_media(color_scheme="dark")
    dark = page.look()
    if max(dark["corner"]) > 80:
        fail(f"{path}: the picture is not dark in dark mode: {dark['corner']}")
    if pictures:
        page.page.evaluate("() => scrollTo(0, 0)")
        page.page.screenshot(path=pictures / f"{folder.name}_dark.png")
    page.page.emulate_media(color_scheme="light")
    page.end()
    return drawn


def shown(used):
    """A utilisation as reports print it: two decimals, more where two would cross 1."""
    side = lambda x: 0 if abs(x - 1) <= 1e-9 else (1 if x > 1 else -1)
    if abs(used - 1) > 0.1:
        return f"{used:.2f}"
    texts = (f"{used:.{decimals}f}" for decimals in range(2, 11))
    return next((t for t in texts if side(float(t)) == side(used)), str(used))


def check_print(browser, folder, result, target):
    page = Page(browser, folder / "report.html")
    page.page.locator("summary").first.click()
    page.page.pdf(path=target, prefer_css_page_size=True)
    page.end()
    text = subprocess.run(["pdftotext", "-layout", target, "-"], capture_output=True, text=True, check=True).stdout
    words = " ".join(text.split())
    verdict = {"ok": "OK", "not_ok": "NOT OK", "undecided": "UNDECIDED"}.get(result["verdict"], "none")
    used = {shown(c["utilisation"]) for c in result["checks"] if c.get("utilisation")}
    lost = [w for w in {verdict, "Input file as given", *used} if w not in words]
    if lost:
        fail(f"{folder}: the print lacks {lost}")


def check_without(browser, folder):
    """Without a script the pictures stay, and the page says why there is no view."""
    page = Page(browser, folder / "report.html", java_script_enabled=False)
    if page.page.locator("figure img").count() == 0 or page.has("canvas").is_visible():
        fail(f"{folder}: nothing is to be seen without a script")
    if "needs JavaScript" not in page.page.locator("#view").inner_text():
        fail(f"{folder}: the page does not say what it needs")
    page.end()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--pictures", type=pathlib.Path)
    parser.add_argument("results", nargs="+", type=pathlib.Path)
    args = parser.parse_args()
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if not chromium:
        fail("no Chromium: scripts/setup.sh --test installs it")
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=chromium, args=OPTIONS)
        for folder in args.results:
            size = (folder / "report.html").stat().st_size
            if size > LARGEST:
                fail(f"{folder}: report.html has {size} bytes, more than {LARGEST}")
            result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
            drawn = check_view(browser, folder, result, args.pictures)
            check_print(browser, folder, result, folder / "printed_page.pdf.part")
            (folder / "printed_page.pdf.part").unlink()
            check_without(browser, folder)
            print(f"page: {folder}: {size / 1e6:.1f} MB, first picture after {drawn} ms, as it must be")
        browser.close()


main()
