#!/bin/sh
# Runs check on what was handed in, and ends as it does: judge.sh RADLAB SUBMISSION FLAGS...
# All paths are absolute. Exit code 3, as check's own: the machine failed.
set -u
radlab=$1 submission=$2
shift 2

work=$(mktemp -d) || exit 3
trap 'rm -rf "$work"' EXIT
mkdir "$work/extensions" || exit 3

# Takes a file where it belongs, else the one of that name that lies least deep; a link is none. It is judged under our name, not theirs.
take() {
    name=$(find . \( -path "./$1" -type f -printf '0 %p\0' \) -o \( -name "${1##*/}" -type f -printf '%d %p\0' \) |
        LC_ALL=C sort -zn | head -zn 1 | tr -d '\0')
    [ -n "$name" ] || return 1
    cp -- "${name#* }" "$work/${1#exercises/}" || exit 3
}

extensions=
if cd "$submission"; then
    take exercises/ProgRef.cpp
    for stub in "$radlab"/exercises/extensions/*.cpp; do
        ! take "exercises/extensions/${stub##*/}" || extensions=extensions
    done
fi

cd "$work" || exit 3
"$radlab/build/release/bin/check" --file ProgRef.cpp ${extensions:+--extensions "$extensions"} "$@"
