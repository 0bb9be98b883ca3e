# shellcheck shell=bash
# A Slurm cluster on loopback for a test: to be sourced. Two nodes of two workers each on this
# machine, with a munge key of its own, all in a directory; no service of the system is touched.
#   start_slurm DIR     exports SLURM_CONF; returns 77 where Slurm is not installed
#   stop_slurm          ends the daemons that it started, and no others

slurm_daemons=()
PATH=$PATH:/usr/sbin:/sbin  # the daemons' place, which a user's PATH may lack

slurm_start_daemon() {  # LOG COMMAND...: ends with the test, however that ends
  setpriv --pdeathsig TERM "${@:2}" >"$1" 2>&1 &
  slurm_daemons+=($!)
}

slurm_free_port() {
  local port=$((20000 + RANDOM % 30000))
  while (: <>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
  echo "$port"
}

start_slurm() {
  local tool directory=$1 host user
  for tool in slurmctld slurmd munged sbatch squeue scontrol setpriv; do
    command -v "$tool" >/dev/null || { echo "$tool is not installed"; return 77; }
  done
  host=$(hostname -s)
  user=$(id -un)
  mkdir -m 755 "$directory" "$directory/state"
  (umask 077 && head -c 128 /dev/urandom >"$directory/munge.key")
  cat >"$directory/slurm.conf" <<EOF
ClusterName=fleet
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(slurm_free_port)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$directory/munge.socket
CredType=cred/munge
StateSaveLocation=$directory/state
SlurmdSpoolDir=$directory/spool-%n
SlurmctldPidFile=$directory/slurmctld.pid
SlurmdPidFile=$directory/slurmd-%n.pid
MailProg=/bin/true
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
MinJobAge=7200
SchedulerParameters=batch_sched_delay=0,sched_min_interval=0,sched_interval=1
SlurmdParameters=config_overrides
MpiDefault=none
ReturnToService=2
NodeName=worker1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(slurm_free_port) CPUs=2
NodeName=worker2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(slurm_free_port) CPUs=2
PartitionName=fleet Nodes=worker1,worker2 Default=YES MaxTime=INFINITE State=UP
EOF
  # From 22.05 on slurmd looks for cgroups, used or not; this plugin starts where none are mounted,
  # as in a container. 21.08 does not know the key.
  case $(slurmd -V) in
    *" 21."* | *" 20."*) ;;
    *) echo "CgroupPlugin=cgroup/v1" >"$directory/cgroup.conf" ;;
  esac
  export SLURM_CONF=$directory/slurm.conf
  slurm_start_daemon "$directory/munged.log" munged --foreground --force \
    --key-file="$directory/munge.key" --socket="$directory/munge.socket" \
    --pid-file="$directory/munge.pid" --log-file="$directory/munge.own.log" \
    --seed-file="$directory/munge.seed"
  local tries=100
  until [ -S "$directory/munge.socket" ]; do
    sleep 0.1
    [ $((tries -= 1)) -gt 0 ] || { cat "$directory/munged.log"; return 1; }
  done
  slurm_start_daemon "$directory/slurmctld.log" slurmctld -D
  slurm_start_daemon "$directory/worker1.log" slurmd -D -N worker1
  slurm_start_daemon "$directory/worker2.log" slurmd -D -N worker2
  tries=300
  until [ "$(sinfo -h -N -t idle -o %N 2>/dev/null | sort -u | wc -l)" -eq 2 ]; do
    sleep 0.1
    [ $((tries -= 1)) -gt 0 ] || { tail -n 20 "$directory"/*.log; return 1; }
  done
}

stop_slurm() {
  local daemon
  for daemon in $(printf '%s\n' "${slurm_daemons[@]}" | tac); do
    kill "$daemon" 2>/dev/null
    wait "$daemon" 2>/dev/null
  done
  slurm_daemons=()
}
