#!/usr/bin/env bash
# Fails where an include runs up or sideways against the floors of docs/architecture.md, or where a folder of sources
# is not on them. Usage: layers.sh [FOLDER of the project]
set -euo pipefail
cd "${1:-$(dirname "${BASH_SOURCE[0]}")/..}"

grep -rEn --include='*.cpp' --include='*.hpp' '^ *# *include "(sim|render|app)/' sim render app |
  awk '
    function room_of(path,  room) {  # the longest listed folder that it is in
      for (room = path; room != "" && !(room in floor);) {
        if (room !~ /\//) return ""
        sub(/\/[^\/]*$/, "", room)
      }
      return room
    }
    FILENAME == "docs/architecture.md" {
      if (/^```floors/) inside = 1
      else if (/^```/) inside = 0
      else if (inside) { ++level; for (k = 1; k <= NF; ++k) floor[$k] = level }
      next
    }
    {
      split($0, found, ":"); split($0, quoted, "\"")
      file = found[1]; from = room_of(file); to = room_of(quoted[2])
      wing = substr(from, 1, index(from "/", "/") - 1); other = substr(to, 1, index(to "/", "/") - 1)
      ++count
      if (from == "" || to == "") print file ": " quoted[2] ": a folder is not on the floors"
      else if (from != to && floor[to] >= floor[from]) print file ":" found[2] ": " quoted[2] " is not below " from
      else if (wing != other && wing != "app") print file ":" found[2] ": " wing " does not know " other
      else next
      wrong = 1
    }
    END {
      if (level == 0 || count < 100) { print "no floors, or no includes, were found"; exit 1 }
      if (!wrong) print count " includes run down"
      exit wrong
    }' docs/architecture.md -
