#!/bin/sh
# Tries radlab as a new user does on a release of Debian: a bare system, a fresh clone, the README's two commands; one line of a table.
set -eu

usage() {
    cat <<'END'
usage: packaging/try-release.sh RELEASE [--container] [--keep] [--mirror URL]

Makes a bare system of that release with debootstrap (bookworm, trixie, forky, sid), clones what is committed here into it, runs
./radlab demo and ./radlab test there, and prints a table: what was built, tests passed, failed and skipped, seconds. What both said stays
in out/try-release. Takes half an hour, 6 GB below $TMPDIR (/var/tmp), and root.

  --container  in a chroot, where namespaces are refused, as in many containers
  --keep       leaves the system where it is, and says how to enter it; an existing one is taken up again
  --mirror     where debootstrap and apt get their packages
END
}
say() { printf 'radlab: %s\n' "$*" >&2; }
fail() { say "try-release: $*"; exit 2; }

release='' kind=machine keep='' mirror=''
while [ $# -gt 0 ]; do
    case $1 in
        --container) kind=container ;;
        --keep) keep=1 ;;
        --mirror) mirror=${2-}; [ $# -eq 1 ] || shift ;;
        --help | -h) usage; exit ;;
        -*) fail "found $1, expected --container, --keep or --mirror" ;;
        *) [ -z "$release" ] || fail "found $1 after $release, expected one release"
           release=$1 ;;
    esac
    shift
done
[ -n "$release" ] || { usage >&2; exit 2; }
[ "$(id -u)" = 0 ] || fail "root makes the system: run it with sudo"
command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap"

root=$(CDPATH='' cd -- "$(dirname "$0")/.." && pwd -P)
logs=$root/out/try-release
log=$logs/$release-$kind
system=${TMPDIR:-/var/tmp}/radlab-try-$release
mkdir -p "$logs"
[ -n "$keep" ] || trap 'rm -rf "$system"' EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

make_system() {
    [ ! -e "$system/etc/debian_version" ] || return 0
    say "making a bare $release in $system (a minute or two)"
    script=
    [ -e "/usr/share/debootstrap/scripts/$release" ] || script=sid
    # shellcheck disable=SC2086
    debootstrap --variant=minbase "$release" "$system" $mirror ${script:+${mirror:-http://deb.debian.org/debian} "$script"} >"$log.log" 2>&1 || {
        tail -n 5 "$log.log" >&2
        fail "debootstrap failed: what it says is above, all of it in $log.log"
    }
}

# How this machine reaches the network holds in there, too: names, and who vouches for the hosts.
bring_network() {
    cp /etc/resolv.conf /etc/hosts "$system/etc/"
    [ ! -f /etc/ssl/certs/ca-certificates.crt ] || cp /etc/ssl/certs/ca-certificates.crt "$system/etc/radlab-try.crt"
}

# Runs a command in the system, in a namespace whose mounts and processes go with it.
inside() {
    # shellcheck disable=SC2016
    unshare --mount --pid --fork --kill-child sh -c '
        set -e
        system=$1 kind=$2
        shift 2
        mount --bind "$system" "$system"
        cd "$system"
        mount -t proc proc proc
        mount --rbind /sys sys
        mount --rbind /dev dev
        mount -t tmpfs none tmp
        chmod 1777 tmp
        if [ "$kind" = container ]; then enter="chroot ."; else
            mkdir -p .outside
            pivot_root . .outside
            umount -l .outside
            enter=
        fi
        exec $enter /usr/bin/env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 TERM=dumb \
            NODE_EXTRA_CA_CERTS=/etc/radlab-try.crt "$@"' sh "$system" "$kind" "$@" </dev/null
}

# A command of the script radlab; its seconds go to $seconds, its exit code to $code.
radlab() {
    say "$release, $kind: ./radlab $1; follow it with: tail -f $log-$1.log"
    start=$(date +%s) code=0
    inside sh -c 'cd "$HOME/radlab" && exec ./radlab "$@"' sh "$@" >"$log-$1.log" 2>&1 || code=$?
    seconds=$(($(date +%s) - start))
}

make_system
bring_network
rm -rf "$system/root/radlab"
git clone -q "$root" "$system/root/radlab"
radlab demo
demo="$seconds s"
[ "$code" = 0 ] || demo="failed ($code)"
radlab test
left_out=$(sed -n 's/^radlab: \(.*\) was not found: .*/\1/p' "$log-test.log" | sort -u | paste -sd, - | sed 's/,/, /g')
warnings=$(grep -c 'warning: ' "$log-test.log" || true)
summary=$(grep ' tests failed out of ' "$log-test.log" | tail -n 1)
total=${summary##* out of }
failed=${summary#*passed, } failed=${failed%% *}
skipped=$(grep -c '^radlab: skipped: ' "$log-test.log" || true)
{
    printf '| release | as | left out | demo | passed | failed | skipped | compiler warnings | test |\n|---|---|---|---|---|---|---|---|---|\n'
    printf '| %s | %s | %s | %s | %s | %s | %s | %s | %s s |\n' "$release" "$kind" "${left_out:-nothing}" "$demo" \
        "$((${total:-0} - ${failed:-0} - skipped))" "${failed:-no summary}" "$skipped" "$warnings" "$seconds"
} | tee "$log.md"
grep '^radlab: skipped: ' "$log-test.log" || true
[ -z "$keep" ] || say "the system stays in $system; enter it with: chroot $system"
exit "$code"
