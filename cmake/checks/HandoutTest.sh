#!/bin/sh
# Builds the handout in a copy: HandoutTest.sh PROJECT
set -eu
project=$1
for tool in python3 pandoc chromium; do
    command -v "$tool" >/dev/null || { echo "-- skipped: $tool was not found; ./radlab handout installs it"; exit; }
done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
wrong() { echo "the handout: $*" >&2; exit 1; }

mkdir "$work/resources"
cp -R "$project/handout" "$work"
cp "$project/resources/references.bib" "$work/resources"
python3 "$work/handout/build.py" >"$work/said" || wrong "it does not build: $(cat "$work/said")"

cd "$work/out/handout"
for page in index start radiosity stage-1 stage-6 going-on instructors references; do
    [ -s "$page.html" ] || wrong "no page $page.html"
done
[ "$(find . -maxdepth 1 -name '*.html' | wc -l)" = $(($(find "$work/handout" -name '[0-9][0-9]-*.md' | wc -l) + 1)) ] || wrong "pages: $(ls)"
grep -q '<math' stage-6.html || wrong "no equations in MathML"
! grep -l '{{' ./*.html || wrong "a number was not filled in"
! grep -hoE '(src="|<link[^>]*href=")https?:' ./*.html || wrong "something is fetched from a network"
grep -hoE '(src|href)="[^"]*"' ./*.html | sed 's/.*="//; s/"$//; s/#.*//' | grep -v : | sort -u | while read -r name; do
    [ -z "$name" ] || [ -e "$name" ] || wrong "a page refers to $name, which is not there"
done
[ "$(head -c 5 radlab.pdf)" = %PDF- ] && [ "$(wc -c <radlab.pdf)" -gt 300000 ] || wrong "the PDF: $(ls -l radlab.pdf)"
