#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs an experiment on a Slurm cluster: an array of shards, and a merge that waits for all of them.
#
#   experiment.sh PLAN SHARDS STORE [OPTIONS of surefoot experiment…]
#   e.g.  experiment.sh my-plan.toml 20 /scratch/me/my.sqlite --lives 200
#
# Every shard writes STORE.shard-I-of-N beside STORE, so the folder must be one that all nodes share. A shard that is
# stopped (a node fails, its time is up) goes on where it was when this script is called again with the same
# arguments. Environment:
#   SUREFOOT           the program [surefoot]
#   SUREFOOT_SBATCH    options for every job, e.g. "--partition=short --time=2:00:00"
#   SUREFOOT_CPUS      processors a shard [1]
set -euo pipefail
if [ $# -lt 3 ] || ! [[ $2 =~ ^[1-9][0-9]{0,4}$ ]]; then
  sed -n 's/^# \{0,1\}//; 5,14p' "$0" >&2
  exit 2
fi
plan=$1 shards=$2 store=$(realpath -m "$3")
shift 3
program=${SUREFOOT:-surefoot} cpus=${SUREFOOT_CPUS:-1}
[ -e "$store" ] && { echo "$store exists already; name another file." >&2; exit 3; }
[ -f "$plan" ] && plan=$(realpath "$plan")
read -ra options <<<"${SUREFOOT_SBATCH:-}"

# One command line for the array and one for the merge, quoted for the job's shell.
shard=$(printf '%q ' "$program" experiment "$plan" --resume --jobs "$cpus" "$@")
part=$(printf '%q' "$store")
array=$(sbatch --parsable "${options[@]}" --job-name=surefoot --cpus-per-task="$cpus" --array="1-$shards" \
  --output="$store.shard-%a.log" \
  --wrap "$shard --shard \$SLURM_ARRAY_TASK_ID/$shards --out $part.shard-\$SLURM_ARRAY_TASK_ID-of-$shards")
parts=""
for ((i = 1; i <= shards; ++i)); do parts+="$part.shard-$i-of-$shards "; done
merge=$(sbatch --parsable "${options[@]}" --job-name=surefoot-merge \
  --dependency="afterok:${array%%;*}" --kill-on-invalid-dep=yes \
  --output="$store.merge.log" --wrap "$(printf '%q' "$program") merge $parts --out $part && rm -f $parts")
echo "shards: job ${array%%;*}, merge: job ${merge%%;*} → $store"
