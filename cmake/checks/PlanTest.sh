#!/bin/sh
# Tests of the program plan as its user sees it: PlanTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"
# The names of the effects that are on, in one line.
effects_on() { awk '$2 ~ /^on,?$/ { printf "%s ", $1 }' out; }
plans() {
    run "$1"
    exits 0
    [ "$(effects_on)" = "$2 " ] || wrong "$1: expected $2, found: $(cat out)"
    says out 'expected: form factors '
}
black() { sed 's/diffuseColor="[^"]*"/diffuseColor="0 0 0"/' "$project/resources/scenes/$1.x3d" >black.x3d; }

case $claim in
    "each scene gets the effects that it calls for, and no others")
        scenes=$project/resources/scenes
        plans "$scenes/furnace.x3d" 'indirect smooth antialias'
        says out 'one channel (red)'
        plans "$scenes/cornell_1.x3d" 'indirect colour smooth antialias'
        plans "$scenes/cornell_2.x3d" 'occlusion indirect colour smooth antialias'
        says out '3 channels (red, green, blue)'
        block=$(awk '/DEF="short"/ { found = 1 } found && /<IndexedFaceSet/ { print NR; exit }' "$scenes/cornell_2.x3d")
        says out "cornell_2.x3d:$block may hide others"
        plans "$scenes/l_room.x3d" 'occlusion indirect colour smooth antialias'
        plans "$scenes/grey_room.x3d" 'occlusion indirect smooth antialias'
        plans "$scenes/teapot.x3d" 'occlusion indirect colour smooth antialias'
        plans "$scenes/mirror.x3d" 'occlusion indirect colour specular smooth antialias'
        says out 'also onto diffuse faces'
        says out ', light over specular faces '
        plans "$scenes/dark.x3d" 'smooth antialias'
        says out 'nothing emits light'
        black furnace
        plans black.x3d 'smooth antialias'
        says out 'no face reflects the light that there is'
        run "$scenes/furnace.x3d" --patch-size 10
        says out 'every face is one patch'
        ;;
    "the JSON is one object that names every effect, and nothing else is on stdout")
        run "$project/resources/scenes/cornell_2.x3d" --json --force occlusion=off
        exits 0
        says err 'occlusion is forced off'
        command -v python3 >/dev/null || skip "python3, which reads the JSON, is missing"
        python3 - out <<'EOF' || wrong "$(cat out)"
import json, sys
plan = json.load(open(sys.argv[1]))
effects = {effect["name"]: effect for effect in plan["effects"]}
assert plan["schema"] == "radlab/plan/1" and plan["file"].endswith("cornell_2.x3d")
assert list(effects) == ["occlusion", "indirect", "colour", "specular", "transparency", "smooth", "antialias"]
occlusion = effects["occlusion"]
assert occlusion["forced"] and occlusion["needed"] and not occlusion["on"] and occlusion["secondsSaved"] > 0
indirect = effects["indirect"]
assert indirect["on"] and not indirect["forced"] and "cornell_2.x3d:" in indirect["reason"]
assert plan["channels"] == ["red", "green", "blue"] and plan["patches"] > 500
assert all((plan["cost"][part] > 0) == (part != "specularSeconds") for part in plan["cost"])
EOF
        ;;
    "an effect is forced on and off, with a warning where something will be missing")
        run --force colour=off --force specular=on --force occlusion=on "$project/resources/scenes/cornell_1.x3d"
        exits 0
        [ "$(effects_on)" = 'occlusion indirect specular smooth antialias ' ] || wrong "$(cat out)"
        [ "$(grep -c 'forced' out)" = 3 ] || wrong "$(cat out)"
        [ "$(wc -l <err)" -eq 1 ] || wrong "$(cat err)"
        says err 'warning: colour is forced off: all channels will be multiples of one'
        run "$project/resources/scenes/cornell_2.x3d" --force occlusion=off --force occlusion=on
        exits 0
        grep -q '^occlusion *on, forced' out || wrong "$(cat out)"
        ;;
    "a million patches are planned: the memory that they would take is told, none of it is spent")
        run "$project/resources/scenes/furnace.x3d" --patch-size 0.00244
        exits 0
        says out '1008600 patches of size 0.00244'
        says out '; 7.4 TiB'
        ;;
    "what is wrong is said before any work, with exit code 2, and nothing on stdout")
        for force in shadows=on occlusion occlusion=maybe =on ''; do
            run absent.x3d --force "$force"
            exits 2
            [ ! -s out ] || wrong "on stdout: $(cat out)"
        done
        run absent.x3d --force shadows=on
        says err "'shadows=on', expected EFFECT=on or EFFECT=off, EFFECT one of occlusion, indirect, colour"
        run absent.x3d --json
        exits 2
        says err 'absent.x3d: '
        run "$project/resources/scenes/furnace.x3d" --json --method exakt
        exits 2
        says err "'exakt', expected one of point"
        [ ! -s out ] || wrong "on stdout: $(cat out)"
        ;;
    "Ctrl-C ends planning with exit code 130, one line, and nothing on stdout")
        # What is passed over is told once the file is read; a million patches are still to be cut then.
        sed 's|</Scene>|<Sound/></Scene>|' "$project/resources/scenes/furnace.x3d" >room.x3d
        interrupted_when "grep -q 'passed over' err" room.x3d --patch-size 0.00244
        exits 130
        says err 'interrupted: nothing'
        [ "$(wc -l <err)" -eq 2 ] || wrong "$(cat err)"
        [ ! -s out ] || wrong "$(cat out)"
        ;;
    *) wrong "no such claim" ;;
esac
