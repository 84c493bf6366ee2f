#!/usr/bin/env python3
"""Finds what the handout names and the project does not have: check.py [PROJECT [PROGRAMS]]

Every code span, command, figure, number, link and citation of the chapters is looked up: functions and members among the words of the headers, files in the tree, flags
in what --help prints (in the sources, for a program that the folder PROGRAMS lacks), commands in the script radlab, checks in the manifest,
keys in references.bib. Figures and numbers that no chapter uses are found as well.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

SPAN = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
FLAG = re.compile(r"(?<![\w-])--?[A-Za-z][\w-]*")
LANGUAGE = set("nullptr true false int float".split())
DRAWING = set("glBegin glEnd glColor3ub glVertex3f GL_QUADS GL_TRIANGLES".split())
# Words of submissions of a class, which lie in no tree.
PLACES = re.compile(r"^(out/.*|submissions/|grades\.csv|\S+\.(png|csv|npy|hdr)|\d.*)$")
CITATION = re.compile(r"@([A-Za-z]\w*)([^;\]]*)")
LOCATOR = re.compile(r",\s*(chapters?|sections?|pp?\.)\s+\S")


class Project:
    """What there is to name."""

    def __init__(self, root, programs=None):
        self.root, self.programs = root, programs
        headers = [*root.glob("framework/**/*.h"), *root.glob("exercises/**/*.cpp"), root / "resources/Resource.xml"]
        code = re.sub(r"//.*", "", "\n".join(map(self.read, headers)))
        self.words = LANGUAGE | DRAWING | set(re.findall(r"[A-Za-z_]\w*", code))
        self.checks = set(re.findall(r'"id":\s*"([^"]+)"', self.read(root / "grader/stages/manifest.json")))
        script = self.read(root / "radlab")
        self.commands = {row[0]: row[1] for row in re.findall(r"^([a-z]+)\|([^|]*)\|[^|\n]*\|", script, re.MULTILINE)}
        self.subcommands = set(re.findall(r"^    ([a-z]+-[a-z]+)\)", script, re.MULTILINE))
        self.keys = set(re.findall(r"^@\w+\{(\w+),", self.read(root / "resources/references.bib"), re.MULTILINE))
        self.flags, self.known = self.flags_of(root), {}

    @staticmethod
    def read(file):
        return file.read_text(errors="replace") if file.is_file() else ""

    def flags_of(self, root):
        """For each file of a program or of what programs share, its flags."""
        found = {}
        for file in [*root.glob("framework/apps/*.*"), *root.glob("grader/apps/*.*"), root / "handout/build.py"]:
            names = re.findall(r'"((?:-\w,)?--?[a-z][\w,-]*)"', self.read(file))
            found.setdefault(file.stem, set()).update(name for group in names for name in group.split(","))
        return found

    def shared_with(self, name):
        """The parts that a program includes from the folder of the programs, and what these include."""
        found, left = set(), [name]
        while left:
            part = left.pop()
            if part not in found:
                found.add(part)
                files = (self.root / folder / f"{part}.{end}" for folder in ("framework/apps", "grader/apps") for end in ("h", "cpp"))
                left += re.findall(r'#include "(?:grader/)?apps/(\w+)\.h"', "".join(map(self.read, files)))
        return found

    def helped(self, target):
        """The flags in what a built program prints for --help; nothing where it is not built."""
        program = self.programs and self.programs / target
        if not program or not program.is_file():
            return set()
        said = subprocess.run([program, "--help"], stdout=subprocess.PIPE, text=True, timeout=60, check=True).stdout
        rows = re.findall(r"^ +(-[-\w]+(?:,-[-\w]+)*)", said, re.MULTILINE)
        return {name for row in rows for name in row.split(",")}

    def flags_for(self, command):
        """Those of the program that a command starts, and those that the script radlab takes itself."""
        target = self.commands[command]
        if target.endswith(".sh"):
            return set()
        if target.endswith(".py"):
            return self.flags["build"] | {"--help"}
        if command not in self.known:
            own = self.helped(target) or set().union(*(self.flags.get(part, set()) for part in self.shared_with(target)))
            self.known[command] = own | {"--help", "--version"} | ({"--exercise", "--extensions"} if command == "demo" else set())
        return self.known[command]


def command_faults(project, line):
    words = line.split()
    command = words[1] if len(words) > 1 else ""
    if command not in project.commands:
        yield f"no command '{command}' of ./radlab"
        return
    flags = project.flags_for(command)
    for word in words[2:]:
        name = word.split("=")[0]
        if FLAG.fullmatch(name):
            if name not in flags:
                yield f"'{command}' has no flag {name}"
        elif "/" in word and not PLACES.match(word) and not (project.root / word).exists():
            yield f"no file {word}"
    if command == "bench" and len(words) > 2 and f"bench-{words[2]}" not in project.subcommands:
        yield f"no part '{words[2]}' of bench"
    if command == "check" and len(words) > 2 and re.fullmatch(r"[A-Za-z_]+", words[2]) and not judged(project, words[2]):
        yield f"no stage '{words[2]}' of check"


def judged(project, name):
    """Whether check knows a stage or an extension of that name, or whose name begins so."""
    manifest = project.read(project.root / "grader/stages/manifest.json")
    return any(stage.lower().startswith(name.lower()) for stage in re.findall(r'"stage":\s*"(\w+)"', manifest))


def span_faults(project, span):
    if span.startswith("./radlab"):
        yield from command_faults(project, span)
    elif re.fullmatch(r"[a-z]+\.[a-z]+", span):
        if span not in project.checks:
            yield f"no check {span}"
    elif span.startswith("-"):
        name = span.split("=")[0].split()[0]
        if not any(name in flags for flags in project.flags.values()):
            yield f"no program has the flag {name}"
    elif "/" in span:
        if not PLACES.match(span) and not (project.root / span.rstrip("/")).exists():
            yield f"no file {span}"
    else:
        for word in re.findall(r"[A-Za-z_]\w*", span):
            if word not in project.words:
                yield f"no {word} in the headers"


def citation_faults(project, text):
    for group in re.findall(r"\[([^\]]*@[^\]]*)\]", text):
        for key, rest in CITATION.findall(group):
            if key not in project.keys:
                yield f"no {key} in resources/references.bib"
            elif not LOCATOR.match(rest):
                yield f"{key} is cited without chapter, section or page"


def lines_of(text):
    """Each line with its number, its code blocks told apart."""
    for number, line in enumerate(text.splitlines(), 1):
        yield number, line, line.startswith("    ")


def chapter_faults(project, text, numbers, figures, anchors):
    for number, line, block in lines_of(text):
        faults = []
        if block and line.strip().startswith("./radlab"):
            faults += command_faults(project, line.strip())
        elif not block:
            for span in SPAN.findall(line):
                faults += span_faults(project, span)
        faults += [f"no figure {name}" for name in re.findall(r"\]\((figures/[^)]+)\)", line) if name not in figures]
        faults += [f"no number {name} in handout/figures.json" for name in re.findall(r"\{\{(\w+)\}\}", line) if name not in numbers]
        faults += [f"no chapter or section #{name}" for name in re.findall(r"\]\(#([^)]+)\)", line) if name not in anchors]
        faults += citation_faults(project, line)
        yield from (f"{number}: {fault}" for fault in faults)


def faults_of(root, programs=None):
    project = Project(root, programs)
    folder = root / "handout"
    numbers = json.loads((folder / "figures.json").read_text())
    figures = {f"figures/{file.name}" for file in (folder / "figures").iterdir()}
    texts = {file.name: file.read_text() for file in sorted(folder.glob("[0-9][0-9]-*.md"))}
    whole = "\n".join(texts.values())
    anchors = set(re.findall(r"\{#([\w-]+)", whole))
    for name, text in texts.items():
        yield from (f"handout/{name}:{fault}" for fault in chapter_faults(project, text, numbers, figures, anchors))
    shown = set(re.findall(r"\]\((figures/[^)]+)\)", whole))
    for name in sorted(figures - shown - {name.replace(".svg", "-narrow.svg") for name in shown}):
        yield f"handout/{name}: no chapter shows it"
    for name in sorted(set(numbers) - set(re.findall(r"\{\{(\w+)\}\}", whole)) - {"delta_8_table"}):
        yield f"handout/figures.json: no chapter uses {name}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent).resolve()
    faults = list(faults_of(root, Path(sys.argv[2]).resolve() if len(sys.argv) > 2 else None))
    print("\n".join(faults) if faults else "every name, figure, number and citation of the handout is there")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
