#!/bin/sh
# Tests of the program study as its user sees it: StudyTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"
room=$project/resources/scenes/furnace.x3d

case $claim in
    "a small study writes its files whole, and goes on without measuring again")
        run "$room" --patches 60 --limit 100 --out "a folder"
        exits 0
        says out ' 0 kept as they were'
        for name in results.csv index.html picture_furnace.png map_furnace_exact.png; do
            [ -s "a folder/$name" ] || wrong "no $name"
        done
        says 'a folder/index.html' 'For this error take that method'
        if command -v gnuplot >/dev/null; then
            tail -c 8 'a folder/plot_furnace_solver.svg' | grep -q '</svg>' || wrong "a plot that is not whole"
        else
            says err 'gnuplot-nox'
        fi
        [ -z "$(find . -name '*.part')" ] || wrong "left behind: $(ls 'a folder')"
        measured=$(sed -n 's/^furnace: \([0-9]*\) settings measured.*/\1/p' out)
        [ "$measured" -gt 20 ] || wrong "measured $measured settings"
        [ "$(wc -l <'a folder/results.csv')" = $((measured + 1)) ] || wrong "$(cat 'a folder/results.csv')"
        cp 'a folder/results.csv' before.csv
        run "$room" --patches 60 --limit 100 --out "a folder"
        exits 0
        says out "0 settings measured, $measured kept as they were"
        cmp before.csv 'a folder/results.csv'
        size=$(wc -c <before.csv)
        head -c $((size - 9)) before.csv >'a folder/results.csv'
        run "$room" --patches 60 --limit 100 --out "a folder"
        exits 0
        says out "1 settings measured, $((measured - 1)) kept as they were"
        ;;
    "Ctrl-C keeps what is measured, on a page, and the same command goes on")
        cp "$room" second.x3d
        interrupted 'furnace: .* settings measured' "$room" second.x3d --patches 60 --limit 100 --out made
        exits 130
        says out 'stopped by Ctrl-C'
        says out 'the same command goes on'
        says made/index.html 'furnace'
        [ -z "$(find . -name '*.part')" ] || wrong "left behind: $(ls made)"
        run second.x3d "$room" --patches 60 --limit 100 --out made
        exits 0
        says out 'furnace: 0 settings measured'
        ;;
    "what is wrong is said before any work, with exit code 2, and leaves no file")
        run "$room" --repeat 0
        exits 2
        run "$room" --limit -1
        exits 2
        run "$room" --slow
        exits 2
        run absent.x3d --out made
        exits 2
        says err 'absent.x3d: '
        run "$project/resources/scenes/dark.x3d" --out made
        exits 2
        says err 'nothing emits light'
        run "$room" "$room" --out made
        exits 2
        says err "two scenes named 'furnace'"
        run "$room" --out out/made
        exits 2
        says err 'the folder cannot be made'
        [ "$(ls)" = "$(printf 'err\nout')" ] || wrong "left behind: $(ls)"
        mkdir mine
        echo 'name,mark' >mine/results.csv
        run "$room" --patches 60 --out mine
        exits 2
        says err 'mine/results.csv:1: these are not the columns'
        [ "$(ls mine)" = results.csv ] || wrong "left behind: $(ls mine)"
        ;;
    *) wrong "no such claim" ;;
esac
