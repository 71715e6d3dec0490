#!/bin/sh
# Runs a sweep on a real Slurm of one machine: an array of 24 tasks, one of which fails and one is killed and requeued; the last job
# merges. Installs Debian's packages where they are missing, starts controller and node daemon in a temporary folder, and stops
# them. usage: slurm_test.sh [BRACKET]
set -eu
cd -- "$(dirname -- "$0")/.."
bracket=$(realpath "${1:-${CARGO_TARGET_DIR:-target}/release/bracket}")
[ -x "$bracket" ] || { echo "slurm_test: build first (cargo build --release --locked)" >&2; exit 4; }
[ -e .venv/bin/gmsh ] || { echo "slurm_test: run scripts/setup.sh first" >&2; exit 4; }
if ! command -v slurmctld >/dev/null || ! command -v slurmd >/dev/null || ! command -v sbatch >/dev/null; then
    sudo=''
    [ "$(id -u)" = 0 ] || sudo=sudo
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends slurmctld slurmd slurm-client >&2
fi
work=$(mktemp -d)
controller='' node=''
stop() {
    [ -z "$node" ] || kill "$node" 2>/dev/null || true
    [ -z "$controller" ] || kill "$controller" 2>/dev/null || true
    wait
    rm -rf "$work"
}
trap stop EXIT
trap 'exit 130' INT TERM

mkdir "$work/state" "$work/spool"
host=$(hostname -s)
memory=$(awk '/MemAvailable/ {print int($2 / 1024)}' /proc/meminfo)
port=$((20000 + $$ % 20000))
cat > "$work/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/none
CredType=cred/none
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
MpiDefault=none
SwitchType=switch/none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
SchedulerParameters=batch_sched_delay=1,sched_interval=2
KillWait=5
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=$memory State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF="$work/slurm.conf"
slurmctld -D -c -f "$SLURM_CONF" > "$work/controller.out" 2>&1 &
controller=$!
slurmd -D -c -f "$SLURM_CONF" > "$work/node.out" 2>&1 &
node=$!
tries=0
until sinfo -h -o %t 2>/dev/null | grep -q '^idle$'; do
    tries=$((tries + 1))
    if [ "$tries" -gt 60 ]; then
        echo "slurm_test: the node does not come up" >&2
        cat "$work/controller.out" "$work/node.out" "$work/slurmctld.log" "$work/slurmd.log" >&2
        exit 1
    fi
    sleep 0.5
done

# a mesher that fails for the flange of 13.5 mm
cat > "$work/gmsh.sh" <<MESHER
for word; do case \$word in *.geo) grep -q '13\.5' "\$word" && exit 7 ;; esac; done
exec "$PWD/.venv/bin/python" "$PWD/.venv/bin/gmsh" "\$@"
MESHER
BRACKET_GMSH="[\"sh\", \"$work/gmsh.sh\"]"
export BRACKET_GMSH
cat > "$work/sweep.yaml" <<'SWEEP'
base:
  template: t_stub
  members: {tee: {profile: IPE300, steel: S235}}
  bolts: {size: M16, grade: "8.8", gauge: 100, rows: [0]}
  parameters: {length: 100, welded: true, flange_width: 160, flange_thickness: 12, web_thickness: 10, web_height: 30}
  friction: {mu: 0}
  loads: [{name: PULL, end: top, at: bolt_plane, N: 40 kN}]
  analysis: {kind: limit, max_passes: 1, mesh: {size: 25 mm}}
axes: {parameters.flange_thickness: {from: 10, to: 21.5, step: 0.5}}
limits: {memory: 1GiB}
SWEEP
cd "$work"
"$bracket" batch plan sweep.yaml -o sweep
start=$(date +%s)
"$bracket" batch slurm sweep --tasks 24 --submit 2> submitted
cat submitted >&2
array=$(sed -n 's/^submitted: array \([0-9]*\).*/\1/p' submitted)
merge=$(sed -n 's/.* merge \([0-9]*\)$/\1/p' submitted)
# one running task is killed and put back into the queue
requeued=''
while squeue -h -j "$merge" 2>/dev/null | grep -q .; do
    if [ -z "$requeued" ]; then
        task=$(squeue -h -t R -j "$array" -o %K 2>/dev/null | head -n 1)
        if [ -n "$task" ] && scontrol requeue "${array}_$task" 2>/dev/null; then
            requeued=$task
            echo "requeued: task $task" >&2
        fi
    else
        # Slurm lets a requeued task wait for two minutes
        scontrol update JobId="${array}_$requeued" StartTime=now 2>/dev/null || true
    fi
    if [ $(($(date +%s) - start)) -gt 900 ]; then
        echo "slurm_test: the jobs do not end" >&2
        squeue >&2
        cat "$work"/sweep/slurm-*.out >&2
        exit 1
    fi
    sleep 1
done
echo "slurm: 24 tasks in $(($(date +%s) - start)) s" >&2
cat sweep/slurm-"$merge".out >&2 || true
counts=$("$bracket" batch status sweep --format json)
fail() {
    echo "slurm_test: $1" >&2
    echo "$counts" >&2
    cat sweep/slurm-*.out >&2
    exit 1
}
[ -n "$requeued" ] || fail "no task was requeued"
echo "$counts" | grep -q '"failed": 1' || fail "one case fails, by its mesher"
echo "$counts" | grep -q '"open": 0' || fail "a case is open"
[ "$(grep -c '"verdict":"ok"' sweep/results.jsonl)" = 23 ] || fail "23 cases are OK"
grep '"outcome":"failed"' sweep/results.jsonl | grep -q '"parameters.flange_thickness":"13.5"' || fail "the wrong case fails"
echo "slurm_test: passed" >&2
