# shellcheck shell=bash
# What the scripts of the checks share; each of them sources this.

# quietly COMMAND WORD...: runs it, and shows what it printed where it fails.
quietly() {
  local log
  log=$(mktemp)
  "$@" >"$log" 2>&1 || { cat "$log"; rm -f "$log"; return 1; }
  rm -f "$log"
}

# need PACKAGE...: installs those of Debian's packages that are missing; elsewhere it trusts that they are there.
need() {
  local missing=() package as_root=()
  command -v apt-get >/dev/null || return 0
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  echo "installing ${missing[*]}"
  ((EUID == 0)) || as_root=(sudo -n)
  quietly "${as_root[@]}" apt-get -qq update
  quietly "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends \
    "${missing[@]}"
}
