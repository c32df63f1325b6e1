#!/usr/bin/env bash
# Has clang-tidy go through sim, render and app, as .clang-tidy says; fails where it finds something. It reads the
# sources in batches, since each batch reads its headers once.
# usage: tests/tidy.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
. tests/tools.sh
need clang clang-tidy libomp-dev
quietly cmake --preset tidy
quietly cmake --build build/tidy --target page_headers shader_header
quietly run-clang-tidy -quiet -p build/tidy -j "$(nproc)"
echo "no findings in sim, render and app"
