#!/bin/sh
# Tests of what containers refuse: ContainerTest.sh PROGRAM PROJECT CLAIM, the program being check. The claim names the user and what is
# refused, separated by commas; in there, right, unwritten and wrong submissions get what they get elsewhere.
set -eu
program=$1 project=$2 claim=$3
folder=$(dirname "$program")

skip() { echo "-- skipped: $*"; exit 0; }
asks_for() { case ", $claim," in *", $1,"*) return 0 ;; esac; return 1; }

other='setpriv --reuid=61234 --regid=61234 --clear-groups --inh-caps=-all'

# Whether the clone lies where another user may not go, as below the home of root.
is_closed() { asks_for "an ordinary user" && [ "$(id -u)" = 0 ] && [ -z "${RADLAB_ORDINARY-}" ] && ! $other test -r "$program"; }

changes_mounts() {
    for what in "bubblewrap missing" "bubblewrap failing" "a clone that only root enters" "a read-only clone" "no /proc" "/tmp noexec"; do
        ! asks_for "$what" || return 0
    done
    is_closed
}

# Puts the clone into a folder of this mode; what lay beside it is hidden.
enclose() {
    mkdir /mnt/clone
    mount --bind "$project" /mnt/clone
    mount -t tmpfs -o mode="$1" none "$(dirname "$project")"
    mkdir "$project"
    mount --move /mnt/clone "$project"
}

# Changes what this mount namespace shows; nothing outside it.
prepare_mounts() {
    mount -t tmpfs none /mnt
    if asks_for "bubblewrap missing" && [ -e /usr/bin/bwrap ]; then mount --bind /dev/null /usr/bin/bwrap; fi
    if asks_for "bubblewrap failing"; then
        [ -x /usr/bin/bwrap ] || skip "no bubblewrap is there to be replaced"
        printf '#!/bin/sh\necho "bwrap: No permissions to create new namespace" >&2\nexit 1\n' >/mnt/bwrap
        chmod 755 /mnt/bwrap
        mount --bind /mnt/bwrap /usr/bin/bwrap
    fi
    if asks_for "a clone that only root enters"; then enclose 0700; elif is_closed; then enclose 0755; fi
    if asks_for "a read-only clone"; then
        mount --bind "$project" "$project"
        mount -o remount,bind,ro "$project"
    fi
    if asks_for "no /proc"; then mount -t tmpfs none /proc; fi
    if asks_for "/tmp noexec"; then mount -t tmpfs -o noexec,mode=1777 none /tmp; fi
}

# Starts this script again where the claim says, step by step: mounts, user, calls.
enter() {
    stage=$1
    shift
    case $stage in
        mounts)
            changes_mounts || exec env RADLAB_STAGE=user sh "$0" "$@"
            privileged=
            [ "$(id -u)" = 0 ] || privileged=-r
            unshare $privileged -m true 2>/dev/null || skip "no mount namespace can be made here"
            exec env RADLAB_STAGE=user unshare $privileged -m sh "$0" "$@" ;;
        user)
            ! changes_mounts || prepare_mounts
            cd /
            asks_for "an ordinary user" && [ -z "${RADLAB_ORDINARY-}" ] || exec env RADLAB_STAGE=calls sh "$0" "$@"
            command -v setpriv >/dev/null || skip "setpriv is not there"
            $other test -r "$program" || skip "other users may not read $project"
            exec env RADLAB_STAGE=calls HOME=/nowhere $other sh "$0" "$@" ;;
        calls)
            refused=
            ! asks_for "no namespaces" || refused="namespaces"
            ! asks_for "no filters" || refused="$refused filters"
            [ -n "$refused" ] || exec env RADLAB_STAGE=within sh "$0" "$@"
            [ -x "$folder/refuse-calls" ] || skip "libseccomp is not there, so that nothing can be refused"
            "$folder/refuse-calls" $refused -- true || skip "the kernel lets nobody refuse calls here"
            exec env RADLAB_STAGE=within "$folder/refuse-calls" $refused -- sh "$0" "$@" ;;
    esac
}

case ${RADLAB_STAGE-} in
    '')
        asks_for "an ordinary user" || [ "$(id -u)" = 0 ] || skip "these tests do not run as root"
        [ "$(id -u)" = 0 ] || export RADLAB_ORDINARY=1  # also where a namespace calls it root
        enter mounts "$@" ;;
    within) . "$(dirname "$0")/ProgramTest.sh" ;;
    *) enter "$RADLAB_STAGE" "$@" ;;
esac

# What is lacking is named in one line, and only what is.
notes() {
    lacking=
    if asks_for "no namespaces" || asks_for "bubblewrap missing" || asks_for "bubblewrap failing" || asks_for "no /proc"; then
        lacking=namespaces
    fi
    ! asks_for "no filters" || lacking="${lacking:+$lacking, }system call filter"
    [ "$(wc -l <err)" -le 1 ] || wrong "$(cat err)"
    [ -z "$lacking" ] || says err "without $lacking"
}

# A right one that also tries to write a file, as students do to see what happens.
{
    printf '#include <fstream>\nstatic void note() { std::ofstream("note.txt") << "here" << std::flush; }\n'
    sed 's/^MyPolygon\* calcFF(Hemicube\* hemicube) {$/& note();/' "$project/solutions/ProgRef.cpp"
} >right.cpp
[ "$(grep -c 'note();' right.cpp)" = 1 ] || wrong "the solution reads otherwise than this test expects"
run 6 --file right.cpp
exits 0
notes
run 1 --file "$project/exercises/ProgRef.cpp"
exits 1
says out 'next: write maxenergy_patch (stage 1)'
printf '#include "ProgRef.h"\n\nint a = b;\n' >wrong.cpp
run --file wrong.cpp
exits 2
says out 'wrong.cpp:3:9: error: '
asks_for "everything runs" || exit 0

# A whole class, and the programs that a student starts.
mkdir -p class/ada class/bob
cp "$project/solutions/ProgRef.cpp" class/ada
cp wrong.cpp class/bob/ProgRef.cpp
code=0
"$folder/grade" class --out graded >out 2>err </dev/null || code=$?
exits 0
says graded/grades/marks.csv ',100,100,10,20,20,15,15,20,'
"$folder/demo-exercise" --out demo >out 2>err || wrong "$(cat err)"
[ -s demo/index.html ] || wrong "no page: $(cat out)"
cp "$project/exercises/ProgRef.cpp" mine.cpp
env --default-signal=INT "$program" --watch --file mine.cpp >out 2>err </dev/null &
watcher=$!
for _ in $(seq 600); do
    ! grep -q 'next: write maxenergy_patch' out || break
    kill -0 $watcher 2>/dev/null || break
    sleep 0.1
done
kill -INT $watcher 2>/dev/null || true
wait $watcher || true
says out 'next: write maxenergy_patch'
asks_for "as root" && [ -x "$folder/view" ] && command -v xvfb-run >/dev/null || exit 0
xvfb-run -a "$folder/view" --solution --bench 1 --folder "$work/view" >out 2>err || wrong "$(cat out err)"
says out shots
