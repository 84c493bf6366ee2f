#!/bin/sh
# Tests of what is packed for others: PackageTest.sh PROGRAM PROJECT CLAIM, PROGRAM being packaging/package.sh, or check for the autograder.
# shellcheck disable=SC2015  # A && B || wrong is meant so
. "$(dirname "$0")/ProgramTest.sh"
unset RADLAB_PRESET GIT_DIR GIT_WORK_TREE GIT_INDEX_FILE

# A copy of the project without git, for strays.
copy_project() {
    mkdir "a copy"
    tar -C "$project" -cf - --exclude=./build --exclude=./out --exclude=./.git . | tar -C "a copy" -xf -
    program="$work/a copy/packaging/package.sh"
}
unpack() { mkdir "$2" && (cd "$2" && cmake -E tar xf "$1") && (cd "$2" && find . -type f | cut -c3- | LC_ALL=C sort) >"$2.names"; }
has() { grep -qxF -- "$2" "$1.names" || wrong "$2 is not in it"; }
has_none() { ! grep -E -- "$2" "$1.names" >found || wrong "it holds $(head -n 3 found)"; }

stray() { mkdir -p "$(dirname "a copy/$1")" && echo 'int stray;' >"a copy/$1"; }
strays() {
    for name in exercises/Solved.cpp exercises/extensions/Solved.cpp exercises/ProgRef.cpp~ submissions/student-07/ProgRef.cpp marks.csv build/release/a.cpp \
        out/check/index.html framework/base/Error.h.orig framework/.cache/a.cpp grader/stages/manifest.json~ CMakeUserPresets.json; do
        stray "$name"
    done
    ln -s /etc/passwd "a copy/framework/base/link.cpp"
}
no_strays() { has_none "$1" '/Solved\.cpp$|~$|student-07|marks|/build/|/out/|\.orig$|\.cache|UserPresets|link|\.git/'; }

# Runs the autograder on what lies in submission; its results are JSON with that score.
autograde() {
    rm -f autograder/results/results.json
    RADLAB_AUTOGRADER=$work/autograder sh autograder/source/run_autograder >out 2>err || wrong "exit code $?: $(cat err)"
    cmake -P valid.cmake 2>found || wrong "$(cat found autograder/results/results.json)"
    grep -q "\"score\": $1,\$" autograder/results/results.json || grep -q "\"score\": $1, \"output\"" autograder/results/results.json ||
        wrong "expected the score $1, found: $(cat autograder/results/results.json err)"
    says autograder/results/results.json "$2"
    rm -rf autograder/submission && mkdir -p autograder/submission/exercises
}

# Runs Classroom 50's autograder in a checkout; its exit code goes to $code.
runs_in() {
    code=0
    (cd "$1" && CLASSROOM=cs-a ASSIGNMENT=radiosity-1 ASSIGNMENT_TYPE=individual OWNER=ann-a SUBMISSION_TAG=submit/2026-11-23T08-15-00Z-a1b2c3d \
        COMMIT_URL=https://example.org/c RELEASE_URL=https://example.org/r REVIEW_URL=https://example.org/v \
        python3 "$work/bundle/autograder.py") >out 2>err </dev/null || code=$?
}

# The same; result.json keeps the contract, with that score and none, one or all tests passed, and release-body.md has these words.
marks_in() {
    runs_in "$1"
    exits 0
    python3 contract.py "$1/result.json" "$2" "$3" >found 2>&1 || wrong "$(tail -n 1 found): $(cat "$1/result.json")"
    says "$1/release-body.md" "$4"
    ! sed 1,2d "$1/release-body.md" | grep -v '^    ' || wrong "text that could be taken for Markdown"
    [ ! -s out ] || wrong "text that could be taken for a command: $(cat out)"
}
no_marks_in() {
    runs_in "$1"
    [ "$code" != 0 ] || wrong "exit code 0: $(cat err)"
    [ ! -e "$1/result.json" ] && [ ! -e "$1/release-body.md" ] || wrong "there is a mark"
    says err "$2"
    ! grep '^::' out || wrong "a command of a submission"
}

case $claim in
    "students get what check needs, and no line of the solutions")
        run student students.zip
        exits 0
        unpack ../students.zip new
        for name in radlab README.md LICENSE CMakeLists.txt exercises/ProgRef.cpp framework/course/ProgRef.h .gitignore \
            exercises/extensions/Hemisphere.cpp exercises/extensions/AntiAliasing.cpp exercises/extensions/Mirror.cpp framework/course/Extensions.h \
            grader/stages/manifest.json grader/apps/check.cpp resources/reference/calcFF.png .github/workflows/check.yml \
            handout/01-radiosity.md handout/build.py handout/figures/pair.svg; do
            has new "radlab/$name"
        done
        has_none new '/(solutions|mutants|attacks|batch|intake|packaging|\.ci)/|Test\.cpp$|grade\.cpp|BENCHMARKS'
        [ -x new/radlab/radlab ] && [ ! -x new/radlab/README.md ] || wrong "$(ls -l new/radlab)"
        cmp "$project/packaging/README-student.md" new/radlab/README.md
        cmp "$project/packaging/check.yml" new/radlab/.github/workflows/check.yml
        sed 's/^ *//' "$project/solutions/ProgRef.cpp" "$project/solutions/OlderStyle.cpp" \
            "$project"/solutions/extensions/Hemisphere.cpp "$project"/solutions/extensions/AntiAliasing.cpp "$project"/solutions/extensions/Mirror.cpp |
            awk 'length > 45 && !/^\/\/ [A-Z]/ && !/^(MyPolygon\*|void) [a-zA-Z]+\(const .*[{,]$/ && !/^for \(std::size_t i = 0; i < polygons/' | LC_ALL=C sort -u >lines
        [ "$(wc -l <lines)" -gt 25 ] || wrong "$(cat lines)"
        ! grep -rFf lines new >found || wrong "$(head -n 3 found)" ;;
    "what students get can be configured, and has no program that needs the solutions")
        copy_project
        run student students.zip
        unpack ../students.zip new
        cmake -G Ninja -S new/radlab -B built -DCMAKE_BUILD_TYPE=Release >out 2>&1 || wrong "$(cat out)"
        ninja -C built -t targets all >targets
        says targets 'demo-exercise: phony'
        ! grep -E '^(demo|study|grade|unpack|bench|solution-test): ' targets || wrong "programs that it should not have" ;;
    "strays, links and what git ignores stay out, with git and without")
        copy_project
        strays
        run student plain.zip
        exits 0
        unpack ../plain.zip plain
        no_strays plain
        command -v git >/dev/null || skip "git is missing"
        (cd "a copy" && git init -q && git add CMakeLists.txt LICENSE radlab framework grader exercises/ProgRef.cpp exercises/extensions/Hemisphere.cpp resources cmake) 2>err ||
            wrong "$(cat err)"
        stray framework/base/Mine.cpp
        run student "a new folder/known.zip"
        exits 0
        says err 'left out, since git does not know it: framework/base/Mine.cpp'
        unpack "$work/a new folder/known.zip" known
        no_strays known
        has_none known Mine
        has known radlab/exercises/ProgRef.cpp ;;
    "what is wrong is said in one line, and an older package stays as it was")
        copy_project
        echo older >old.zip
        for words in 'pupil old.zip' 'student old.zip more' 'student old.tar' 'student .'; do
            # shellcheck disable=SC2086
            run $words
            exits 2
            [ "$(wc -l <err)" -eq 1 ] || wrong "$(cat err)"
        done
        cp "a copy/solutions/ProgRef.cpp" "a copy/exercises/ProgRef.cpp"
        run student old.zip
        exits 2
        says err 'expected the six stubs'
        cp "$project/exercises/ProgRef.cpp" "a copy/exercises/ProgRef.cpp"
        cp "a copy/solutions/extensions/Hemisphere.cpp" "a copy/exercises/extensions/"
        run student old.zip
        exits 2
        says err 'Hemisphere.cpp: found an extension that is written'
        echo older | cmp - old.zip
        [ "$(ls)" = "$(printf 'a copy\nerr\nold.zip\nout')" ] || wrong "$(ls)" ;;
    "the autograder for Gradescope has its scripts at the top, and no solution")
        run gradescope autograder.zip
        exits 0
        unpack ../autograder.zip new
        [ -x new/setup.sh ] && [ -x new/run_autograder ] && [ -f new/judge.sh ] && [ -x new/radlab/radlab ] || wrong "$(ls -l new)"
        has_none new '/(solutions|mutants|attacks|\.github)/' ;;
    "the autograder for Classroom 50 has its scripts and packages at the top, can be fetched, and holds no solution")
        run classroom50 autograder.zip
        exits 0
        unpack ../autograder.zip new
        [ "$(ls new)" = "$(printf 'autograder.py\njudge.sh\nradlab\nruntime.json')" ] || wrong "$(ls new)"
        [ -x new/radlab/radlab ] || wrong "$(ls -l new/radlab)"
        has_none new '/(solutions|mutants|attacks|\.github)/'
        [ "$(tar -cz new | wc -c)" -lt 10485760 ] || wrong "larger than the 10 MiB that Classroom 50 fetches"
        # shellcheck disable=SC2016  # CMake's
        printf 'file(READ new/runtime.json text)\nstring(JSON apt GET "${text}" apt)\nstring(JSON on GET "${text}" runs-on)\nmessage("${on} ${apt}")\n' >read.cmake
        cmake -P read.cmake 2>found || wrong "$(cat found)"
        for package in ubuntu-24.04 '"g++"' '"cmake"' '"libseccomp-dev"'; do says found "$package"; done ;;
    "the autograder for Gradescope writes results for every submission, whatever it holds")
        mkdir -p autograder/source/radlab/build/release/bin autograder/source/radlab/exercises autograder/submission/exercises
        cp -r "$project/exercises/extensions" autograder/source/radlab/exercises/
        cp "$project/packaging/run_autograder" "$project/packaging/judge.sh" autograder/source/
        ln -s "$program" autograder/source/radlab/build/release/bin/check
        # shellcheck disable=SC2016  # CMake's
        printf 'file(READ autograder/results/results.json text)\nstring(JSON score GET "${text}" score)\n' >valid.cmake
        autograde 0.0 'There was no file to grade'
        cp "$project/solutions/ProgRef.cpp" secret.cpp
        ln -s "$work/secret.cpp" autograder/submission/ProgRef.cpp
        autograde 0.0 'There was no file to grade'
        mkdir autograder/submission/exercises/ProgRef.cpp
        autograde 0.0 'There was no file to grade'
        cp "$project/exercises/ProgRef.cpp" autograder/submission/exercises/
        autograde 0.0 '"outcome": "graded"'
        printf '#include "ProgRef.h"\n\nint a = b;\n' >autograder/submission/ProgRef.cpp
        autograde 0.0 'ProgRef.cpp:3:9: error: '
        mkdir -p "autograder/submission/a/deeper \$(touch $work/fooled)
folder"
        cp "$project/exercises/ProgRef.cpp" autograder/submission/
        cp "$project/exercises/ProgRef.cpp" autograder/submission/a/deeper*/
        cp "$project/solutions/ProgRef.cpp" autograder/submission/exercises/
        autograde 100.0 '"status": "passed"'
        [ ! -e fooled ] || wrong "a name was run"
        mkdir autograder/submission/exercises/extensions
        cp "$project/solutions/ProgRef.cpp" autograder/submission/
        cp "$project/solutions/extensions/Mirror.cpp" autograder/submission/
        cp "$project/exercises/extensions/Hemisphere.cpp" autograder/submission/exercises/extensions/
        autograde 100.0 'mirror'
        printf '#!/bin/sh\nexit 3\n' >broken
        chmod +x broken
        ln -sf "$work/broken" autograder/source/radlab/build/release/bin/check
        autograde 0 'The 0 is no mark' ;;
    "the autograder for Classroom 50 leaves marks that keep the contract, and none where the grader failed")
        command -v python3 >/dev/null || { echo "-- skipped: no python3"; exit 0; }
        mkdir -p bundle/radlab/build/release/bin bundle/radlab/exercises checkout/exercises/extensions
        cp "$project/packaging/autograder.py" "$project/packaging/judge.sh" bundle/
        cp -r "$project/exercises/extensions" bundle/radlab/exercises/
        echo 'echo built' >bundle/radlab/radlab
        ln -s "$program" bundle/radlab/build/release/bin/check
        cat >contract.py <<'END'
import json, re, sys
file, score, passed = sys.argv[1], int(sys.argv[2]), sys.argv[3]
result = json.load(open(file))
marks, tests = {"score", "max-score"}, result["tests"]
own = {"classroom": "cs-a", "assignment": "radiosity-1", "assignment_type": "individual", "owner": "ann-a", "schema": "classroom50/result/v1",
       "submission": "submit/2026-11-23T08-15-00Z-a1b2c3d", "commit": "https://example.org/c", "release": "https://example.org/r",
       "review": "https://example.org/v"}
assert set(result) == set(own) | marks | {"datetime", "tests"}, "its keys"
assert {key: result[key] for key in own} == own, "whose it is"
assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", result["datetime"]), "its time"
for test in tests:
    assert set(test) == marks | {"test-name", "passed"} and type(test["passed"]) is bool and test["test-name"], f"the test {test}"
    assert all(type(test[key]) is int for key in marks) and 0 <= test["score"] <= test["max-score"], f"the marks of {test}"
assert all(type(result[key]) is int and result[key] == sum(test[key] for test in tests) for key in marks), "its sums"
assert (result["score"], result["max-score"]) == (score, 100), f"the score {result['score']} of {result['max-score']}"
found = sum(test["passed"] for test in tests)
assert found == {"none": 0, "one": 1, "all": len(tests)}[passed], f"{found} of {len(tests)} tests passed"
END
        marks_in checkout 0 none 'found no such file or an empty one'
        cp "$project/exercises/ProgRef.cpp" checkout/exercises/
        cp "$project"/exercises/extensions/*.cpp checkout/exercises/extensions/
        echo '{"score": 100}' >secret
        ln -sf "$work/secret" checkout/result.json
        marks_in checkout 0 one 'next: write maxenergy_patch'
        [ "$(cat secret)" = '{"score": 100}' ] || wrong "it wrote through a link"
        printf '#include "ProgRef.h"\n\nint a = b;\n' >checkout/exercises/ProgRef.cpp
        marks_in checkout 0 none 'ProgRef.cpp:3:9: error: '
        cp "$project/solutions/ProgRef.cpp" checkout/exercises/
        marks_in checkout 100 all 'score: 100/100'
        printf '#!/bin/sh\necho ::error::forged\nexit 3\n' >broken
        chmod +x broken
        ln -sf "$work/broken" bundle/radlab/build/release/bin/check
        no_marks_in checkout 'the grader or the machine failed'
        printf '#!/bin/sh\nkill -9 $$\n' >broken
        no_marks_in checkout 'the grader or the machine failed'
        echo 'exit 2' >bundle/radlab/radlab
        echo '{"score": 100}' >checkout/result.json
        no_marks_in checkout 'exit status 2'
        ! python3 bundle/autograder.py 2>err || wrong "it ran outside of Classroom 50"
        says err 'not set: CLASSROOM' ;;
    *) wrong "no such claim" ;;
esac
