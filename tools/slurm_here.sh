#!/usr/bin/env bash
# Runs a Slurm cluster on this machine alone, for tests. It needs no systemd and no accounting and writes only to DIR.
#   tools/slurm_here.sh start DIR       starts munged, slurmctld and a node; when they are ready DIR/env can be sourced
#   tools/slurm_here.sh kill-node DIR   kills the node's daemon and its jobs, as if its power failed
#   tools/slurm_here.sh start-node DIR  starts the node again
#   tools/slurm_here.sh stop DIR        stops everything
#   tools/slurm_here.sh possible        exit code 0 if `start` can work; else 1, and a line that says why not
# Debian packages: slurmctld, slurmd, slurm-client, munge (all in slurm-wlm). The script must run as root, for example
# as root of a container.
set -euo pipefail

possible() {
  local missing=()
  for program in munged slurmctld slurmd sbatch squeue scontrol sinfo; do
    PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || missing+=("$program")
  done
  [ ${#missing[@]} -eq 0 ] || { echo "no ${missing[*]}: apt-get install slurm-wlm munge"; return 1; }
  [ "$(id -u)" -eq 0 ] || { echo "not root, as which slurmd starts jobs"; return 1; }
}

free_port() {
  local port
  for port in $(shuf -i 20000-32000 -n 50); do
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || { echo "$port"; return; }
  done
  echo "slurm_here.sh: no free port" >&2
  return 1
}

# wait_for SECONDS COMMAND... repeats the command until it succeeds. After SECONDS it prints the ends of all logs and
# fails.
wait_for() {
  local seconds=$1 tenths log
  shift
  for ((tenths = 0; tenths < 10 * seconds; ++tenths)); do
    "$@" >/dev/null 2>&1 && return
    sleep 0.1
  done
  echo "slurm_here.sh: not within $seconds s: $*" >&2
  for log in "$directory"/*.log; do tail -n 5 "$log" >&2; done
  return 1
}

node_is_up() { sinfo -h -o %T | grep -q -E '^(idle|mixed|allocated)$'; }

start_node() {
  slurmd -N here -f "$directory/slurm.conf" -L "$directory/slurmd.log" >>"$directory/slurmd.out" 2>&1 </dev/null ||
    { tail -n 5 "$directory/slurmd.log" >&2; return 1; }
  scontrol update nodename=here state=resume >/dev/null 2>&1 || true  # Slurm may have marked the node as down
  wait_for 60 node_is_up
}

below() {
  local child
  for child in $(pgrep -P "$1" || true); do
    echo "$child"
    below "$child"
  done
}

# Kills the daemon of the node. For each job it also kills the process that supervises the job, the script of the job
# (found by its path in the node's spool directory) and all their child processes.
kill_node() {
  local entry pid doomed=()
  pid=$(cat "$directory/slurmd.pid" 2>/dev/null || true)
  [ -z "$pid" ] || doomed+=("$pid")
  for entry in /proc/[0-9]*; do
    { tr '\0' ' ' <"$entry/cmdline"; } 2>/dev/null | grep -q -F -e "$directory/spool/job" || continue
    pid=${entry#/proc/}
    [ "$pid" = "$$" ] || doomed+=("$(ps -o ppid= -p "$pid" | tr -d ' ')" "$pid")
    mapfile -t -O "${#doomed[@]}" doomed < <(below "$pid")
  done
  for pid in "${doomed[@]}"; do [ "${pid:-1}" -le 1 ] || kill -9 "$pid" 2>/dev/null || true; done
  rm -f "$directory/slurmd.pid"
}

# Kills the node and marks it as down. Slurm itself would mark the node only after SlurmdTimeout.
lose_node() {
  kill_node
  scontrol update nodename=here state=down reason=killed
}

start() {
  possible >&2
  umask 022
  [ ! -e "$directory/env" ] || { echo "slurm_here.sh: one is there already; stop $directory first" >&2; return 1; }
  mkdir -p "$directory/state" "$directory/spool"
  chmod 755 "$directory"
  export SLURM_CONF=$directory/slurm.conf
  printf 'export SLURM_CONF=%q\n' "$SLURM_CONF" >"$directory/env.new"
  if [ ! -e "$directory/munge.key" ]; then
    (umask 077 && head -c 128 /dev/urandom >"$directory/munge.key")
    cat >"$directory/slurm.conf" <<CONF
ClusterName=here
SlurmctldHost=$(hostname)(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$directory/munge.socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$directory/state
SlurmdSpoolDir=$directory/spool
SlurmctldPidFile=$directory/slurmctld.pid
SlurmdPidFile=$directory/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SchedulerParameters=sched_interval=1,batch_sched_delay=1
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
SlurmdTimeout=5
SlurmctldTimeout=5
BatchStartTimeout=10
KillWait=5
MinJobAge=300
NodeName=here NodeHostname=$(hostname) NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=1000000 State=UNKNOWN
PartitionName=all Nodes=here Default=YES MaxTime=INFINITE State=UP
CONF
    # Slurm loads a plugin for cgroups although this cluster uses none. The plugin for version 2 would need systemd, so
    # this file chooses version 1.
    echo 'CgroupPlugin=cgroup/v1' >"$directory/cgroup.conf"
  fi
  munged --force --key-file "$directory/munge.key" --socket "$directory/munge.socket" \
    --pid-file "$directory/munged.pid" --log-file "$directory/munged.log" --seed-file "$directory/munged.seed" \
    --num-threads 2 >>"$directory/munged.out" 2>&1 </dev/null
  slurmctld -f "$SLURM_CONF" -L "$directory/slurmctld.log" >>"$directory/slurmctld.out" 2>&1 </dev/null
  wait_for 60 scontrol ping
  start_node
  mv "$directory/env.new" "$directory/env"
}

# Asks a process to end and waits for up to 10 s. In this time slurmctld saves its state.
end() {
  local asked
  for ((asked = 0; asked < 100; ++asked)); do
    kill "$1" 2>/dev/null || return 0
    [ "$(ps -o stat= -p "$1" | cut -c1)" != Z ] || return 0
    sleep 0.1
  done
}

stop() {
  local name pid
  kill_node
  for name in slurmctld munged; do
    pid=$(cat "$directory/$name.pid" 2>/dev/null || true)
    [ -z "$pid" ] || end "$pid"
  done
  rm -f "$directory/env"
}

PATH=$PATH:/usr/sbin
case ${1:-} in possible) possible; exit ;; esac
[ $# -eq 2 ] || { sed -n '2,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2; }
directory=$(realpath -m "$2")
export SLURM_CONF=$directory/slurm.conf
case $1 in
  start) start ;;
  kill-node) lose_node ;;
  start-node) start_node ;;
  stop) stop ;;
  *) echo "slurm_here.sh: unknown command '$1'; allowed: start, kill-node, start-node, stop, possible" >&2; exit 2 ;;
esac
