#!/bin/sh
# Tests of the program check as a student uses it: CheckTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"
watcher=
trap '[ -z "$watcher" ] || kill "$watcher" 2>/dev/null; rm -rf "$work"' EXIT

# Waits until the watcher has said this, or has ended.
waits() {
    until_ready "$watcher" grep -qF -- "$1" log
    says log "$1"
}

case $claim in
    "0 for all marks, 1 for marks lost, 2 for a file that does not compile or wrong flags")
        run --file "$project/solutions/ProgRef.cpp"
        exits 0
        says out 'score: 100/100'
        run --file "$project/exercises/ProgRef.cpp"
        exits 1
        tail -n 1 out >last
        says last 'next: write maxenergy_patch (stage 1)'
        printf '#include "ProgRef.h"\n\nint a = b;\n' >wrong.cpp
        run --file wrong.cpp
        exits 2
        says out 'wrong.cpp:3:9: error: '
        run --file absent.cpp
        exits 2
        says err 'absent.cpp: found no such file'
        run 99
        exits 2
        says err 'expected one of 1 maxenergy_patch'
        run --nonsense
        exits 2 ;;
    "one stage, by number or name, and what it writes is whole or not there")
        sed 's|static_cast<float>(M_1_PI) / distance2|1.0f / distance2|' "$project/solutions/ProgRef.cpp" >mine.cpp
        run 2 --file mine.cpp --json verdict.json --junit verdict.xml --html --out page
        exits 1
        says out 'The factor 1/π is missing'
        says verdict.json '"missing-inverse-pi"'
        says verdict.json '"radlab/result/1"'
        says verdict.xml '<testsuite'
        says page/index.html 'missing'
        [ "$(find page -name '*.png' | wc -l)" -eq 3 ] || wrong "$(ls page)"
        [ "$(wc -l <out)" -le 26 ] || wrong "$(cat out)"
        ! grep -q "$(printf '\033')" out || wrong "colour, and no terminal"
        run distributeEnergy --file mine.cpp
        exits 0
        run 2 --file mine.cpp --json absent/verdict.json
        exits 2 ;;
    "extensions are judged apart, each out of its own file, and are worth no marks")
        mkdir mine
        run extensions --extensions mine
        exits 1
        says out 'extensions: 0/30, beside the marks'
        sed 's/std::sqrt(r2)/r2/; s/std::sqrt(1.0f - r2)/std::sqrt(1.0f - r * r)/' "$project/solutions/extensions/Hemisphere.cpp" >mine/Hemisphere.cpp
        cp "$project/solutions/extensions/Mirror.cpp" mine/
        run extensions --extensions mine --json verdict.json --seed 7
        exits 1
        says out 'hemisphereFF'
        says out ' 10  mirrorScene   10/10  right'
        says verdict.json '"max_score": 0,'
        run hemisphere --extensions mine --hint
        exits 1
        says out 'The radius on the disc is drawn evenly'
        says out 'look at: Which function of an even random number'
        run mirror --extensions mine
        exits 0
        says out 'extensions: 10/10, beside the marks'
        printf '#include "Extensions.h"\n\nint a = b;\n' >mine/AntiAliasing.cpp
        run extensions --extensions mine
        exits 2
        says out 'mine/AntiAliasing.cpp:3:9: error: '
        says out ' 10  mirrorScene   10/10  right'
        run 6 --file "$project/solutions/ProgRef.cpp"
        exits 0
        ! grep -q extension out || wrong "$(cat out)" ;;
    "every verdict is written, also on a file that does not compile, and that of autograders where there is none")
        printf '#include "ProgRef.h"\n\nint a = b;\n' >wrong.cpp
        run --file wrong.cpp --json verdict.json --junit verdict.xml --gradescope results.json --classroom50 result.json --html --out page
        exits 2
        says out 'wrong.cpp:3:9: error: '
        says verdict.json '"compiled": false'
        says verdict.xml 'wrong.cpp:3:9: error: '
        says results.json 'wrong.cpp:3:9: error: '
        says results.json '"score": 0'
        says result.json '"max-score": 100,'
        says page/index.html 'wrong.cpp:3:9: error: '
        printf ' \n' >empty.cpp
        for file in empty.cpp absent.cpp .; do
            rm results.json result.json
            run --file "$file" --gradescope results.json --classroom50 result.json --json nothing.json
            exits 2
            says err "$file: found no such file or an empty one"
            says results.json 'There was no file to grade, or an empty one.'
            says result.json '"max-score": 100,'
            [ ! -e nothing.json ] || wrong "a verdict on nothing"
        done
        run 1 --file "$project/solutions/ProgRef.cpp" --gradescope results.json
        exits 0
        says results.json '"status": "passed"' ;;
    "watch judges on every save, and keeps the last verdict on a compile error")
        cp "$project/exercises/ProgRef.cpp" mine.cpp
        "$program" --watch --file mine.cpp >log 2>&1 &
        watcher=$!
        waits '--- '
        waits 'next: write maxenergy_patch (stage 1)'
        sed 's|throw NotImplemented("maxenergy_patch");|return polygons.empty() ? nullptr : polygons[0];|' mine.cpp >new
        cat new >mine.cpp
        waits 'wrong'
        echo 'int a = b;' >>mine.cpp
        waits 'error: '
        waits 'the last verdict'
        cp "$project/solutions/ProgRef.cpp" mine.cpp
        waits 'score: 100/100'
        wait "$watcher" || wrong "ended with $?"
        watcher= ;;
    "watch judges an extension out of its own file on every save")
        mkdir mine
        cp "$project/exercises/extensions/Mirror.cpp" mine/
        "$program" mirrorScene --watch --extensions mine >log 2>&1 &
        watcher=$!
        waits 'write mirrorScene (extension)'
        echo 'int a = b;' >>mine/Mirror.cpp
        waits 'error: '
        cp "$project/solutions/extensions/Mirror.cpp" mine/
        waits 'extensions: 10/10'
        wait "$watcher" || wrong "ended with $?"
        watcher=
        run extensions --watch
        exits 2
        says err 'watch follows one file: name the extension, hemisphereFF say' ;;
    "Ctrl-C ends check and watch with exit code 130 and one line, and leaves no folder")
        # A stage without an end, so that what is judged is the same at every speed.
        sed 's|throw NotImplemented("maxenergy_patch");|for (;;) polygons.size();|' "$project/exercises/ProgRef.cpp" >mine.cpp
        mkdir scratch
        chmod 711 .  # what is boxed is another user
        export TMPDIR="$work/scratch"
        judging='[ -n "$(find scratch -name "*.so" 2>/dev/null)" ]'
        interrupted_when "$judging" --file mine.cpp --json verdict.json
        exits 130
        says err 'interrupted: nothing'
        [ "$(grep -vc '^note: ' err)" -eq 1 ] || wrong "$(cat err)"
        [ ! -e verdict.json ] || wrong "a verdict on what was not judged"
        [ -z "$(ls scratch)" ] || wrong "left behind: $(ls scratch)"
        for ready in "$judging" "grep -q 'Ctrl-C ends it' out"; do
            interrupted_when "$ready" --watch --file mine.cpp
            exits 130
            says out 'stopped by Ctrl-C'
            ! grep -v '^note: ' err || wrong "$(cat err)"
            [ -z "$(ls scratch)" ] || wrong "left behind: $(ls scratch)"
        done ;;
    *) wrong "no such claim" ;;
esac
