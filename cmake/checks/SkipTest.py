"""A test that says that it is skipped counts as skipped, and not as passed: SkipTest.py CTEST BUILD PROGRAM

PROGRAM holds a case that is always skipped, but runs only when it is asked for.
"""
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ctest, build, program = sys.argv[1:]
PROPERTY = "SKIP_REGULAR_EXPRESSION"


def run(*arguments):
    return subprocess.run([ctest, *arguments], capture_output=True, text=True).stdout


def skips(test):
    values = [entry["value"] for entry in test.get("properties", []) if entry["name"] == PROPERTY]
    return values and values[0][0].strip() == "-- skipped:"  # discovery cuts the last space off


if not os.path.exists(program):
    print(f"-- skipped: {program} is not built")
    sys.exit(0)
tests = [test for test in json.loads(run("--test-dir", build, "--show-only=json-v1"))["tests"] if "_NOT_BUILT" not in test["name"]]
cannot = [test["name"] for test in tests if not skips(test)]
if cannot or not tests:
    sys.exit(f"of {len(tests)} tests, these cannot be skipped: {cannot}")

with tempfile.TemporaryDirectory() as folder:
    lines = [f'add_test(one "{program}" --no-skip "--test-case=the case that no machine can run")\n',
             f'set_tests_properties(one PROPERTIES {PROPERTY} "-- skipped:")\n']
    (Path(folder) / "CTestTestfile.cmake").write_text("".join(lines))
    if "***Skipped" not in run("--test-dir", folder):
        sys.exit("a case that is skipped does not count as skipped")
    (Path(folder) / "CTestTestfile.cmake").write_text(lines[0])
    if "Passed" not in run("--test-dir", folder):
        sys.exit("a case that is skipped fails by itself")
