#!/bin/sh
# Tests of the program render as its user sees it: RenderTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"

read_scene='^indirect\|patches of size'

case $claim in
    "in the furnace every patch shines as E/(1-rho), whole or cut, with one channel solved")
        for size in 10 0.3; do
            run "$project/resources/scenes/furnace.x3d" --patch-size $size --csv furnace.csv
            exits 0
            says out 'exact, 0 rays'
            says out '1 of 3 channels solved'
            grep -v '^#' furnace.csv | awk -F, '
                NR == 1 { if ($1 != "id" || $18 != "B_b") exit 1; next }
                { for (c = 0; c < 3; ++c) {
                      off = $(16 + c) * (1 - $(10 + c)) / $(13 + c) - 1
                      if (off > 1e-6 || off < -1e-6) exit 1 } }
                END { if (NR < 7) exit 1 }' || wrong "size $size: $(cat furnace.csv)"
        done
        ;;
    "a picture is written as PNG and as HDR, and a scene without light is black")
        run "$project/resources/scenes/l_room.x3d" --patch-size 1 --width 64 --height 48 -o room.png
        exits 0
        [ "$(head -c 4 room.png | tail -c 3)" = PNG ] || wrong "no PNG"
        run "$project/resources/scenes/l_room.x3d" --patch-size 1 --width 64 --height 48 -o room.hdr --flat
        exits 0
        says room.hdr '#?RADIANCE'
        run "$project/resources/scenes/dark.x3d" --csv dark.csv -o dark.png
        exits 0
        says out '0 of 3 channels solved'
        says err 'nothing emits light'
        awk -F, 'NR > 2 && ($16 != 0 || $17 != 0 || $18 != 0) { exit 1 }' dark.csv || wrong "light: $(cat dark.csv)"
        ;;
    "path tracing finds E/(1-rho) in the furnace within its standard errors, and draws a picture")
        run "$project/resources/scenes/furnace.x3d" --patch-size 0.5 --method path --samples 256 --csv furnace.csv
        exits 0
        says out 'path tracing, 256 paths a patch'
        grep -v '^#' furnace.csv | awk -F, '
            NR == 1 { if ($21 != "se_b") exit 1; next }
            { for (c = 0; c < 3; ++c) {
                  off = $(16 + c) - $(13 + c) / (1 - $(10 + c))
                  if (off < 0) off = -off
                  if ($(19 + c) <= 0 || off > 5 * $(19 + c)) exit 1 } }
            END { if (NR != 25) exit 1 }' || wrong "$(cat furnace.csv)"
        run "$project/resources/scenes/cornell_2.x3d" --method path --samples 4 --width 40 --height 30 -o box.png
        exits 0
        says out 'path tracing, 4 paths a pixel'
        [ "$(head -c 4 box.png | tail -c 3)" = PNG ] || wrong "no PNG"
        run "$project/resources/scenes/furnace.x3d" --samples 4 --csv none.csv
        exits 2
        says err 'expected --method path'
        ;;
    "a picture gathers light at mirrors alone, and needs no OpenGL")
        run "$project/resources/scenes/mirror.x3d" --patch-size 200 --width 64 --height 64 --antialias 1 -o mirror.png
        exits 0
        says out ', 0 of 4096 pixels sampled more than once'
        says out 'over specular faces: '
        if grep -q ', 0 gathers' out; then wrong "no gathers: $(cat out)"; fi
        run "$project/resources/scenes/mirror.x3d" --patch-size 200 --width 64 --height 64 --force specular=off \
            -o matt.png
        exits 0
        says out ', 0 gathers'
        if grep -q 'over specular faces' out; then wrong "specular light, forced off: $(cat out)"; fi
        run "$project/resources/scenes/cornell_2.x3d" --patch-size 200 --width 64 --height 64 -o box.png
        exits 0
        says out ', 0 gathers'
        if grep -q 'over specular faces' out; then wrong "specular light in a matt scene: $(cat out)"; fi
        command -v ldd >/dev/null || skip "no ldd here that says what a program is linked with"
        if ldd "$program" | grep -qE 'libOSMesa|libEGL|libGL'; then wrong "linked with OpenGL"; fi
        ;;
    "an error asked for is reached, and links and shots do without a matrix")
        run "$project/resources/scenes/cornell_2.x3d" --error 0.05 --csv box.csv --width 64 --height 64 -o box.png
        exits 0
        says out 'chosen: '
        awk '/^estimated error: / { found = $3 <= 5 } END { exit !found }' out || wrong "error: $(cat out)"
        [ "$(grep -vc '^#' box.csv)" -gt 100 ] || wrong "no patches: $(cat box.csv)"
        run "$project/resources/scenes/cornell_2.x3d" --method links --threshold 1e-3 --csv links.csv
        exits 0
        says out ' links in '
        run "$project/resources/scenes/cornell_2.x3d" --patch-size 100 --shots 24 --method hemicube --size 32 --csv shots.csv
        exits 0
        says out '24 shots by hemicube'
        run "$project/resources/scenes/furnace.x3d" --patch-size 0.5 --unshot 1e-6 --csv shots.csv
        exits 0
        awk -F, 'NR > 2 && ($16 < 1.999 || $16 > 2.001) { exit 1 }' shots.csv || wrong "furnace: $(cat shots.csv)"
        run "$project/resources/scenes/mirror.x3d" --error 0.1 --csv mirror.csv
        exits 0
        says out ' specular rays a patch'
        run "$project/resources/scenes/mirror.x3d" --patch-size 200 --shots 24 --csv shots.csv
        exits 0
        says out 'over specular faces: '
        run "$project/resources/scenes/cornell_2.x3d" --error 0.05 --method exact --csv none.csv
        exits 2
        says err 'expected none with it'
        [ ! -e none.csv ] || wrong "left behind: none.csv"
        ;;
    "a million patches are cut, a matrix of them is refused with what it needs, and the ways that need none are named")
        run "$project/resources/scenes/furnace.x3d" --patch-size 0.00244 --csv none.csv
        exits 2
        says out '1008600 patches of size 0.00244'
        says out 'form factors: 7.4 TiB to store'
        says err 'the form factors of 1008600 patches need 7.4 TiB of memory, and this machine has '
        says err 'take larger patches, or a way that stores no matrix (render: --method links, or --unshot)'
        [ ! -e none.csv ] || wrong "left behind: none.csv"
        ;;
    "what is wrong is said before any work, with exit code 2, and leaves no file")
        run "$project/resources/scenes/furnace.x3d"
        exits 2
        says err 'nothing to write'
        run "$project/resources/scenes/furnace.x3d" -o box.jpg
        exits 2
        says err "'.jpg', expected .png or .hdr"
        run "$project/resources/scenes/furnace.x3d" --csv box.csv --camera 7
        exits 2
        says err 'viewpoints, and --camera 7'
        run "$project/resources/scenes/furnace.x3d" --csv box.csv --patch-size 0.0001
        exits 2
        run absent.x3d -o box.png
        exits 2
        says err 'absent.x3d'
        [ "$(ls)" = "$(printf 'err\nout')" ] || wrong "left behind: $(ls)"
        ;;
    "every scene is written as glTF that the validator of Khronos finds nothing wrong with, and as PLY")
        for scene in "$project"/resources/scenes/*.x3d; do
            name=$(basename "$scene" .x3d)
            run "$scene" --shots 8 --method polygon --width 32 --height 32 -o "$name.glb" -o "$name.gltf" -o "$name.ply" \
                -o "$name.png" --csv "$name.csv"
            exits 0
            [ "$(head -c 3 "$name.ply")" = ply ] || wrong "no PLY"
        done
        command -v node >/dev/null || skip "no node here to validate with"
        three=/usr/share/javascript/three
        [ -d "$three/examples/js" ] || skip "no three.js here to read with (libjs-three)"
        for scene in "$project"/resources/scenes/*.x3d; do
            name=$(basename "$scene" .x3d)
            node "$project/cmake/checks/read-meshes.js" "$three" "$scene" "$name" || wrong "three.js does not read $name as it is"
        done
        command -v npm >/dev/null || skip "no npm here that brings the validator"
        npm install --prefix modules --no-audit --no-fund gltf-validator@2.0.0-dev.3.10 >npm.log 2>&1 ||
            skip "npm cannot bring the validator: $(tail -1 npm.log)"
        node "$project/cmake/checks/validate-gltf.js" "$work/modules/node_modules" ./*.glb ./*.gltf || wrong "invalid glTF"
        ;;
    "Ctrl-C ends shooting with a whole picture and mesh of the light shot so far, and exit code 130")
        # The light is never all shot: without Ctrl-C this would take hours.
        interrupted_in ' shots' "$project/resources/scenes/cornell_2.x3d" --patch-size 10 --unshot 1e-9 --method hemisphere \
            --rays 100000 --width 32 --height 32 -o box.png -o box.glb
        exits 130
        says out ' of the light unshot'
        says out 'stopped by Ctrl-C'
        [ "$(head -c 4 box.png | tail -c 3)" = PNG ] || wrong "no PNG"
        [ "$(head -c 4 box.glb)" = glTF ] || wrong "no glTF"
        length=$(od -An -tu4 -j8 -N4 box.glb)
        [ "$((length))" = "$(($(wc -c <box.glb)))" ] || wrong "the glTF is not whole"
        [ -z "$(ls | grep part)" ] || wrong "left behind: $(ls)"
        ;;
    "Ctrl-C ends form factors with exit code 130 and leaves no file")
        interrupted "$read_scene" "$project/resources/scenes/cornell_2.x3d" --patch-size 20 --method hemisphere --rays 1000000 \
            -o box.png -o box.ply
        exits 130
        says err 'interrupted: nothing'
        [ "$(ls)" = "$(printf 'err\nout')" ] || wrong "left behind: $(ls)"
        ;;
    "Ctrl-C in path tracing leaves a table and a picture of the paths so far")
        # After two passes, the first of which takes every patch or pixel.
        interrupted_in ' [1-9][0-9]* %' "$project/resources/scenes/furnace.x3d" --patch-size 10 --method path --samples 10000000 \
            --csv box.csv
        exits 130
        says out 'stopped by Ctrl-C: 10000000 paths were asked for'
        [ "$(grep -vc '^#' box.csv)" -eq 7 ] || wrong "$(cat box.csv)"
        interrupted_in ' [1-9][0-9]* %' "$project/resources/scenes/furnace.x3d" --patch-size 10 --method path --samples 100000 \
            --width 64 --height 64 -o box.png
        exits 130
        says out 'stopped by Ctrl-C: 100000 paths were asked for'
        [ "$(head -c 4 box.png | tail -c 3)" = PNG ] || wrong "no PNG"
        ;;
    "Ctrl-C in links ends with the links of the rounds so far, or with none")
        interrupted_in ' links' "$project/resources/scenes/cornell_2.x3d" --patch-size 15 --method links --threshold 1e-12 --csv box.csv
        exits 130
        if [ -e box.csv ]; then says out 'stopped by Ctrl-C: of the light'; else says err 'interrupted: nothing'; fi
        ;;
    "Ctrl-C in a path traced picture leaves the table that was written before, and says which files are whole")
        # The table has six patches, and the picture would take days.
        interrupted '^written: box.csv' "$project/resources/scenes/furnace.x3d" --patch-size 10 --method path --samples 20000 \
            --csv box.csv --width 8000 --height 8000 -o box.png
        exits 130
        [ "$(grep -vc '^#' box.csv)" -eq 7 ] || wrong "$(cat box.csv)"
        says out 'stopped by Ctrl-C: what is '
        ! grep -q 'nothing was written' err || wrong "$(cat err)"
        if [ -e box.png ]; then says out 'written: box.png'; fi
        [ -z "$(ls | grep part)" ] || wrong "left behind: $(ls)"
        ;;
    "a mesh alone is written without a picture where its exposure is given")
        run "$project/resources/scenes/furnace.x3d" --patch-size 0.5 --width 32 --height 32 --exposure 0.5 -o room.ply -o room.glb
        exits 0
        says out 'written: room.glb'
        ! grep -q 'picture: ' out || wrong "$(cat out)"
        run "$project/resources/scenes/furnace.x3d" --patch-size 0.5 --width 32 --height 32 -o again.ply
        exits 0
        says out 'picture: '
        run "$project/resources/scenes/furnace.x3d" --patch-size 0.5 --method path --samples 32 --width 32 --height 32 --exposure 0.5 \
            -o paths.ply
        exits 0
        says out 'written: paths.ply'
        ! grep -q 'picture: ' out || wrong "$(cat out)"
        ;;
    *) wrong "no such claim" ;;
esac
