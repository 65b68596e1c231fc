#!/bin/bash
# batch_slurm.sh -- a real Slurm on this machine alone (its daemons on loopback,
# with a key and ports of their own) runs an array of `batch --shard slurm`; all
# of it together makes the bytes of one batch. Skipped, and said so, where there
# is no Slurm or nobody may start it.
. "$(dirname "$0")/harness.bash"
cd "$work" || exit 2
export LANG=C.UTF-8
for program in slurmctld slurmd sbatch munged; do
  if ! command -v $program >/dev/null && [ ! -x /usr/sbin/$program ]; then
    skip "Slurm: $program is not installed (apt-get install slurm-wlm munge)"
    finish
  fi
done
if [ "$(id -u)" != 0 ]; then
  skip 'Slurm: only root can start its daemons'
  finish
fi
PATH=$PATH:/usr/sbin:/sbin
slurm=$(mktemp -d /tmp/sanggwan-slurm.XXXXXX) # a socket's path has to be short
pids=
end_slurm() {
  [ -n "$pids" ] && kill $pids 2>/dev/null
  [ -s "$slurm/munged.pid" ] && kill "$(cat "$slurm/munged.pid")" 2>/dev/null
  wait 2>/dev/null
  rm -rf "$slurm" "$work"
}
trap end_slurm EXIT
free_port() {
  python3 -c 'import socket
s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}
chmod 755 "$slurm"
mkdir -m 700 "$slurm/munge" "$slurm/log"
mkdir -m 755 "$slurm/run" "$slurm/state" "$slurm/spool"
dd if=/dev/urandom of="$slurm/munge/key" bs=128 count=1 status=none
chmod 400 "$slurm/munge/key"
munged --force --key-file="$slurm/munge/key" --socket="$slurm/run/socket" \
  --pid-file="$slurm/munged.pid" --log-file="$slurm/log/munged" \
  --seed-file="$slurm/munge/seed" >"$work/munge.out" 2>&1
host=$(hostname -s)
cat >"$slurm/slurm.conf" <<END
ClusterName=sanggwan
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$slurm/run/socket
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldPidFile=$slurm/run/slurmctld.pid
SlurmdPidFile=$slurm/run/slurmd.pid
SlurmctldLogFile=$slurm/log/slurmctld
SlurmdLogFile=$slurm/log/slurmd
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES State=UP
END
export SLURM_CONF=$slurm/slurm.conf
slurmctld -D >"$work/slurmctld.out" 2>&1 &
pids=$!
slurmd -D -N "$host" >"$work/slurmd.out" 2>&1 &
pids="$pids $!"
for ((k = 0; k < 100; k++)); do
  sinfo -h -o %t 2>/dev/null | grep -q idle && break
  sleep 0.2
done
if ! sinfo -h -o %t 2>/dev/null | grep -q idle; then
  skip "Slurm: its daemons do not start here: $(tail -1 "$slurm/log/slurmd")"
  finish
fi

cp "$here/facts/cube.pl" .
echo "job(a(N), draw, ['cube.pl'], [view(N, 30), output('%.svg')]) @ N in 1..40." >many.pl
tree() {
  (cd "$1" && find . -type f -exec sha256sum {} + &&
    find . -type l -printf '%p -> %l\n') | sort
}
run batch many.pl -o good
mkdir parts
cat >array.sh <<END
#!/bin/bash
#SBATCH --array=5-11:2
cd "$work"
"$sanggwan" batch many.pl -o parts --shard slurm -j 1 \
  --report parts/\$SLURM_ARRAY_TASK_ID.jsonl
END
sbatch --wait -o "$work/task-%a.out" array.sh >"$work/sbatch.out" 2>&1
status=$? err=$(cat "$work/sbatch.out" task-*.out 2>/dev/null)
check 'sbatch' status_is 0
check 'four tasks' is "$(ls parts/*.jsonl | wc -l)" 4
check 'each job once' is "$(cat parts/*.jsonl | grep -c '"outcome":"done"')" 40
run batch --merge parts/*.jsonl -o all.json
check 'merged' has '"jobs":40' all.json
rm -f parts/*.jsonl
check 'the same bytes' is "$(tree parts)" "$(tree good)"
finish
