#!/bin/sh
# Usage: sweep_check.sh run_and_resume|job_list DDA_VERIFY SPECS WORK
set -eu
what=$1 program=$2 specs=$3 work=$4

fail() {
  echo "sweep_check: $*" >&2
  exit 1
}

# Jobs of that status in the table.
count() { grep -c "^[0-9]*,$1," "$work/out/results.csv" || true; }

rm -rf "$work"
mkdir -p "$work"
case $what in
run_and_resume)
  "$program" sweep "$specs/small.json" --out "$work/out" --jobs 2
  [ "$(count ok)" = 4 ] && [ "$(count not_measurable)" = 2 ] || fail "not 4 jobs measured and 2 not measurable"
  code=0
  "$program" sweep "$specs/small.json" --out "$work/out" 2>"$work/refused" || code=$?
  [ "$code" = 2 ] && grep -q "$work/out.*--resume" "$work/refused" || fail "ran again over the jobs of the folder"
  [ -s "$work/out/plots/velocity_block_length_dt_1.svg" ] || fail "no plot"
  touch -d 2001-01-01 "$work"/out/jobs/*.json
  rm "$work/out/jobs/3.json"
  cp "$work/out/results.csv" "$work/before.csv"
  "$program" sweep "$specs/small.json" --out "$work/out" --resume
  [ "$(find "$work/out/jobs" -newermt 2002-01-01 -name '*.json')" = "$work/out/jobs/3.json" ] ||
    fail "resuming did not run job 3 alone"
  grep -v ^3, "$work/before.csv" >"$work/before_others.csv"
  grep -v ^3, "$work/out/results.csv" | cmp - "$work/before_others.csv" || fail "rows of finished jobs have changed"
  ;;
job_list)
  printf '{"grid": {"block_length": [10], "dt": [2e-4, 3e-4]}}' >"$work/two jobs.json"
  "$program" sweep "$work/two jobs.json" --out "$work/out" --job-list
  parallel --jobs 2 <"$work/out/jobs.txt"
  "$program" collect "$work/out"
  [ "$(count ok)" = 2 ] || fail "GNU parallel did not run both jobs"
  rm "$work"/out/jobs/*.json
  for task in 1 2; do SLURM_ARRAY_TASK_ID=$task sh "$work/out/slurm.sh"; done
  "$program" collect "$work/out"
  [ "$(count ok)" = 2 ] || fail "the script of the Slurm array did not run both jobs"
  printf '{"grid": {"block_length": [10], "dt": [2e-4], "spring_over_young": [10, 1e30]}}' >"$work/one_fails.json"
  "$program" sweep "$work/one_fails.json" --out "$work/fails" --job-list
  code=0
  parallel --jobs 2 <"$work/fails/jobs.txt" || code=$?
  [ "$code" = 1 ] || fail "GNU parallel counted $code failed jobs, not 1"
  code=0
  SLURM_ARRAY_TASK_ID=2 sh "$work/fails/slurm.sh" || code=$?
  [ "$code" = 1 ] || fail "the failed task of the Slurm array ended with $code, not 1"
  ;;
*) fail "no check \"$what\"" ;;
esac
