#!/bin/sh
# Packs radlab for others: package.sh student|gradescope|classroom50 [FILE]
set -eu

usage() {
    cat <<'END'
usage: ./radlab package student [FILE]      what students get, without the solutions: out/radlab-student.zip
       ./radlab package gradescope [FILE]   the autograder to upload to Gradescope: out/autograder.zip
       ./radlab package classroom50 [FILE]  the autograder for an assignment of Classroom 50: out/classroom50.zip

What is packed is what git has in its index, as it stands in the working tree; without git, the folders of the project.
END
}
say() { printf 'radlab: %s\n' "$*" >&2; }
fail() { say "package: $*"; exit 2; }

kind=${1-}
case $kind in
    student) file=${2-out/radlab-student.zip} ;;
    gradescope) file=${2-out/autograder.zip} ;;
    classroom50) file=${2-out/classroom50.zip} ;;
    --help | -h) usage; exit ;;
    *) fail "found '$kind', expected student, gradescope or classroom50" ;;
esac
[ $# -le 2 ] || fail "found '$3', expected one file to write"
case $file in *.zip) ;; *) fail "$file: expected a name that ends in .zip" ;; esac
[ ! -d "$file" ] || fail "$file is a folder"

root=$(CDPATH='' cd -- "$(dirname "$0")/.." && pwd -P)
mkdir -p -- "$(dirname -- "$file")" || exit 2
file=$(CDPATH='' cd -- "$(dirname -- "$file")" && pwd -P)/$(basename -- "$file")
work=$(mktemp -d)
part=$(mktemp "$file.XXXXXX") || { rm -rf "$work"; exit 2; }
trap 'rm -rf "$work" "$part"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

# What a package may hold; of exercises the students' files alone, since others beside them may be somebody's solution.
packed='^(framework|grader/(protocol|sandbox|stages|judge|report|worker|apps)|resources|handout|cmake|\.vscode)/
^grader/CMakeLists\.txt$
^exercises/(ProgRef|extensions/(Hemisphere|AntiAliasing|Mirror))\.cpp$
^(radlab|LICENSE|CMakeLists\.txt|CMakePresets\.json|vcpkg\.json|\.gitignore|\.editorconfig|\.clang-format)$'
# Of that, what quotes solutions, needs them, or tests radlab itself; then what .gitignore names, for trees without git.
left_out='(Test|Fuzz)\.cpp$
^framework/(SolutionTests\.cmake$|apps/(bench|study|SolverBench|EngineBench|[Hh]andout|view-picture))
^grader/apps/(grade|Grade|Grading|TryAttacks|unpack|references|bench-grade|CheckBench)
^resources/(broken|fuzz|study|classroom)/
^cmake/checks/
(^|/)(build|out|\.cache|__pycache__|cmake-build-[^/]*|\.vs|\.idea)/
(~|\.DS_Store|compile_commands\.json|CMakeUserPresets\.json|\.orig|\.rej|\.swp)$'

# The files of the project, of those the ones that may be packed; for git, what else would be.
unset GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE
known() { git -C "$root" ls-files "$@"; }
found() { (cd "$root" && find . \( -path ./build -o -path ./out -o -path ./.git \) -prune -o -type f -print | cut -c3-); }
chosen() { grep -E "$packed" | grep -Ev "$left_out" || true; }
files() {
    if [ ! -e "$root/.git" ] || ! known >"$work/known" 2>/dev/null; then
        found | chosen
        return
    fi
    chosen <"$work/known"
    known --others --exclude-standard | chosen | while IFS= read -r name; do say "left out, since git does not know it: $name"; done
}

# What students may have, in the folder named; links are left out, wherever they lead. Rights are the same whoever
# packs; times are new, so that what is unpacked over an older package is built again.
copy() {
    mkdir -p "$1"
    { files; echo cmake/checks/layers.txt; } | while IFS= read -r name; do
        [ ! -f "$root/$name" ] || [ -h "$root/$name" ] || printf '%s\n' "$name"
    done >"$work/names"
    tar -C "$root" -cf "$work/files.tar" -T "$work/names"
    tar -C "$1" -xmf "$work/files.tar"
    cp "$root/packaging/README-student.md" "$1/README.md"
    find "$1" -type f -exec chmod u=rwX,go=rX {} +
    chmod 755 "$1/radlab"
}

# The kit, and beside it at the top what runs it there.
autograder() {
    copy "$work/zip/radlab"
    for script; do cp "$root/packaging/$script" "$work/zip/"; done
    (cd "$work/zip" && chmod 755 "$@")
}

# Where Classroom 50 is to run it, with the packages that the script radlab would install.
runtime() {
    eval "$(sed -n "/^build_packages='/,/'\$/p" "$root/radlab")"
    # shellcheck disable=SC2086,SC2154
    printf '{"runs-on": "ubuntu-24.04", "apt": [%s]}\n' "$(printf '"%s"\n' $build_packages | paste -sd, -)"
}

# Whole or not at all.
zip_all() {
    cd "$work/zip"
    find . -type f | cut -c3- | LC_ALL=C sort >"$work/names"
    cmake -E tar cf "$part" --format=zip --files-from="$work/names"
    chmod 644 "$part"
    mv "$part" "$file"
    say "wrote $file ($(du -k "$file" | cut -f1) KiB)"
}

[ "$(grep -c 'throw NotImplemented("' "$root/exercises/ProgRef.cpp")" = 6 ] ||
    fail "exercises/ProgRef.cpp: found functions that are written, expected the six stubs that students begin with"
for stub in Hemisphere AntiAliasing Mirror; do
    stub=exercises/extensions/$stub.cpp
    [ ! -e "$root/$stub" ] || grep -q '^ *throw NotImplemented("' "$root/$stub" ||
        fail "$stub: found an extension that is written, expected the stub that students begin with"
done
command -v cmake >/dev/null || fail "CMake is needed; ./radlab check installs it"
case $kind in
    student)
        copy "$work/zip/radlab"
        mkdir -p "$work/zip/radlab/.github/workflows"
        cp "$root/packaging/check.yml" "$work/zip/radlab/.github/workflows/check.yml"
        zip_all
        say "next: unpack it in an empty folder and run ./radlab check there" ;;
    gradescope)
        autograder setup.sh run_autograder judge.sh
        zip_all
        say "next: upload it as the assignment's autograder, on an image with CMake 3.25 and GCC 12 or newer (Ubuntu 24.04, Debian 12)" ;;
    classroom50)
        autograder autograder.py judge.sh
        runtime >"$work/zip/runtime.json"
        zip_all
        say "next: unpack it in CLASSROOM/autograders/ASSIGNMENT/ of your repository classroom50, and give the assignment the block in runtime.json" ;;
esac
