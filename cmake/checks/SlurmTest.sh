#!/bin/sh
# Tests of grade --engine slurm on a cluster of one node, which runs on this machine as long as the test: SlurmTest.sh PROGRAM PROJECT CLAIM
. "$(dirname "$0")/ProgramTest.sh"
PATH=$PATH:/usr/sbin:/sbin

stop() {
    [ ! -f slurm.conf ] || SLURM_CONF=$PWD/slurm.conf scontrol shutdown >/dev/null 2>&1 || true
    for name in slurmctld slurmd munged; do
        kill "$(cat "$name.pid" 2>/dev/null)" 2>/dev/null || true  # it may end and take its file away at any moment
    done
    sleep 0.5
    rm -rf "$work"
}

for tool in munged slurmctld slurmd sbatch; do
    command -v "$tool" >/dev/null || skip "$tool is missing (apt-get install slurm-wlm)"
done
[ "$(id -u)" = 0 ] || skip "the daemons of a cluster start as root alone"
trap stop EXIT

# A port that nothing listens on, and its neighbour.
port=$((20000 + $$ % 20000))
host=$(hostname -s)
start_munge() {
    mkdir -m 700 munge
    head -c 1024 /dev/urandom >munge/key
    chmod 400 munge/key
    chmod 711 .
    munged --force --key-file="$PWD/munge/key" --socket="$PWD/munge/socket" --pid-file="$PWD/munged.pid" \
        --log-file="$PWD/munge/log" --seed-file="$PWD/munge/seed" || skip "munged does not start: $(cat munge/log)"
}
start_slurm() {
    mkdir state spool
    cat >slurm.conf <<END
ClusterName=radlab
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$PWD/munge/socket
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$PWD/state
SlurmdSpoolDir=$PWD/spool
SlurmctldPidFile=$PWD/slurmctld.pid
SlurmdPidFile=$PWD/slurmd.pid
SlurmctldLogFile=$PWD/slurmctld.log
SlurmdLogFile=$PWD/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
MpiDefault=none
ReturnToService=2
KillWait=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=60 State=UP
END
    export SLURM_CONF="$PWD/slurm.conf"
    slurmctld -c -f slurm.conf
    slurmd -f "$PWD/slurm.conf"
    for _ in $(seq 1500); do
        ! sinfo -h -o %T 2>/dev/null | grep -q idle || return 0
        sleep 0.2
    done
    skip "no cluster could be started: $(tail -n 3 slurmctld.log slurmd.log)"
}
start_munge
start_slurm

hands_in() { mkdir -p "class/$1" && cat >"class/$1/ProgRef.cpp"; }

case $claim in
    "a class gets the same marks on a cluster as here, and what a lost task had is graded again")
        hands_in student-01 <"$project/exercises/ProgRef.cpp"
        hands_in student-02 <"$project/solutions/ProgRef.cpp"
        printf '#include "ProgRef.h"\n\nint a = nonsense;\n' | hands_in student-03
        { cat "$project/solutions/ProgRef.cpp"; echo "// four"; } | hands_in student-04
        "$program" class --out there --engine slurm --slurm=--time=10 >out 2>err &
        grading=$!
        # The first task is lost, as if its machine had died.
        while kill -0 "$grading" 2>/dev/null; do
            job=$(squeue -h -t RUNNING -o %A 2>/dev/null | head -n 1)
            [ -z "$job" ] || break
            sleep 0.1
        done
        scancel --signal=KILL --full "$job" || true
        code=0
        wait "$grading" || code=$?
        [ "$code" = 0 ] || wrong "exit code $code: $(cat out err there/slurm/*/logs/*)"
        says out 'graded: 4, of which the store had 0'
        run class --out here
        exits 0
        for place in there here; do cut -d, -f1-6,8- $place/grades/marks.csv >$place.csv; done  # but when it was graded
        grep -q 'student-02,.*,100,100' here.csv || wrong "$(cat here.csv)"
        cmp -s there.csv here.csv || wrong "$(cat there.csv here.csv)" ;;
    *) wrong "no such claim" ;;
esac
