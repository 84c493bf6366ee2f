#!/bin/sh
# The documentation of the source has no warning: ApiTest.sh PROJECT
set -eu
command -v doxygen >/dev/null || { echo "-- skipped: doxygen was not found; ./radlab handout --api installs it"; exit; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$1"
{ cat handout/Doxyfile; printf 'OUTPUT_DIRECTORY = %s\nGENERATE_HTML = NO\nGENERATE_XML = YES\nXML_PROGRAMLISTING = NO\n' "$work"; } >"$work/Doxyfile"
doxygen "$work/Doxyfile"
grep -q 'id="classHemicube"\|refid="classHemicube"' "$work/xml/index.xml" || { echo "no class Hemicube in it" >&2; exit 1; }
mkdir "$work/wrong"
printf '#pragma once\n/// Adds.\n///\n/// @param c not there\nint add(int a, int b);\n' >"$work/wrong/Wrong.h"
{ cat "$work/Doxyfile"; printf 'INPUT = %s\n' "$work/wrong"; } >"$work/Doxyfile.wrong"
! doxygen "$work/Doxyfile.wrong" 2>/dev/null || { echo "a comment on a parameter that is not there was not found" >&2; exit 1; }
