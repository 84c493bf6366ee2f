#!/bin/sh
# Packs radlab for others: package.sh student|gradescope [FILE]
set -eu

root=$(CDPATH='' cd -- "$(dirname "$0")/.." && pwd -P)
kind=${1-}

say() { printf 'radlab: %s\n' "$*" >&2; }
fail() { say "$@"; exit 2; }

usage() {
    cat <<'END'
usage: ./radlab package student [FILE]      what students get: framework, exercises, resources, the grader, no solutions
       ./radlab package gradescope [FILE]   the autograder.zip to upload to Gradescope
END
}

case $kind in
    student | gradescope) ;;
    --help | -h) usage; exit 0 ;;
    '') usage >&2; exit 2 ;;
    *) fail "package: found '$kind', expected student or gradescope" ;;
esac
[ $# -le 2 ] || fail "package $kind: found '$3', expected one file to write"
case $kind in
    student) file=${2-out/radlab-student.zip} ;;
    gradescope) file=${2-out/autograder.zip} ;;
esac
case $file in *.zip) ;; *) fail "$file: expected a name that ends in .zip" ;; esac
mkdir -p "$(dirname "$file")" || exit 2
file=$(CDPATH='' cd -- "$(dirname "$file")" && pwd -P)/$(basename "$file")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The files of the project: those that git knows or does not ignore, else all but what is built.
files() {
    cd "$root"
    git ls-files --cached --others --exclude-standard 2>/dev/null || find . -type f -not -path './build/*' -not -path './out/*' | cut -c3-
}

# Solutions, and whatever quotes them; tests, which need them; the grading of classes.
not_for_students='^(solutions|packaging|grader/(mutants|attacks|batch|intake)|resources/classroom|\.ci|\.github)/|^grader/.*Test\.cpp$|^solutions|^grader/apps/(grade|Grade|unpack|references|bench-grader|CheckBench|Example|Mutants)|^cmake/checks/|^(BENCHMARKS|CHANGELOG|HACKING)\.md$'

copy() {
    while IFS= read -r name; do
        [ -f "$root/$name" ] || continue
        mkdir -p "$1/$(dirname "$name")"
        cp -p "$root/$name" "$1/$name"
    done
}

# Whole or not at all; what is to be started keeps that right.
zip_to() {
    (cd "$work" && cmake -E tar cf "$file.part" --format=zip "$@")
    mv "$file.part" "$file"
    say "wrote $file, $(du -k "$file" | cut -f1) KiB"
}

case $kind in
    student)
        files | grep -Ev "$not_for_students" | copy "$work/radlab"
        for check in layers.txt CMakeLists.txt; do
            mkdir -p "$work/radlab/cmake/checks"
        done
        cp "$root/cmake/checks/layers.txt" "$work/radlab/cmake/checks/"
        mkdir -p "$work/radlab/.github/workflows"
        cp "$root/packaging/classroom.yml" "$work/radlab/.github/workflows/classroom.yml"
        zip_to radlab
        say "next: unpack it in an empty folder and run ./radlab check" ;;
    gradescope)
        files | grep -Ev '^(\.ci|\.github)/' | copy "$work/radlab"
        cp "$root/packaging/setup.sh" "$root/packaging/run_autograder" "$work/"
        chmod +x "$work/setup.sh" "$work/run_autograder"
        zip_to setup.sh run_autograder radlab
        say "next: upload it as the assignment's autograder, with the base image Debian 12 or Ubuntu 22.04 or newer" ;;
esac
