#!/usr/bin/env bash
# How long the first 0.2 s of scenes/dam_break.json take on one thread, in units of plain arithmetic (reference.cpp),
# and the error at which they do. The least of five runs each, in turn. docs/bench-history.csv has it for each release.
# usage: tests/bench/ratio.sh [BUILD FOLDER, build/release if left out]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
build=${1:-build/release}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

value() { grep -o "\"$1\": [0-9.e-]*" "$out/run.json" | head -n 1 | sed 's/.*: //'; }
least() { sort -g | head -n 1; }
for _ in 1 2 3 4 5; do
  "$build/tests/bench_reference" >>"$out/reference"
  "$build/spindrift" simulate scenes/dam_break.json --threads 1 --no-cache --force --quiet \
    --set video.duration=0.2 -o "$out"
  value simulation_seconds >>"$out/simulation"
done
awk -v s="$(least <"$out/simulation")" -v r="$(least <"$out/reference")" -v version="$(sed -n 's/^project(spindrift VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)" \
  -v mean="$(value worst_mean_compression)" -v most="$(value worst_max_compression)" \
  'BEGIN { printf "version,ratio_to_reference,mean_compression,max_compression\n%s,%.2f,%.2e,%.2e\n", version, s / r, mean, most }'
