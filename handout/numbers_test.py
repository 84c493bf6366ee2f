#!/usr/bin/env python3
"""Fails where a number in handout/figures.json is not what the programs give: numbers_test.py PROGRAM PROJECT FOLDER

Only those that no machine changes, and that take no time; ./radlab handout --figures makes all.
"""
import json
import subprocess
import sys
from pathlib import Path


def main():
    program, root, folder = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, "numbers", "-o", folder / "numbers.json"], check=True)
    now = json.loads((folder / "numbers.json").read_text())
    then = json.loads((root / "handout/figures.json").read_text())
    stale = [f"{name}: found {then.get(name)}, the programs give {value}" for name, value in now.items() if then.get(name) != value]
    if len(now) < 30:
        stale.append(f"found {len(now)} numbers, expected 30 and more")
    sys.exit("\n".join([*stale, "run ./radlab handout --figures"]) if stale else 0)


if __name__ == "__main__":
    main()
