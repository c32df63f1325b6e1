#!/usr/bin/env bash
# What is at fault is named: a variable of the environment, or a limit of the system; nothing ends in a signal.
# Usage: shortage.sh PROGRAM, from the source tree's root. Returns 1 if a check fails.
# shellcheck source=tests/cli/common.sh
. "$(dirname "$0")/common.sh"
render() {
  spindrift render scenes/dam_break.json --set fluid.spacing=0.1 --set video.duration=0.1 --set video.width=32 \
    --set video.height=32 --quiet -o "$folder/run"
}

__EGL_VENDOR_LIBRARY_FILENAMES=/no/such/file.json render
code=$?
((code == 3)) || fail "without a driver it returned $code"
grep -q "unset __EGL_VENDOR_LIBRARY_FILENAMES=/no/such/file.json" "$folder/err" || fail "it did not name the variable"
grep -q "install" "$folder/err" && fail "it blamed a package"

# With ever more address space: in words until it is enough.
enough=
for mib in 200 300 400 500 600 700 800 1000 1200 1600 2400 4000; do
  (ulimit -v $((mib * 1024)) && render)
  code=$?
  ((code == 0)) && enough=yes && continue
  ((code == 127)) && grep -q "shared librar" "$folder/err" && continue  # the system did not get as far as the program
  ((code == 3)) || fail "with $mib MiB it returned $code"
  grep -q "memory" "$folder/err" || fail "with $mib MiB it did not say that memory is short"
  grep -q "install\|[Gg]eneric" "$folder/err" && fail "with $mib MiB it blamed something else"
done
[[ -n $enough ]] || fail "4000 MiB were not enough"
exit 0
