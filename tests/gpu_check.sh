#!/usr/bin/env bash
# Checks the CUDA backend on this machine's GPU, or packs all that it takes for a machine that has a driver alone.
# usage: tests/gpu_check.sh [BUILD FOLDER]             builds, and checks here; build/gpu if left out
#        tests/gpu_check.sh --bundle DIR [BUILD FOLDER]  builds, and packs: DIR/check checks where DIR is copied to
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
bundle=
if [[ ${1:-} == --bundle ]]; then
  bundle=${2:?a folder for the bundle is missing}
  shift 2
fi
build=${1:-build/gpu}
cmake --preset release -B "$build" -DSPINDRIFT_CUDA=ON >/dev/null
cmake --build "$build" --target spindrift test_gpu --parallel "$(nproc)"

if [[ -z $bundle ]]; then
  exec tests/gpu/check.sh "$build/spindrift" "$build/tests/gpu/test_gpu" . "$build/gpu_check"
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
staging=$scratch/parts
mkdir -p "$staging"/{bin,lib,egl_vendor.d,tests/golden} "$bundle"
cp "$build/spindrift" "$build/tests/gpu/test_gpu" "$staging/bin/"
strip "$staging"/bin/*
# All libraries but libc's own and the driver's. Our own are there for newer processors too, in folders whose names the
# loader knows.
for program in "$staging"/bin/*; do ldd "$program"; done | awk '$3 ~ /^\// { print $3 }' | sort -u |
  grep -vE '/(ld-linux[^/]*|lib(c|m|dl|rt|pthread|resolv|util|anl|cuda|nvidia[^/]*|spindrift[^/]*))\.so[.0-9]*$' |
  xargs cp -L -t "$staging/lib/"
find "$build" -name 'libspindrift_*.so' | while read -r library; do
  level=$(grep -o 'glibc-hwcaps/[^/]*' <<<"$library" || true)
  mkdir -p "$staging/lib/$level"
  cp "$library" "$staging/lib/$level/"
done
find "$staging/lib" -name '*.so*' -exec strip --strip-unneeded {} +
# Where to find the driver's EGL, should the machine not say so itself.
echo '{"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_nvidia.so.0"}}' \
  >"$staging/egl_vendor.d/10_nvidia.json"
cp -r scenes "$staging/"
cp -r tests/golden/. "$staging/tests/golden/"
cp tests/gpu/check.sh "$staging/"
# The two builds of a library beside each other, so that what they have in common is packed once.
find "$staging" ! -type d -printf '%f\t%P\n' | sort | cut -f 2 >"$scratch/files"
rm -rf "${bundle:?}"/{parts,logs,parts.tar.xz}
tar -C "$staging" -c -T "$scratch/files" | xz -9 >"$bundle/parts.tar.xz"
# Bare machines have no xz.
cp -L "$(command -v xz)" "$(ldd "$(command -v xz)" | awk '/liblzma/ { print $3 }')" "$bundle/"

cat >"$bundle/check" <<'CHECK'
#!/usr/bin/env bash
# Unpacks the bundle beside itself, and checks the CUDA backend on this machine's GPU (--cpu: what needs none). Needs a
# driver and libc, nothing else. The table for docs/gpu.md is left in logs/gpu.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
mkdir -p parts logs
LD_LIBRARY_PATH=$PWD ./xz -dc parts.tar.xz | tar -x -C parts
export LD_LIBRARY_PATH=$PWD/parts/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export __EGL_VENDOR_LIBRARY_DIRS=/etc/glvnd/egl_vendor.d:/usr/share/glvnd/egl_vendor.d:$PWD/parts/egl_vendor.d
exec parts/check.sh "$PWD/parts/bin/spindrift" "$PWD/parts/bin/test_gpu" "$PWD/parts" "$PWD/logs" "$@"
CHECK
chmod +x "$bundle/check"
bytes=$(du -bs "$bundle" | cut -f 1)
echo "$bundle: $((bytes / 1000000)) MB; copy it to a machine with a GPU, and run check there"
((bytes <= 60000000)) || { echo "gpu_check: the bundle is larger than 60 MB" >&2; exit 1; }
