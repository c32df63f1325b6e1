# What the scripts of this folder share; each is started with the program as its first word, and sources this.
# Leaves `program`, the program's path, and `folder`, a folder for files that goes away when the script ends.
# shellcheck shell=bash
set -uo pipefail
program=$(readlink -f "$1")
folder=$(mktemp -d)
clean_up() { rm -rf "$folder"; }
trap clean_up EXIT

# spindrift WORD...: runs the program; what it prints is in $folder/out and $folder/err from here on.
spindrift() { "$program" "$@" >"$folder/out" 2>"$folder/err" </dev/null; }

# fail WHAT: ends the script, with what the program has printed.
fail() {
  echo "FAILED: $*"
  head -n 20 "$folder/out" "$folder/err" 2>/dev/null
  exit 1
}

# refuse TEXT COMMAND WORD...: the command takes this for bad input, says the text on stderr, and leaves nothing.
refuse() {
  local text=$1 code
  shift
  spindrift "$@" -o "$folder/refused"
  code=$?
  ((code == 2)) || fail "$* returned $code instead of 2"
  grep -qF -- "$text" "$folder/err" || fail "$* did not say \"$text\""
  [[ ! -s $folder/out && ! -e $folder/refused ]] || fail "$* did something"
}

# wait_until COMMAND WORD...: until it succeeds; fails after two minutes.
wait_until() {
  local try
  for ((try = 0; try < 6000; ++try)); do
    "$@" && return
    sleep 0.02
  done
  return 1
}
