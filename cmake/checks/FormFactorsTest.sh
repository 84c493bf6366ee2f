#!/bin/sh
# Tests of the program formfactors as its user sees it: FormFactorsTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"

case $claim in
    "the faces of a closed cube see each other as the closed form says")
        for method in exact auto visibility; do
            run "$project/resources/scenes/furnace.x3d" --faces --method $method -o F.csv
            exits 0
            says out 'no occlusion'
            [ "$(grep -c '^#' F.csv)" -ge 4 ] || wrong "no comment: $(cat F.csv)"
            grep -v '^#' F.csv | awk -F, '
                NF != 6 { exit 1 }
                { for (i = 1; i <= 6; ++i) {
                      off = $i - (i == NR ? 0 : 0.2)
                      if (off > 0.0002 || off < -0.0002) exit 1
                      sum += $i } }
                END { if (NR != 6 || sum < 5.9999999999 || sum > 6.0000000001) exit 1 }' || wrong "$(cat F.csv)"
        done
        ;;
    "what is wrong is said before any work, with exit code 2, and leaves no file")
        run "$project/resources/scenes/furnace.x3d" -o F.txt
        exits 2
        says err "'.txt', expected .csv or .npy"
        run "$project/resources/scenes/furnace.x3d" -o F.csv --method exakt
        exits 2
        says err "'exakt', expected one of point, polygon, exact"
        run "$project/resources/scenes/furnace.x3d" -o F.csv --method hemicube --size 65
        exits 2
        says err 'found 65, expected an even number from 8 to 4096'
        run absent.x3d -o F.csv
        exits 2
        says err 'absent.x3d: '
        run "$project/resources/scenes/furnace.x3d" -o F.csv --patch-size 0
        exits 2
        run "$project/resources/scenes/furnace.x3d" -o F.csv --patch-size 1e-4
        exits 2
        sed 's/<Material /<Material transparency="0.5" /' "$project/resources/scenes/furnace.x3d" >panes.x3d
        run panes.x3d -o F.csv --enforce
        rm panes.x3d
        exits 2
        says err 'found faces that let light through'
        [ "$(ls)" = "$(printf 'err\nout')" ] || wrong "left behind: $(ls)"
        ;;
    "settings name the scene and the size of the patches, rays see what is hidden, both laws can be enforced")
        printf '<Resource><Values hemicube_size="64" form_factor_method="auto" patch_subdivision_size="120"
            light_subdivision_size="50" file_name="%s"/></Resource>' "$project/resources/scenes/cornell_2.x3d" >box.xml
        run box.xml -o F.npy --rays 64 --enforce
        exits 0
        says out 'of size 120'
        says out 'method visibility'
        says out 'reciprocity holds within'
        says out 'both laws enforced'
        run box.xml -o F.npy --method hemicube --size 64
        exits 0
        says out 'method hemicube'
        [ "$(head -c 6 F.npy | tail -c 5)" = NUMPY ] || wrong "no NumPy file"
        ;;
    *) wrong "no such claim" ;;
esac
