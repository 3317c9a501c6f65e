#!/usr/bin/env bash
# soak.sh SECONDS ROOM...: of what ./run soak built, runs all fuzz targets for six tenths of the time, the tests of the rooms
# under the thread sanitizer and valgrind for one each, failing allocations for two, and then all other failing calls.
# Prints a table; fails on a finding.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
readonly seconds=$1 jobs=${SYMSCENE_JOBS:-$(nproc)} out=out/soak
readonly rooms=("${@:2}")
mkdir -p "$out"
findings=0

row() { printf '%-34s %14s %10s %10s\n' "$@"; }

# fuzz TARGET SECONDS: new inputs stay in out/soak/corpus, what breaks a reader in out/soak/found.
fuzz() {
  local name=${1##*symscene_fuzz_}
  mkdir -p "$out/corpus/$name" "$out/found/$name"
  "$1" -max_total_time="$2" -timeout=10 -rss_limit_mb=1024 -max_len=8192 -print_final_stats=1 \
    -artifact_prefix="$out/found/$name/" "$out/corpus/$name" "fuzz/corpus/$name" >"$out/fuzz-$name.log" 2>&1
}

fuzz_all() {
  local targets=(build-sanitizers/fuzz/symscene_fuzz_*) target name executions coverage found
  local share=$((seconds * 6 * jobs / 10 / ${#targets[@]}))
  export -f fuzz
  export out
  printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c 'fuzz "$@"' fuzz {} $((share > 0 ? share : 1))
  for target in "${targets[@]}"; do
    name=${target##*symscene_fuzz_}
    executions=$(sed -n 's/^stat::number_of_executed_units: *//p' "$out/fuzz-$name.log")
    coverage=$(sed -n 's/.* cov: \([0-9]*\) .*/\1/p' "$out/fuzz-$name.log" | tail -1)
    found=$(find "$out/found/$name" -type f | wc -l)
    [[ -n $executions ]] || found=$((found + 1)) # it did not run: see its log
    findings=$((findings + found))
    row "fuzz $name" "${executions:--}" "${coverage:--}" "$found"
  done
}

# test_room KIND ROOM SECONDS COMMAND...: the tests of a room until the time is over; a timeout is no finding.
test_room() {
  local kind=$1 room=$2 log=$out/$1-$2.log code passed
  timeout "$3" "${@:4}" >"$log" 2>&1
  code=$?
  passed=$(grep -c '^\[       OK \]' "$log")
  if ((code != 0 && code != 124)); then
    findings=$((findings + 1))
    row "$kind $room" "$passed tests" - "1 ($log)"
  else
    row "$kind $room" "$passed tests" - 0
  fi
}

row part executions coverage findings
fuzz_all
share=$((seconds / 10 / ${#rooms[@]}))
share=$((share > 10 ? share : 10))
for room in "${rooms[@]}"; do
  test_room threads "$room" "$share" env TSAN_OPTIONS=halt_on_error=1 "build-tsan/tests/symscene_test_$room"
done
if command -v valgrind >/dev/null; then
  for room in "${rooms[@]}"; do
    test_room valgrind "$room" "$share" valgrind --quiet --error-exitcode=9 --exit-on-first-error=yes \
      "build/tests/symscene_test_$room" --gtest_filter='-*ForAnyNumberOfThreads*'
  done
else
  echo "No valgrind"
fi
commands=18
share=$((seconds / 5 / commands))
test_room faults commands $((seconds + 3600)) env SYMSCENE_FAULT_SECONDS=$((share > 0 ? share : 1)) build/tests/symscene_test_faults
grep '^faults: ' "$out/faults-commands.log"
((findings == 0)) || { echo "$findings findings: see $out"; exit 1; }
