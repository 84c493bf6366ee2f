#!/usr/bin/env python3
"""Classroom 50 runs this in a student's checkout: it leaves there result.json, the marks, and release-body.md, the verdict in words.

Where the grader or the machine fails, it ends with another code than 0 and leaves neither, so that an earlier mark stays.
"""
import json
import os
import subprocess
import sys
import tempfile
from datetime import datetime, timezone
from pathlib import Path

HERE = Path(__file__).resolve().parent
# What result.json says of the submission, and the variables in which Classroom 50 tells it.
IDENTITY = {
    "classroom": "CLASSROOM",
    "assignment": "ASSIGNMENT",
    "assignment_type": "ASSIGNMENT_TYPE",
    "owner": "OWNER",
    "submission": "SUBMISSION_TAG",
    "commit": "COMMIT_URL",
    "release": "RELEASE_URL",
    "review": "REVIEW_URL",
}
RESULT, BODY = Path("result.json"), Path("release-body.md")


def before_each_line(mark, text):
    """Text of a submission that is neither laid out as Markdown nor taken for a command of the runner."""
    return "".join(f"{mark}{line}\n" for line in text.splitlines())


def write(file, text):
    """Whole, and in the place of a link rather than where it leads."""
    with tempfile.NamedTemporaryFile("w", dir=".", delete=False, encoding="utf-8") as part:
        part.write(text)
    os.chmod(part.name, 0o644)
    os.replace(part.name, file)


def main():
    lacking = [name for name in IDENTITY.values() if not os.environ.get(name)]
    if lacking:
        sys.exit(f"autograder: not set: {', '.join(lacking)}; expected to be started by Classroom 50")
    for file in (RESULT, BODY):  # a student may have committed one
        file.unlink(missing_ok=True)
    radlab = HERE / "radlab"
    subprocess.run(["sh", radlab / "radlab", "check", "--help"], check=True, stdout=subprocess.DEVNULL)
    with tempfile.TemporaryDirectory() as folder:
        verdict = Path(folder, "verdict.json")
        command = ["sh", HERE / "judge.sh", radlab, Path.cwd(), "--classroom50", verdict]
        check = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, encoding="utf-8", errors="replace")
        if check.returncode not in (0, 1, 2) or not verdict.exists():
            print(before_each_line("| ", check.stdout), end="")
            sys.exit("autograder: the grader or the machine failed, so there is no mark")
        marks = json.loads(verdict.read_text(encoding="utf-8"))
    now = datetime.now(timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    identity = {key: os.environ[name] for key, name in IDENTITY.items()}
    write(BODY, "What `./radlab check` says:\n\n" + before_each_line("    ", check.stdout))
    write(RESULT, json.dumps({**identity, "datetime": now, **marks}, indent=1) + "\n")


if __name__ == "__main__":
    main()
