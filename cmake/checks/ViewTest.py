"""Tests of the viewer as its user sees it: ViewTest.py VIEW VIEW_PICTURE PROJECT BUILD CLAIM

The real window on an X server of its own (Xvfb), driven by real events (xdotool). Where to click, and what came of it, is read from
the file that `view --trace` writes.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

view, view_picture, project, build, claim = sys.argv[1:]
WAIT = 600.0  # seconds: only a machine that does not get on at all takes as long
source = pathlib.Path(build) / "view-test" / "ProgRef.cpp"
solution = (pathlib.Path(project) / "solutions" / "ProgRef.cpp").read_text()


def wrong(text):
    sys.exit(f"{claim}: {text}")


for tool in ("Xvfb", "xdotool"):
    if not shutil.which(tool):
        print(f"-- skipped: {tool} is not there")
        sys.exit(0)


class Display:
    """An X server that chooses its own number."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-noreset", "-screen", "0", "1400x1000x24"],
                                       pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            os.environ["DISPLAY"] = ":" + number.readline().strip()
        os.environ.pop("WAYLAND_DISPLAY", None)
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


class Viewer:
    """A viewer that runs on the files of a folder."""

    def __init__(self, folder, *arguments):
        self.folder = pathlib.Path(folder)
        self.trace = self.folder / "trace.json"
        self.trace.unlink(missing_ok=True)
        self.errors = open(self.folder / "stderr", "w+")
        self.process = subprocess.Popen(
            [view, "--trace", str(self.trace), "--folder", str(self.folder / "kept"), "--width", "1300", "--height", "960",
             "--hemicube", "64", *arguments], stdin=subprocess.DEVNULL, stderr=self.errors)

    def state(self):
        try:
            return json.loads(self.trace.read_text())
        except (OSError, ValueError):
            return None

    def until(self, what, holds):
        end = time.monotonic() + WAIT
        while time.monotonic() < end:
            state = self.state()
            if state and holds(state):
                return state
            if self.process.poll() is not None:
                break
            time.sleep(0.02)
        self.errors.seek(0)
        self.process.kill()
        wrong(f"{what} did not come; exit code {self.process.poll()}, {self.errors.read()}{json.dumps(self.state())[:3000]}")

    def settled(self):
        """The state once all that was done so far is in it: a key comes after what came before it."""
        lines = self.state()["state"]["mesh_lines"]
        self.key("m", "the other mesh lines", lambda s: s["state"]["mesh_lines"] != lines)
        return self.key("m", "what was done before", lambda s: s["state"]["mesh_lines"] == lines and s["settled"])

    def ready(self):
        return self.until("the functions", lambda s: s["can_run"] and not s["building"])

    def xdotool(self, *words):
        subprocess.run(["xdotool", *map(str, words)], check=True)

    def key(self, name, what, holds):
        self.xdotool("key", name)
        return self.until(f"{what} by the key {name}", holds)

    def click(self, name, what, holds):
        state = self.until(f"the button '{name}'", lambda s: name in s["buttons"] and s["settled"])
        left, top, right, bottom = state["buttons"][name]
        self.xdotool("mousemove", round((left + right) / 2), round((top + bottom) / 2), "click", 1)
        return self.until(f"{what} by the button '{name}'", holds)

    def banner(self, part):
        return self.until(f"the message '{part}'", lambda s: any(part in b["title"] + "\n" + b["text"] for b in s["banners"]))

    def screenshots(self):
        return sorted((self.folder / "kept").glob("*.png"))

    def compare(self):
        """A screenshot by the key S, held against what a headless render of the same state gives."""
        before = len(self.screenshots())
        self.xdotool("key", "s")
        end = time.monotonic() + WAIT
        while len(self.screenshots()) == before:
            if time.monotonic() > end:
                wrong("no screenshot")
            time.sleep(0.02)
        state = self.state()
        done = subprocess.run([view_picture, str(self.trace), str(self.screenshots()[-1]), "--out", str(self.folder / "expected.png")],
                              capture_output=True, text=True)
        if done.returncode != 0:
            shutil.copy(self.screenshots()[-1], pathlib.Path(build) / "view-test" / "shown.png")
            shutil.copy(self.folder / "expected.png", pathlib.Path(build) / "view-test" / "expected.png")
            wrong(f"mode {state['mode']}: {done.stdout}{done.stderr}see shown.png and expected.png in {build}/view-test")

    def quit(self):
        self.xdotool("key", "Escape")
        try:
            code = self.process.wait(WAIT)
        except subprocess.TimeoutExpired:
            self.process.kill()
            wrong("it does not quit")
        self.errors.seek(0)
        said = self.errors.read()
        if code != 0:
            wrong(f"exit code {code}: {said}")
        return said


def camera(state):
    return state["state"]["camera"]


def drag(viewer, button, *keys):
    for key in keys:
        viewer.xdotool("keydown", key)
    viewer.xdotool("mousemove", 700, 500, "mousedown", button)
    viewer.until("the mouse held", lambda s: s["mouse"] == [700, 500] and s["mouse_down"])
    for x in (720, 740, 760, 800):  # all that comes between two frames is one step
        viewer.xdotool("mousemove", x, 530)
        viewer.until("the mouse moved", lambda s: s["mouse"] == [x, 530])
    viewer.xdotool("mouseup", button)
    viewer.until("the mouse let go", lambda s: not s["mouse_down"])
    for key in keys:
        viewer.xdotool("keyup", key)


def modes_and_pictures(viewer):
    for key, mode in (("w", "wireframe"), ("l", "flat"), ("u", "unshot power"), ("i", "patch IDs"), ("o", "form factors"),
                      ("g", "smooth")):
        viewer.key(key, mode, lambda s: s["mode"] == mode)
        viewer.compare()


def shots(viewer):
    viewer.key("n", "one shot", lambda s: s["shots"] == 1)
    viewer.key("n", "another", lambda s: s["shots"] == 2)
    viewer.key("r", "reset", lambda s: s["shots"] == 0)
    viewer.key("space", "playing", lambda s: s["playing"] and s["shots"] > 3)
    viewer.key("space", "a pause", lambda s: not s["playing"])


def cameras(viewer):
    first = camera(viewer.state())
    for key in ("Left", "Up"):
        before = camera(viewer.state())
        viewer.key(key, "a turn", lambda s: camera(s)["direction"] != before["direction"])
    viewer.key("Right", "a turn back", lambda s: abs(camera(s)["direction"][0] - first["direction"][0]) < 1e-3)
    viewer.key("Down", "a turn back", lambda s: abs(camera(s)["direction"][1] - first["direction"][1]) < 1e-3)
    distance = camera(viewer.state())["distance"]
    viewer.key("plus", "nearer", lambda s: camera(s)["distance"] < 0.95 * distance)
    viewer.key("minus", "farther", lambda s: abs(camera(s)["distance"] - distance) < 0.01 * distance)
    viewer.key("f", "a frame", lambda s: camera(s)["distance"] > 1.1 * distance)
    viewer.key("v", "the first view", lambda s: camera(s)["position"] == first["position"])
    drag(viewer, 1)
    viewer.until("a turn by the left button", lambda s: camera(s)["direction"] != first["direction"])
    viewer.settled()
    for button, keys in ((2, ()), (1, ("shift",))):
        before = camera(viewer.state())
        drag(viewer, button, *keys)
        viewer.until(f"a pan by {button} {keys}", lambda s: camera(s)["position"] != before["position"])
        if camera(viewer.settled())["direction"] != before["direction"]:
            wrong("a pan turned the camera")
    distance = camera(viewer.state())["distance"]
    viewer.xdotool("mousemove", 700, 500, "click", 4)
    viewer.until("nearer by the wheel", lambda s: camera(s)["distance"] < distance)
    if viewer.state()["picked"] is not None:
        wrong("a drag picked a patch")
    viewer.key("v", "the first view", lambda s: camera(s)["position"] == first["position"])


def pick(viewer):
    viewer.xdotool("mousemove", 800, 860, "click", 1)
    state = viewer.until("a picked patch", lambda s: s["picked"] is not None and s["sum"] is not None and "pixels' weights" in s["buttons"])
    if not 0.2 < state["sum"] < 1.001:
        wrong(f"the sum of a row: {state['sum']}")
    viewer.compare()
    viewer.key("o", "the heat map", lambda s: s["mode"] == "form factors")
    viewer.compare()
    viewer.click("let go of the picked patch", "nothing picked", lambda s: s["picked"] is None)
    viewer.key("g", "smooth", lambda s: s["mode"] == "smooth")
    viewer.xdotool("mousemove", 800, 860, "click", 1)
    viewer.click("show form factors of the picked patch", "the heat map", lambda s: s["mode"] == "form factors")
    viewer.key("x", "nothing picked", lambda s: s["picked"] is None)
    viewer.key("g", "smooth", lambda s: s["mode"] == "smooth")


def other_keys(viewer):
    viewer.key("m", "mesh lines", lambda s: s["state"]["mesh_lines"])
    viewer.compare()
    viewer.key("m", "no mesh lines", lambda s: not s["state"]["mesh_lines"])
    viewer.key("e", "brighter", lambda s: not s["state"]["auto_exposure"])
    exposure = viewer.state()["state"]["exposure"]
    viewer.key("d", "darker", lambda s: s["state"]["exposure"] < 0.9 * exposure)
    viewer.compare()
    viewer.key("a", "automatic", lambda s: s["state"]["auto_exposure"])
    viewer.key("p", "no panel", lambda s: not s["state"]["panel"] and s["picture"][0] == 0)
    viewer.key("p", "the panel", lambda s: s["state"]["panel"])
    for key in ("question", "F1"):
        viewer.key(key, "help", lambda s: s["help"])
        viewer.key(key, "no help", lambda s: not s["help"])


def buttons(viewer):
    names = {
        "one shot": lambda s: s["shots"] > before["shots"],
        "back to before the first shot": lambda s: s["shots"] == 0,
        "show the mesh over the reflectances": lambda s: s["mode"] == "wireframe",
        "show radiance, flat": lambda s: s["mode"] == "flat",
        "show radiance, smooth (Gouraud)": lambda s: s["mode"] == "smooth",
        "show unshot power": lambda s: s["mode"] == "unshot power",
        "show what renderPatchIDs draws": lambda s: s["mode"] == "patch IDs",
        "show form factors of the picked patch": lambda s: s["mode"] == "form factors",
        "mesh lines over any picture": lambda s: s["state"]["mesh_lines"],
        "frame the whole scene": lambda s: camera(s)["distance"] != camera(before)["distance"],
        "the scene's own view": lambda s: camera(s) != camera(before),
        "automatic exposure": lambda s: not s["state"]["auto_exposure"],
        "exposure": lambda s: s["state"]["exposure"] != before["state"]["exposure"],
        "shots a frame": lambda s: s["state"]["shots_per_frame"] > 0,
        "patch size": lambda s: s["patches"] != before["patches"],
        "light size": lambda s: s["state"]["light_size"] != before["state"]["light_size"],
        "these keys": lambda s: s["help"],
        "screenshot": lambda s: len(viewer.screenshots()) > taken,
        "play or pause": lambda s: s["playing"] or s["shots"] > before["shots"],
    }
    for name, holds in names.items():
        before, taken = viewer.state(), len(viewer.screenshots())
        viewer.click(name, name, holds)
    viewer.click("method", "a list", lambda s: "method: analytic" in s["buttons"])
    viewer.click("method: analytic", "the formula", lambda s: s["method"] == "analytic" and s["state"]["method"] == "analytic")
    viewer.click("hemicube", "a list", lambda s: "hemicube: 32 pixels" in s["buttons"])
    viewer.click("hemicube: 32 pixels", "a small hemicube", lambda s: s["state"]["hemicube_size"] == 32)
    viewer.click("tone curve", "a list", lambda s: "tone curve: filmic" in s["buttons"])
    viewer.click("tone curve: filmic", "the film curve", lambda s: s["state"]["tone_curve"] == "filmic")
    viewer.click("scene", "a list", lambda s: "scene: furnace.x3d" in s["buttons"])
    viewer.click("scene: furnace.x3d", "another scene", lambda s: s["scene"].endswith("furnace.x3d"))
    viewer.click("scene", "a list", lambda s: "scene: cornell_2.x3d" in s["buttons"])
    state = viewer.click("scene: cornell_2.x3d", "the scene from before", lambda s: s["scene"].endswith("cornell_2.x3d"))
    if state["state"]["tone_curve"] != "filmic":
        wrong("the scene did not keep its settings")
    untried = {name for name in state["buttons"] if ": " not in name} - set(names) - {"method", "hemicube", "tone curve", "scene", "effects"}
    if untried:
        wrong(f"buttons that no test clicks: {untried}")


def write(text):
    part = source.with_suffix(".part")
    part.write_text(text)
    part.replace(source)


def sizes(viewer):
    viewer.key("question", "no help", lambda s: not s["help"])
    viewer.key("g", "smooth", lambda s: s["mode"] == "smooth")
    viewer.key("r", "reset", lambda s: s["shots"] == 0)
    before = viewer.key("n", "one shot", lambda s: s["shots"] == 1)
    viewer.xdotool("mousemove", 150, 500, "click", 4)
    viewer.settled()
    viewer.xdotool("mousemove", 800, 500, "click", 4)
    state = viewer.until("nearer by the wheel over the picture", lambda s: camera(s)["distance"] < camera(before)["distance"])
    if camera(state)["distance"] < 0.85 * camera(before)["distance"]:
        wrong("the wheel over the panel moved the camera")
    window = subprocess.run(["xdotool", "search", "--name", "radlab view"], capture_output=True, text=True, check=True).stdout.split()[0]
    for width, height in ((700, 500), (450, 300), (1300, 960)):
        viewer.xdotool("windowsize", window, width, height)
        viewer.until(f"a window of {width} x {height}", lambda s: s["picture"][2] == width and s["picture"][3] == height)
        viewer.compare()
    viewer.key("v", "the first view", lambda s: camera(s) != camera(state))


def inputs_while_shooting(viewer, folder):
    """A shot that lasts until a file is there: frames go on, the mouse turns the camera, and what is asked for comes after it."""
    viewer.xdotool("key", "n")
    before = viewer.state()
    drag(viewer, 1)
    state = viewer.until("a turn while it shoots", lambda s: camera(s)["direction"] != camera(before)["direction"])
    viewer.xdotool("key", "l")
    drag(viewer, 1)
    state = viewer.until("another turn", lambda s: camera(s)["direction"] != camera(state)["direction"])
    if state["shots"] != 0 or state["mode"] != "smooth":
        wrong(f"something changed in the middle of a shot: {state}")
    (folder / "go").touch()
    viewer.until("the end of the shot, and what was asked for", lambda s: s["shots"] == 1 and s["mode"] == "flat")


own = ["--source", str(source), "--target", "view-test-library", "--patch-size", "100"]
with tempfile.TemporaryDirectory() as folder, Display():
    os.environ["TMPDIR"] = str(pathlib.Path(folder) / "tmp")  # where libraries are copied to
    os.mkdir(os.environ["TMPDIR"])
    if claim.startswith("every key"):
        viewer = Viewer(folder, "--solution", "--patch-size", "60")
        viewer.ready()
        shots(viewer)
        modes_and_pictures(viewer)
        cameras(viewer)
        pick(viewer)
        other_keys(viewer)
        buttons(viewer)
        sizes(viewer)
        last = viewer.key("Left", "a turn", lambda s: True)
        last = viewer.settled()
        if last["gl_errors"] != 0:
            wrong(f"{last['gl_errors']} errors of OpenGL")
        viewer.quit()
        viewer = Viewer(folder, "--solution")
        if camera(viewer.ready()) != camera(last):
            wrong("the last view was not kept")
        viewer.quit()
    elif claim.startswith("a saved file"):
        write((pathlib.Path(project) / "exercises" / "ProgRef.cpp").read_text())
        viewer = Viewer(folder, *own)
        viewer.ready()
        viewer.xdotool("key", "space")
        viewer.banner("maxenergy_patch is not written yet.\nDo stage 1")
        head, body = solution.split("MyPolygon* maxenergy_patch() {\n", 1)
        write(head + "MyPolygon* maxenergy_patch() {\n    int wrong = nonsense;\n" + body)
        viewer.banner(f"ProgRef.cpp:{head.count(chr(10)) + 2}:17: error: ")
        write(solution)
        viewer.banner("Reloaded")
        viewer.key("n", "a shot of the new functions", lambda s: s["shots"] == 1 and s["reloads"] == 2)
        viewer.quit()
    elif claim.startswith("a crash"):
        write(solution.replace("void renderPatchIDs() {", "void renderPatchIDs() {\n    *static_cast<volatile int*>(nullptr) = 1;", 1))
        hang = "30" if "RADLAB_SANITIZED" in os.environ else "2"  # the sanitizers take seconds for their report of the crash
        viewer = Viewer(folder, "--hang-seconds", hang, *own)
        viewer.ready()
        viewer.key("Left", "a turn", lambda s: True)
        before = viewer.settled()
        viewer.xdotool("key", "n")
        state = viewer.banner("renderPatchIDs crashed")
        if camera(state) != camera(before) or state["playing"] or state["can_run"]:
            wrong(f"not the same view, paused: {camera(state)}, {camera(before)}")
        write(solution.replace("bool distributeEnergy(MyPolygon* maxP) {", "bool distributeEnergy(MyPolygon* maxP) {\n    for (volatile unsigned i = 0;;) i = i + 1;", 1))
        viewer.ready()
        viewer.xdotool("key", "n")
        viewer.banner(f"distributeEnergy ran for more than {hang} s")
        write(solution.replace("MyPolygon* maxenergy_patch() {", "#include <csignal>\nstatic int initialised = std::raise(SIGSEGV);\nMyPolygon* maxenergy_patch() {", 1))
        viewer.banner("while it was being loaded")
        if list(pathlib.Path(os.environ["TMPDIR"]).glob("radlab-view-*")):
            wrong("the library that crashed was left behind")
        write(solution)
        viewer.ready()
        viewer.key("n", "a shot", lambda s: s["shots"] == 1)
        viewer.quit()
    elif claim.startswith("a shot that"):
        go = str(pathlib.Path(folder) / "go")
        write(solution.replace("    hemicube->renderScene(", f"    while (!std::ifstream({json.dumps(go)}))\n        hemicube->renderScene(", 1)
              .replace("#include", "#include <fstream>\n#include", 1))
        viewer = Viewer(folder, "--hang-seconds", "600", *own)
        viewer.ready()
        inputs_while_shooting(viewer, pathlib.Path(folder))
        if viewer.settled()["gl_errors"] != 0:
            wrong("errors of OpenGL")
        viewer.quit()
    elif claim.startswith("what is wrong"):
        for arguments, says in ((["no-such.x3d"], "no such file"), (["--width", "7"], "--width"), (["--patch-size", "0"], "--patch-size"),
                                (["--hemicube", "63"], "hemicube"), (["--source", "none.cpp"], "none.cpp: no such file")):
            done = subprocess.run([view, "--folder", folder, *arguments], capture_output=True, text=True)
            if done.returncode != 2 or says not in done.stderr:
                wrong(f"{arguments}: exit code {done.returncode}, {done.stderr}")
        os.environ["DISPLAY"] = ":9999"
        done = subprocess.run([view, "--folder", folder], capture_output=True, text=True)
        if done.returncode != 2 or "display" not in done.stderr.lower():
            wrong(f"no display: exit code {done.returncode}, {done.stderr}")
    else:
        wrong("no such test")
