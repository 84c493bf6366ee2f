#!/usr/bin/env python3
"""Tests of check.py: each wrong name put into a chapter is found, by its line, and nothing else is.

  check_test.py PROJECT FOLDER
"""
import shutil
import sys
from pathlib import Path

import check

WRONG = {
    "`calcHemicubeFF` is called": "no calcHemicubeFF in the headers",
    "`polygons[i]->formFaktor` is set": "no formFaktor in the headers",
    "see `framework/course/Missing.h`": "no file framework/course/Missing.h",
    "run `./radlab rendr`": "no command 'rendr' of ./radlab",
    "run `./radlab render --colour`": "'render' has no flag --colour",
    "run `./radlab plan --shots 8`": "'plan' has no flag --shots",
    "run `./radlab check nothing`": "no stage 'nothing' of check",
    "run `./radlab bench nothing`": "no part 'nothing' of bench",
    "run `./radlab plan resources/scenes/missing.x3d`": "no file resources/scenes/missing.x3d",
    "with `--colour`": "no program has the flag --colour",
    "the check `ff.nothing`": "no check ff.nothing",
    "![A picture](figures/missing.png)": "no figure figures/missing.png",
    "it takes {{missing_number}}": "no number missing_number in handout/figures.json",
    "[a chapter](#missing)": "no chapter or section #missing",
    "by [@Nobody1900, section 1]": "no Nobody1900 in resources/references.bib",
    "by [@Cohen1988]": "Cohen1988 is cited without chapter, section or page",
    "    ./radlab render --colour": "'render' has no flag --colour",
}
RIGHT = ["`calcFF` and `polygons[j]->formF`", "`./radlab check 3 --hint`", "`ff.facing`", "[@Cohen1988, section 3]", "`--method`",
         "`framework/course/ProgRef.h`", "[start](#start)", "`./radlab render --shots 8`", "`./radlab formfactors --tolerance 1e-6`"]
HELP = """Usage: render [OPTIONS]
  -o,--out TEXT       What to write, in place of --old
  --colour            All channels
"""


def faults_with(project, line):
    """What is found in a chapter of that one line."""
    folder = project.root / "handout"
    numbers, anchors = {"known": "1"}, {"start"}
    figures = {f"figures/{file.name}" for file in (folder / "figures").iterdir()}
    return list(check.chapter_faults(project, f"one\n\n{line}\n", numbers, figures, anchors))


def unused_are_found(root, folder):
    """In a copy of the handout, a picture and a number that no chapter uses."""
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(root / "handout", folder / "handout")
    (folder / "handout/figures/unused.png").write_bytes(b"")
    numbers = folder / "handout/figures.json"
    numbers.write_text(numbers.read_text().replace("{", '{"unused_number": "1",', 1))
    found = list(check.faults_of(folder))
    expected = {"handout/figures/unused.png: no chapter shows it", "handout/figures.json: no chapter uses unused_number"}
    return expected <= set(found)


def help_decides(root, folder):
    """Where a program is built, what its --help lists is right, and nothing else; another that is not built is looked up in the sources."""
    folder.mkdir(parents=True, exist_ok=True)
    program = folder / "render"
    program.write_text(f"#!/bin/sh\ncat <<'END'\n{HELP}END\n")
    program.chmod(0o755)
    project = check.Project(root, folder)
    right = ["`./radlab render --colour -o a.png`", "`./radlab plan --json`", "`./radlab demo --exercise`"]
    return not any(faults_with(project, line) for line in right) and \
        faults_with(project, "`./radlab render --old`") == ["3: 'render' has no flag --old"] and \
        faults_with(project, "`./radlab plan --colour`") == ["3: 'plan' has no flag --colour"]


def main():
    root, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    project = check.Project(root)
    wrong = [f"{line}: expected '3: {said}', found {faults_with(project, line)}" for line, said in WRONG.items()
             if faults_with(project, line) != [f"3: {said}"]]
    wrong += [f"{line}: expected no fault, found {faults_with(project, line)}" for line in RIGHT if faults_with(project, line)]
    if not help_decides(root, folder / "programs"):
        wrong.append("the flags that a program lists for --help were not those that were right")
    if not unused_are_found(root, folder):
        wrong.append("a figure and a number that no chapter uses were not found")
    sys.exit("\n".join(wrong) if wrong else 0)


if __name__ == "__main__":
    main()
