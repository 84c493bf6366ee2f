# What tests of programs share, read by …Test.sh PROGRAM PROJECT CLAIM: a folder of its own that goes when the test ends, and words to
# claim with.
set -eu
program=$1 project=$2 claim=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

wrong() { echo "$claim: $*" >&2; exit 1; }
run() { code=0; "$program" "$@" >out 2>err </dev/null || code=$?; }
exits() { [ "$code" = "$1" ] || wrong "exit code $code, expected $1: $(cat out err)"; }
says() { grep -qF -- "$2" "$1" || wrong "expected '$2', found: $(cat "$1")"; }
