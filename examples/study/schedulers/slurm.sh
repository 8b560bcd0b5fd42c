#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# A study as an array of Slurm, a shard for each task:
#   sbatch --array=1-16 examples/study/schedulers/slurm.sh TABLE OUT [OPTION of the study]...
# Two minutes before the end of its time a task lets its runs write a checkpoint and stop, and puts
# itself into the queue again. SHARDS is to be set where not the whole array is submitted.
#SBATCH --job-name=riprap-study
#SBATCH --array=1-8
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=4
#SBATCH --time=08:00:00
#SBATCH --signal=B:USR1@120
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=study_%A_%a.log
set -euo pipefail
table=$1
out=$2
study=${STUDY:-build/release/examples/example_study}  # examples/run study --help builds it
shard=$SLURM_ARRAY_TASK_ID/${SHARDS:-$SLURM_ARRAY_TASK_COUNT}

# srun passes the signal on; the study passes it on to its runs, and ends with 75.
interrupted=0
stopped=0
trap 'interrupted=1 stopped=1; kill -USR1 "$child"' USR1
srun --ntasks=1 "$study" "$table" --out "$out" --shard "$shard" \
  --jobs "${SLURM_CPUS_PER_TASK:-1}" "${@:3}" &
child=$!
while :; do
  code=0
  wait "$child" || code=$?
  ((interrupted)) || break  # else a signal has cut the wait short
  interrupted=0
done

# Not without a signal: what is locked by a machine that has died needs --take-over, not patience.
if ((code == 75 && stopped)); then
  exec scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$code"
