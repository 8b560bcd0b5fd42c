#!/usr/bin/env bash
# SPDX-License-Identifier: BSL-1.0
# parallel.sh TABLE OUT [OPTION of GNU parallel]...
# A study by GNU parallel, a job for each run. Called again it goes on: what the log of jobs has as
# done is not started, what has failed or was stopped is. Several machines that share the folder
# (--sshlogin HOST, ... --workdir .) may work on one study.
#   examples/study/schedulers/parallel.sh contact_models out --jobs 8
set -euo pipefail
table=$1
out=$2
study=${STUDY:-build/release/examples/example_study}  # examples/run study --help builds it
[[ -x $study ]] || { echo "no program $study; STUDY names another" >&2; exit 2; }

mkdir -p "$out"
list=$("$study" "$table" --out "$out" --list)
runs=$(wc -l <<<"$list")
# --resume-failed is --resume that takes jobs with another exit code than 0 again.
code=0
parallel --joblog "$out/joblog" --resume-failed "${@:3}" \
  "$study" "$table" --out "$out" --jobs 1 --shard "{}/$runs" ::: $(seq "$runs") || code=$?
"$study" "$table" --out "$out" --summary
exit "$code"
