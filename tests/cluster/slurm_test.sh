#!/bin/sh
# The array scripts of docs/slurm on a real Slurm of one node, its daemons on the loopback address: what the parts
# merge to has the bits of one run. Exits 77 (skipped) where Slurm is not installed or this user is not root.
#
# $1: the palpate to run; $2: the root of the source
set -eu
palpate=$1 source=$2
[ "$(id -u)" -eq 0 ] || exit 77
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || { echo "$program is not installed"; exit 77; }
done

work=$(mktemp -d)
chmod 755 "$work"
host=$(hostname -s)
port=$((20000 + 2 * ($$ % 20000)))  # two, of this run alone
stop() {
  for daemon in slurmd slurmctld munge; do
    if [ -f "$work/$daemon.pid" ]; then kill "$(cat "$work/$daemon.pid")" 2>/dev/null || true; fi
  done
  sleep 1
  rm -rf "$work"
}
trap stop EXIT

start_slurm() {
  mkdir -p "$work/spool" "$work/state" "$work/munge"
  chmod 700 "$work/munge"
  (umask 077 && head -c 1024 /dev/urandom >"$work/munge/key")
  cat >"$work/slurm.conf" <<END
ClusterName=palpate
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
SlurmdSpoolDir=$work/spool
StateSaveLocation=$work/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/builtin
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
MpiDefault=none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
  export SLURM_CONF="$work/slurm.conf"
  munged --force --key-file="$work/munge/key" --socket="$work/munge/socket" --pid-file="$work/munge.pid" \
    --log-file="$work/munge/log" --seed-file="$work/munge/seed"
  slurmctld -c -f "$SLURM_CONF"
  slurmd -f "$SLURM_CONF"
  tries=0
  until [ "$(sinfo -h -o %t 2>&1)" = idle ]; do
    tries=$((tries + 1))
    [ "$tries" -lt 30 ] || { sinfo; cat "$work/slurmctld.log" "$work/slurmd.log"; exit 1; }
    sleep 1
  done
}

# same WHAT PART_FOLDER ONE_RUN: the parts merge to the one run.
same() {
  "$palpate" stats merge "$2"/part-*.json --format json >"$work/merged.json"
  cmp "$work/merged.json" "$3" || { echo "$1: the merged parts differ from one run"; exit 1; }
  echo "$1: $(find "$2" -name 'part-*.json' | wc -l) parts merge to the bits of one run"
}

start_slurm
cd "$work"
mkdir parts power bootstrap
sed -e "s|\"\.\./data|\"$source/data|" -e 's/planned_examinees = 15/planned_examinees = 2/' \
  -e 's/per_cell = 4/per_cell = 1/' "$source/protocols/kuroda2003.toml" >small.toml
printf 'level,correct,trials\n1,12,20\n2,13,20\n3,17,20\n4,18,20\n5,20,20\n6,20,20\n' >answers.csv

export PALPATE="$palpate"
STUDIES=4 SEED=5 PARTS=power sbatch --quiet --wait --array=1-3 "$source/docs/slurm/power.sh" small.toml
"$palpate" plan small.toml --studies 4 --seed 5 --format json >power.json
same "power simulation" power power.json

REPLICATES=300 SEED=3 PARTS=bootstrap sbatch --quiet --wait --array=1-4 "$source/docs/slurm/bootstrap.sh" \
  answers.csv --guess 1/2
"$palpate" stats psychometric answers.csv --guess 1/2 --intervals bootstrap --replicates 300 --seed 3 \
  --format json >bootstrap.json
same "bootstrap" bootstrap bootstrap.json
