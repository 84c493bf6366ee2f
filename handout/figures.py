#!/usr/bin/env python3
"""Makes every figure and number of the handout from the scenes: figures.py PROGRAMS [STEP…], the folder of the built programs.

Leaves pictures, plots and diagrams in handout/figures and the numbers in handout/figures.json; some minutes. Steps: numbers, curves,
pictures, demo, extensions, meshes, plan, study, race, viewer, drawings; without any, all. Times are measured by curves, study and race:
let nothing else run.
"""
import csv
import json
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

import diagrams
import viewer

ROOT = Path(__file__).resolve().parent.parent
FIGURES = ROOT / "handout/figures"
WORK = ROOT / "out/handout/work"
BOX = "resources/scenes/cornell_2.x3d"
EXPOSURE = 1.6
PICTURE = ["--width", "256", "--height", "256"]
PLANNED = ("cornell_1", "cornell_2", "grey_room", "mirror")
REFERENCE_PATHS, FEW_PATHS = 1024, 16


def run(programs, *words):
    """Runs one of the programs; what it says and the seconds that it took from start to end."""
    print("radlab: " + " ".join(str(word) for word in words), file=sys.stderr, flush=True)
    if not (programs / words[0]).exists():
        sys.exit(f"radlab: {words[0]} is not built; run: ninja -C {programs.parent} {words[0]}")
    begin = time.monotonic()
    done = subprocess.run([programs / words[0], *map(str, words[1:])], cwd=ROOT, text=True, stdout=subprocess.PIPE)
    if done.returncode:
        sys.exit(f"radlab: {words[0]} failed, exit code {done.returncode}: correct what it says above and run the same command again")
    return done.stdout, time.monotonic() - begin


def found(pattern, text):
    match = re.search(pattern, text)
    if not match:
        sys.exit(f"radlab: found no {pattern} in: {text}")
    return match.group(1)


def display(programs, source, target, shrink=1):
    run(programs, "handout-figures", "display", source, "-o", FIGURES / target, "--exposure", EXPOSURE, "--shrink", shrink)


def counted(text):
    """With commas in whole numbers of four digits and more: 1,071 for 1071."""
    return re.sub(r"(?<![\d.,])\d{4,}(?![\d.])", lambda number: f"{int(number.group()):,}", str(text))


def percent(share):
    return f"{100 * share:.2g} %"


def seconds(time_taken):
    return f"{time_taken:.0f} s" if time_taken >= 10 else f"{time_taken:.2g} s" if time_taken >= 0.01 else f"{time_taken:.1g} s"


def demo_pictures(programs, numbers):
    demo = WORK / "demo"
    run(programs, "demo", "--out", demo)
    page = (demo / "index.html").read_text()
    numbers["formula_sum"], numbers["hemicube_sum"] = re.findall(r"sum\s+to ([0-9]+\.[0-9]+)", page)[:2]
    numbers["demo_shots"] = re.findall(r"after ([0-9,]+) shots in", page)[-1]
    for source, target in {"02_brightest": "brightest", "03_analytic_form_factors": "formula", "04_first_shots": "direct",
                           "06_smooth": "converged", "07_patch_ids": "ids", "08_hemicube": "hemicube",
                           "09_hemicube_form_factors": "hidden", "10_shadows": "shadows"}.items():
        display(programs, demo / f"{source}.png", f"{target}.png", 2)
    for shots in (1, 10, 100, 1000):
        display(programs, demo / f"shots_{shots:05}.png", f"shots-{shots}.png", 4)


def box(programs, name, *flags, scene=BOX):
    file = WORK / f"{name}.hdr"
    return file, *run(programs, "render", scene, "-o", file, *PICTURE, *flags)


def error_of(programs, file, reference, own=0.0):
    """The relative error of a picture; `own` is the square of the reference's own."""
    said, _ = run(programs, "handout-figures", "compare", file, "--reference", reference, "--exposure", EXPOSURE)
    return max(float(said) ** 2 - own, 1e-8) ** 0.5


def paths_until(programs, name, paths, measure, wanted, power):
    """A picture of so many paths that what is measured is within a tenth of what is wanted, or as near as a few tries come.

    The measure grows with that power of the number of paths.
    """
    for _ in range(4):
        file, _, taken = box(programs, name, "--method", "path", "--samples", paths)
        if abs(measure(file, taken) / wanted - 1) < 0.1:
            break
        nearer = max(1, round(paths * (wanted / measure(file, taken)) ** (1 / power)))
        if nearer == paths:
            break
        paths = nearer
    return file, paths, taken


def race(programs, numbers):
    """Radiosity and path tracing on the same box: same time, and same error.

    The reference is itself a picture of paths. The square of its error is 1/paths of what one path a pixel has, which a picture of few paths
    tells, and is taken off every square.
    """
    reference, _, slow = box(programs, "reference", "--method", "path", "--samples", REFERENCE_PATHS)
    few, _, few_time = box(programs, "few", "--method", "path", "--samples", FEW_PATHS)
    one_path = error_of(programs, few, reference) ** 2 / (1 / FEW_PATHS + 1 / REFERENCE_PATHS)
    own = one_path / REFERENCE_PATHS
    mesh, said, taken = min((box(programs, "radiosity", "--error", "0.01") for _ in range(3)), key=lambda made: made[2])
    error = error_of(programs, mesh, reference, own)
    quick, quick_paths, quick_time = paths_until(programs, "paths-time", max(1, round(FEW_PATHS * taken / few_time)),
                                                 lambda _, seconds_taken: seconds_taken, taken, 1)
    good, good_paths, good_time = paths_until(programs, "paths-error", max(1, round(one_path / error**2)),
                                              lambda file, _: error_of(programs, file, reference, own), error, -0.5)
    numbers.update({
        "race_patches": counted(found(r"; ([0-9]+) patches", said)), "race_estimate": found(r"estimated error: ([0-9.]+ %)", said),
        "race_time": seconds(taken), "race_error": percent(error),
        "race_reference_paths": counted(REFERENCE_PATHS), "race_reference_time": seconds(slow),
        "race_same_time_paths": counted(quick_paths), "race_same_time": seconds(quick_time),
        "race_same_time_error": percent(error_of(programs, quick, reference, own)),
        "race_same_error_paths": counted(good_paths), "race_same_error_time": seconds(good_time),
        "race_same_error": percent(error_of(programs, good, reference, own))})
    for file, target in ((mesh, "race-radiosity"), (quick, "race-paths-time"), (good, "race-paths-error"), (reference, "race-reference")):
        display(programs, file, f"{target}.png")


def meshes(programs, numbers):
    for name, size in (("coarse", 110), ("fine", 15)):
        file, said, _ = box(programs, name, "--patch-size", size, "--method", "links")
        numbers[f"{name}_patches"] = counted(found(r": ([0-9]+) patches", said))
        display(programs, file, f"shadow-{name}.png")
    file, _, _ = box(programs, "mirror", "--error", "0.02", scene="resources/scenes/mirror.x3d")
    display(programs, file, "mirror.png")


def extensions(programs, _):
    run(programs, "demo-extensions", "--out", WORK / "extensions")
    for name in ("hemisphere", "antialiasing", "mirror"):
        shutil.copy(WORK / f"extensions/{name}.png", FIGURES / f"extension-{name}.png")


def plan(programs, numbers):
    """What each effect of some scenes is expected to cost."""
    for scene in PLANNED:
        said = json.loads(run(programs, "plan", f"resources/scenes/{scene}.x3d", "--json")[0])
        for effect in said["effects"]:
            numbers[f"plan_{scene}_{effect['name']}"] = seconds(effect["seconds"]) if effect["on"] else "off"
        numbers[f"plan_{scene}_whole"] = seconds(sum(cost for name, cost in said["cost"].items() if name.endswith("Seconds")))


def study(programs, numbers):
    folder = WORK / "study"
    run(programs, "study", BOX, "--quick", "--repeat", 3, "--fresh", "--out", folder)
    for source, target in {"whole": "study", "whole_narrow": "study-narrow"}.items():
        shutil.copy(folder / f"plot_cornell_2_{source}.svg", FIGURES / f"plot-{target}.svg")
        clean(FIGURES / f"plot-{target}.svg")
    with open(folder / "results.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    coarse, middle, fine = sorted({int(row["patches"]) for row in rows})

    def error(patches, method=""):
        return percent(min(float(row["whole_error"]) for row in rows if int(row["patches"]) == patches and method in row["method"]))
    numbers.update({"study_coarse": counted(coarse), "study_middle": counted(middle), "study_fine": counted(fine),
                    "study_formula": error(fine, "course formula"),
                    "study_best_coarse": error(coarse), "study_best_middle": error(middle), "study_best_fine": error(fine)})


def window(programs, _):
    viewer.picture_of(programs / "view", ROOT / BOX, FIGURES / "viewer.png")


def machine_free_numbers(programs, numbers):
    run(programs, "handout-figures", "numbers", "-o", WORK / "numbers.json")
    numbers.update(json.loads((WORK / "numbers.json").read_text()))


def curves(programs, numbers):
    run(programs, "handout-figures", "curves", "-o", WORK)
    numbers.update({name: counted(value) for name, value in json.loads((WORK / "curves.json").read_text()).items()})


def pictures(programs, _):
    run(programs, "handout-figures", "pictures", "-o", WORK)
    for file in WORK.glob("*.png"):
        (FIGURES / file.name).write_bytes(file.read_bytes())


def drawings(_programs, _numbers):
    diagrams.write_all()
    subprocess.run(["gnuplot", ROOT / "handout/plots.gp"], cwd=WORK, check=True)
    for file in FIGURES.glob("plot-*.svg"):
        clean(file)


def clean(file):
    """A plot without gnuplot's version, and without blanks at ends of lines."""
    text = re.sub(r"[ \t]+$", "", file.read_text(), flags=re.MULTILINE)
    file.write_text(re.sub(r"<desc>.*?</desc>\n?", "", text, flags=re.DOTALL))


STEPS = {"numbers": machine_free_numbers, "curves": curves, "pictures": pictures, "demo": demo_pictures, "extensions": extensions,
         "meshes": meshes, "plan": plan, "study": study, "race": race, "viewer": window, "drawings": drawings}


def main():
    programs, wanted = Path(sys.argv[1]).resolve(), sys.argv[2:] or list(STEPS)
    for name in wanted:
        if name not in STEPS:
            sys.exit(f"radlab: handout: found step '{name}', expected some of {', '.join(STEPS)}")
    WORK.mkdir(parents=True, exist_ok=True)
    FIGURES.mkdir(exist_ok=True)
    file = ROOT / "handout/figures.json"
    numbers = json.loads(file.read_text()) if file.exists() and sys.argv[2:] else {}
    for name in wanted:
        STEPS[name](programs, numbers)
        if name != "drawings":
            file.write_text(json.dumps(numbers, indent=1, ensure_ascii=False) + "\n")
    print("radlab: figures and numbers are new in handout/; next: ./radlab handout", file=sys.stderr)


if __name__ == "__main__":
    main()
