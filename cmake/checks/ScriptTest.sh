#!/bin/sh
# Tests of the radlab script: ScriptTest.sh PROJECT VERSION CLAIM
#
# Programs are built from a stand-in for the project, in a folder with a space in its name, and apt-get is
# never asked: dpkg-query is a stand-in too, which finds every package installed.
# shellcheck disable=SC2015,SC2016  # A && B || wrong is meant so; the quoted $ are for the stand-ins.
set -eu
project=$1 version=$2 claim=$3
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

wrong() { echo "$claim: $*" >&2; exit 1; }
program() { printf '#!/bin/sh\n%s\n' "$2" >"$work/tools/$1"; chmod +x "$work/tools/$1"; }

mkdir -p "$work/a copy/solutions" "$work/a copy/packaging" "$work/tools"
touch "$work/a copy/solutions/ProgRef.cpp"
cp "$project/radlab" "$project/CMakePresets.json" "$work/a copy"
cat >"$work/a copy/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.25)
project(radlab VERSION 9.8.7 LANGUAGES NONE)
file(WRITE ${CMAKE_BINARY_DIR}/bin/demo "#!/bin/sh\npwd\nprintf '<%s>' \"$@\"\n")
file(CHMOD ${CMAKE_BINARY_DIR}/bin/demo PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
add_custom_command(OUTPUT made COMMAND ${CMAKE_COMMAND} -E touch made)
add_custom_target(demo DEPENDS made)
add_custom_target(demo-exercise COMMAND ${CMAKE_COMMAND} -E cat no-such-file)
END
ln -s "a copy/radlab" "$work/link"
program apt-get 'exit 1'
program dpkg-query 'shift 3; for name; do printf "%s installed " "$name"; done'
PATH=$work/tools:$PATH
unset RADLAB_PRESET

# Runs the script; its exit code goes to $code, what it printed to the files out and err.
run() { code=0; "$@" >"$work/out" 2>"$work/err" </dev/null || code=$?; }
one_line() { [ "$(wc -l <"$work/err")" -eq 1 ] && [ ! -s "$work/out" ] || wrong "$(cat "$work/out" "$work/err")"; }
says() { grep -qF -- "$2" "$work/$1" || wrong "expected '$2', found: $(cat "$work/$1")"; }

case $claim in
    "help lists every command")
        run "$project/radlab" help
        for name in demo test check watch view render plan study grade handout package bench help; do
            grep -q "^  $name " "$work/out" || wrong "no $name"
        done
        cp "$work/out" "$work/help"
        run "$project/radlab" --help
        cmp "$work/out" "$work/help" ;;
    "an unknown command exits with 2 and a suggestion")
        run "$project/radlab" dmeo
        [ "$code" = 2 ] || wrong "exit code $code"
        one_line
        says err "did you mean 'demo'?"
        run "$project/radlab" 'x|y.*'
        one_line
        says err "expected one of demo test check" ;;
    "what is not built yet says so in one line")
        "$project/radlab" help | sed -n 's/^  \([a-z]*\) .*(not built yet)$/\1/p' >"$work/later"
        while read -r name; do
            run "$project/radlab" "$name"
            [ "$code" = 2 ] || wrong "$name: exit code $code"
            one_line
            says err "radlab: '$name' is not built yet"
        done <"$work/later" ;;
    "--version is the version of the project")
        run "$project/radlab" --version
        [ "$(cat "$work/out")" = "radlab $version" ] || wrong "$(cat "$work/out")" ;;
    "a program gets its arguments unchanged, from any folder")
        cd "$work/tools"
        run "$work/link" demo --help "two words" '*' ''
        [ "$code" = 0 ] || wrong "$(cat "$work/err")"
        says out "$(pwd -P)"
        says out "<--help><two words><*><>" ;;
    "what is up to date starts without a word")
        run "$work/a copy/radlab" demo
        run "$work/a copy/radlab" demo
        [ "$code" = 0 ] && [ ! -s "$work/err" ] || wrong "$(cat "$work/err")" ;;
    "a failed build exits with 2 and what the compiler said")
        run "$work/a copy/radlab" demo --exercise
        [ "$code" = 2 ] && [ ! -s "$work/out" ] || wrong "exit code $code"
        says err no-such-file
        says err "radlab: the build failed" ;;
    "a clone that cannot be written is built among the user's own files")
        home=$work/home
        if [ "$(id -u)" = 0 ]; then
            unshare -m true 2>/dev/null || { echo "-- skipped: no mount namespace can be made here"; exit 0; }
            cat >"$work/tools/read-only" <<'END'
#!/bin/sh
mount --bind "$1" "$1" && mount -o remount,bind,ro "$1" && shift && exec "$@"
END
            chmod +x "$work/tools/read-only"
            run env HOME="$home" unshare -m read-only "$work/a copy" "$work/a copy/radlab" demo one
        else
            chmod a-w "$work/a copy"
            run env HOME="$home" "$work/a copy/radlab" demo one
            chmod u+w "$work/a copy"
        fi
        [ "$code" = 0 ] || wrong "$(cat "$work/err")"
        says out '<one>'
        [ ! -e "$work/a copy/build" ] && ls "$home"/.cache/radlab/*/release/build.ninja >/dev/null || wrong "$(find "$home")" ;;
    "every test that is skipped is named with its reason, and the count comes last")
        cat >>"$work/a copy/CMakeLists.txt" <<'END'
enable_testing()

add_test(NAME "right" COMMAND ${CMAKE_COMMAND} -E echo right)
foreach(number IN ITEMS 1 2)
  add_test(NAME "skips: number ${number}" COMMAND ${CMAKE_COMMAND} -E echo "file:7: MESSAGE: -- skipped: no moon, & number ${number}")
  set_tests_properties("skips: number ${number}" PROPERTIES SKIP_REGULAR_EXPRESSION "-- skipped: ")
endforeach()
END
        run "$work/a copy/radlab" test
        [ "$code" = 0 ] || wrong "$(cat "$work/out" "$work/err")"
        says err 'radlab: skipped: skips: number 1: no moon, & number 1'
        says err 'radlab: skipped: skips: number 2: no moon, & number 2'
        [ "$(tail -n 1 "$work/out")" = '100% tests passed, 0 tests failed out of 3' ] || wrong "$(cat "$work/out")"
        sed -i 's/-E echo right/-E false/' "$work/a copy/CMakeLists.txt"
        run "$work/a copy/radlab" test
        [ "$code" != 0 ] || wrong "a test failed, and the exit code is 0" ;;
    "missing packages are named in one line to run")
        program dpkg-query 'exit 1'
        program sudo 'exit 1'
        program id 'echo 1000'
        run "$work/a copy/radlab" demo
        [ "$code" = 2 ] || wrong "exit code $code"
        one_line
        says err "run: sudo apt-get install --no-install-recommends g++ cmake ninja-build" ;;
    "without the solutions, demo runs the exercise, and what needs them says so in one line")
        rm -r "$work/a copy/solutions"
        sed -i 's/ COMMAND .*no-such-file)/)/; s|/bin/demo|/bin/demo-exercise|' "$work/a copy/CMakeLists.txt"
        run "$work/a copy/radlab" demo --empty one.xml
        [ "$code" = 0 ] || wrong "$(cat "$work/err")"
        says out '<--empty><one.xml>'
        run "$work/a copy/radlab" help
        ! grep -qE '^  (test|grade|study|bench|package) ' "$work/out" || wrong "$(cat "$work/out")"
        for name in test grade study bench package; do
            run "$work/a copy/radlab" "$name"
            [ "$code" = 2 ] || wrong "$name: exit code $code"
            one_line
            says err "'$name' needs the solutions, which this package does not have"
        done ;;
    "a script is started as it is, without a build")
        printf '#!/bin/sh\nprintf "<%%s>" "$@"\nexit 5\n' >"$work/a copy/packaging/package.sh"
        chmod +x "$work/a copy/packaging/package.sh"
        run "$work/link" package "two words" ''
        [ "$code" = 5 ] && [ ! -e "$work/a copy/build" ] || wrong "exit code $code"
        says out '<two words><>' ;;
    *) wrong "no such test" ;;
esac
