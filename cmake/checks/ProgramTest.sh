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
skip() { echo "-- skipped: $*"; exit 0; }  # where this machine lacks what the claim is about
says() { grep -qF -- "$2" "$1" || wrong "expected '$2', found: $(cat "$1")"; }

# Waits until a command succeeds, or that process ends, which the claims after it then tell.
until_ready() {
    waited_for=$1
    shift
    until "$@"; do
        kill -0 "$waited_for" 2>/dev/null || return 0
        sleep 0.1
    done
}

# Starts the program, and presses Ctrl-C once a command succeeds. In a shell's background SIGINT is ignored, which a program that is
# started by env can undo.
interrupted_when() {
    ready=$1
    shift
    env --default-signal=INT "$program" "$@" >out 2>err </dev/null &
    child=$!
    until_ready $child eval "$ready"
    kill -INT $child 2>/dev/null || true  # what has ended by itself, its exit code tells
    code=0
    wait $child || code=$?
}

# The same once its progress shows this.
interrupted_in() {
    shown=$1
    shift
    RADLAB_PROGRESS=1
    export RADLAB_PROGRESS
    interrupted_when 'grep -q -- "$shown" err' "$@"
    unset RADLAB_PROGRESS
}

# The same once it has printed a line with this.
interrupted() {
    line=$1
    shift
    interrupted_when 'grep -q -- "$line" out' "$@"
}
