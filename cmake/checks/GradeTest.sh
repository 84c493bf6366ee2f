#!/bin/sh
# Tests of the program grade as an instructor uses it: GradeTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"

# Makes a student's folder, with this as the submission.
hands_in() { mkdir -p "class/$1" && cat >"class/$1/ProgRef.cpp"; }
grades() { run class --out store "$@"; }
does_not_compile() { printf '#include "ProgRef.h"\n\nint %s = nonsense;\n' "$1"; }

case $claim in
    "a class is graded once, and the same command finds the marks again")
        hands_in student-01 <"$project/exercises/ProgRef.cpp"
        does_not_compile a | hands_in student-02
        does_not_compile a | hands_in student-03
        mkdir class/student-04
        grades --jobs 2
        exits 0
        says out 'nothing handed in: 1'
        says out 'mean: 0.0 of 100 (3 students)'
        says err 'grading: 4 of 4 done, 0 failed'
        says store/grades/index.html 'student-04'
        says store/grades/students/student-02.html 'nonsense'
        grades
        exits 0
        says out 'graded: 3, of which the store had 3'
        does_not_compile b | hands_in student-02
        grades
        says out 'graded: 3, of which the store had 2'
        grades --only student-03 --regrade
        says out 'graded: 1, of which the store had 0' ;;
    "2 for wrong flags, no such folder, a store of something else, or protections that are missing")
        run
        exits 2
        run absent
        exits 2
        says err 'absent'
        does_not_compile a | hands_in student-01
        grades --only student-02
        exits 2
        says err 'student-02'
        grades --require 'a wall of fire'
        exits 2
        says err 'a wall of fire'
        grades --canvas absent.csv
        exits 2
        grades --engine abacus
        exits 2
        mkdir taken
        run class --out err
        exits 2
        says err 'err: the folder cannot be made'
        echo 'no store at all, but a text' >taken/grades.db
        run class --out taken
        exits 2
        says err 'taken/grades.db'
        [ "$(cat taken/grades.db)" = 'no store at all, but a text' ] || wrong "it was overwritten"
        [ ! -e store/grades.db ] || wrong "something was graded" ;;
    "gradebooks of Canvas and Moodle are filled in, and what is wrong with one is said before anything is graded")
        hands_in 'Ada Lovelace_201_assignsubmission_file_' <"$project/solutions/ProgRef.cpp"
        does_not_compile a | hands_in 'Grace Hopper_202_assignsubmission_file_'
        cat >canvas.csv <<'END'
Student,ID,SIS User ID,SIS Login ID,Section,Radiosity (777),Homework (776)
    Points Possible,,,,,100.00,10.00
"Lovelace, Ada",1001,s1,ada,One,,9.5
"Hopper, Grace",1002,s2,grace,One,,10
END
        cat >moodle.csv <<'END'
Identifier,"Full name","Email address",Status,Grade,"Maximum grade","Grade can be changed","Last modified (grade)","Feedback comments"
"Participant 201","Ada Lovelace",ada@example.org,"Submitted for grading",,100.00,Yes,-,
"Participant 202","Grace Hopper",grace@example.org,"Submitted for grading",,100.00,Yes,-,
"Participant 203","Emmy Noether",emmy@example.org,"No submission",,100.00,Yes,-,
END
        cp canvas.csv own.csv
        grades --canvas canvas.csv
        exits 2
        says err "canvas.csv:1: several assignments fit"
        [ ! -e store/grades ] || wrong "something was graded"
        grades --canvas canvas.csv --moodle moodle.csv --assignment 777
        exits 0
        cmp canvas.csv own.csv
        says store/grades/canvas.csv '"Lovelace, Ada",1001,s1,ada,One,100.00,9.5'
        says store/grades/canvas.csv '"Hopper, Grace",1002,s2,grace,One,0.00,10'
        says store/grades/moodle.csv '"Participant 201","Ada Lovelace",ada@example.org,"Submitted for grading",100.00,100.00,Yes,-,'
        says store/grades/moodle.csv '"Participant 203","Emmy Noether",emmy@example.org,"No submission",,100.00,Yes,-,'
        says out "nobody for the row of"
        grades --canvas store/grades/canvas.csv --assignment 777
        exits 2
        says err 'put it elsewhere' ;;
    "a signal stops it with 130, and the same command goes on")
        does_not_compile a | hands_in student-01
        for number in 02 03 04 05; do
            { cat "$project/exercises/ProgRef.cpp"; echo "// $number"; } | hands_in "student-$number"
        done
        "$program" class --out store --jobs 1 >out.txt 2>err &
        grading=$!
        until_ready "$grading" grep -q 'grading: 1 of 5' err
        kill -TERM "$grading"
        code=0
        wait "$grading" || code=$?
        [ "$code" = 130 ] || wrong "exit code $code: $(cat out.txt err)"
        says err 'the same command goes on'
        rm -r class/student-03 class/student-04 class/student-05
        grades
        exits 0
        says out 'graded: 2, of which the store had ' ;;
    *) wrong "no such claim" ;;
esac
