#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# resources/slurm/experiment.sh on a cluster of one node, this machine: an array of 5 shards and its merge give the
# content of one run.
# Needs root and Debian's slurm-wlm and munge:   apt-get install slurm-wlm munge
#   slurm.sh PROGRAM SCRIPT
set -uo pipefail
program=$(realpath "$1") script=$(realpath "$2")
for tool in munged slurmctld slurmd sbatch; do
  command -v $tool >/dev/null || { echo "skipped: $tool is missing"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: only root can start a cluster"; exit 77; }

home=$(mktemp -d) && chmod 755 "$home"
trap 'kill $(cat "$home"/*.pid 2>/dev/null) 2>/dev/null; sleep 1; rm -rf "$home"' EXIT
fail() { echo "FAILED: $*"; tail -n 20 "$home"/*.log 2>/dev/null; exit 1; }

# Munge with a key and a socket of its own, then a controller and a node.
head -c 1024 /dev/urandom >"$home/key" && chmod 400 "$home/key"
munged --force --key-file="$home/key" --socket="$home/munge.socket" --pid-file="$home/munged.pid" \
  --log-file="$home/munged.log" \
  --seed-file="$home/seed" || fail "munged"
name=$(hostname -s)
cat >"$home/slurm.conf" <<CONF
ClusterName=one
SlurmctldHost=$name
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$home/munge.socket
CredType=cred/munge
StateSaveLocation=$home/state
SlurmdSpoolDir=$home/spool
SlurmctldPidFile=$home/slurmctld.pid
SlurmdPidFile=$home/slurmd.pid
SlurmctldLogFile=$home/slurmctld.log
SlurmdLogFile=$home/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MailProg=/bin/true
ReturnToService=2
NodeName=$name CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$home/slurm.conf
mkdir -p "$home/state" "$home/spool"
slurmctld || fail "slurmctld"
slurmd || fail "slurmd"
for _ in $(seq 100); do sinfo -h -o %T 2>/dev/null | grep -q idle && break; sleep 0.2; done
sinfo -h -o %T 2>/dev/null | grep -q idle || fail "the node does not come up"

cat >"$home/plan.toml" <<PLAN
lives = 7
[base]
minutes = 1
[pre-learning]
scenario = "2"
until = 100
pool = 3
[[condition]]
name = "TRL {policy.threshold}"
policy = "trl"
set.policy.threshold = [0, 50]
PLAN
content() { grep -o 'content [0-9a-f]*'; }
one=$("$program" experiment "$home/plan.toml" --out "$home/one.sqlite" | content)
SUREFOOT=$program "$script" "$home/plan.toml" 5 "$home/many.sqlite" || fail "submitting"
for _ in $(seq 300); do [ -s "$home/many.sqlite.merge.log" ] && break; sleep 0.2; done
many=$(content <"$home/many.sqlite.merge.log")
[ -n "$one" ] && [ "$one" = "$many" ] || fail "one machine: $one, the cluster: $many"
[ -e "$home/many.sqlite" ] || fail "no store"
echo "passed: $one"
