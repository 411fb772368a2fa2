#!/bin/sh
# Small readings of chapters 5 and 6 as a user runs them: verdicts, and a second time with nothing left to run.
# Usage: thesis_check.sh DDA_VERIFY WORK
set -eu
program=$1 work=$2

fail() {
  echo "thesis_check: $*" >&2
  exit 1
}

rm -rf "$work"
"$program" thesis --chapter 5 --chapter 6 --quick --out "$work" --jobs 2 >"$work.first"
# A tunnel of 10 m in dry rock of joints at 60 degrees: friction of 65 degrees holds block 1, and how fast it is thrown
# out grows with the stress.
for id in 5-field-earlier 6.1-block-1-stays 6.1-velocity-rises 6.1-velocity-linear 6.1-acceleration-rises \
  6.1-wall-above-far 6.1-wall-response-rises; do
  grep -q "^confirmed  *$id:" "$work.first" || fail "$id is not confirmed"
done
grep -q '"confirmed": null' "$work/thesis.json" || fail "what is not judged is not null"
for page in chapter_5.md chapter_6.md; do [ -s "$work/$page" ] || fail "no $page"; done
"$program" thesis --chapter 5 --chapter 6 --quick --out "$work" --jobs 2 >"$work.second"
! grep -q "^[0-9]* of [0-9]*: " "$work.second" || fail "ran again what was done"
grep -v "^[0-9]* of [0-9]*: " "$work.first" | cmp - "$work.second" || fail "verdicts have changed"
