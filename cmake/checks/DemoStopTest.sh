#!/bin/sh
# Tests of the program demo when it is stopped: DemoStopTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"

case $claim in
    "Ctrl-C leaves a page with the pictures made so far, and exit code 130")
        interrupted 'Stage 5' --out made
        exits 130
        says out 'stopped by Ctrl-C: the page shows the '
        pictures=$(sed -n 's/.*shows the \([0-9]*\) pictures.*/\1/p' out)
        [ "$pictures" -ge 7 ] && [ "$pictures" -lt 10 ] || wrong "$pictures pictures"
        [ "$(find made -name '[0-9]*.png' | wc -l)" = "$pictures" ] || wrong "$(ls made)"
        says made/index.html '07_patch_ids.png'
        [ -z "$(find . -name '*.part')" ] || wrong "left behind: $(ls made)"
        ;;
    *) wrong "no such claim" ;;
esac
