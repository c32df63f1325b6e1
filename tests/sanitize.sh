#!/usr/bin/env bash
# Builds the tests with the address and undefined-behaviour sanitizers, runs the fast ones, and prints which part of the
# lines of sim, render and app they have run; fails where a test does, or where that is less than nine tenths. The slow
# tests, which are left out, run besides most of what sweeps, golden tests and the benchmark do.
# usage: tests/sanitize.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. tests/tools.sh
readonly build=build/sanitize least_percent=90
# Tests that open a GL context: drivers leak on purpose, so that leaks are not looked for there.
readonly draws='^(gl|golden|render|pipeline|cli)'

need clang libclang-rt-dev libomp-dev llvm
quietly cmake --preset sanitize
quietly cmake --build --preset sanitize --parallel "$(nproc)"

rm -rf "$build/profiles"
export UBSAN_OPTIONS=print_stacktrace=1 LLVM_PROFILE_FILE=$PWD/$build/profiles/%4m.profraw
fast_tests() {
  ctest --preset sanitize --label-exclude 'slow|long' --parallel "$(nproc)" --no-tests=error --quiet \
    --output-log "$build/tests.log" "$@" || { cat "$build/tests.log"; return 1; }
  tail -n 3 "$build/tests.log"
}
ASAN_OPTIONS=detect_leaks=1 fast_tests --exclude-regex "$draws"
# The benchmark's many runs take as long as all other tests, and simulate with the same code.
ASAN_OPTIONS=detect_leaks=0 fast_tests --tests-regex "$draws" --exclude-regex '^cli:bench'

# clang's own counts of lines: gcovr, which reads what gcov prints for each batch with all its headers, takes minutes.
llvm-profdata merge -sparse "$build"/profiles/*.profraw -o "$build/profile"
binaries=()
for binary in "$build"/tests/test_* $(find "$build" -name 'libspindrift_*.so'); do
  [[ -f $binary && -x $binary ]] && binaries+=(-object "$binary")
done
llvm-cov report "$build/spindrift" "${binaries[@]}" -instr-profile "$build/profile" \
  -ignore-filename-regex "^/usr/|^$PWD/(tests|build)/" >"$build/coverage.txt" 2>"$build/coverage.log" ||
  { cat "$build/coverage.log"; exit 1; }
# A file's columns 8 to 10 are its lines, those that did not run, and the percentage of those that did.
awk -v least="$least_percent" '
  $1 ~ /^(sim|render|app)\// {
    split($1, path, "/"); lines[path[1]] += $8; missed[path[1]] += $9; all += $8; all_missed += $9 }
  END {
    if (!all) { print "coverage: no lines were counted"; exit 1 }
    for (folder in lines)
      printf "%s: %.1f %% of %d lines run\n", folder, 100 * (1 - missed[folder] / lines[folder]), lines[folder]
    percent = 100 * (1 - all_missed / all)
    printf "sim, render and app: %.1f %%\n", percent
    if (percent < least) { printf "coverage: less than %d %% of the lines were run\n", least; exit 1 }
  }' "$build/coverage.txt"
