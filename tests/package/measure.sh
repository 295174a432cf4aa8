#!/usr/bin/env bash
# measure.sh SOURCE PREFIX ENGINES: what embedding costs: sizes of the installed package, time to configure and build
# the core alone, and what its calls cost.
set -euo pipefail
unset CMAKE_CXX_COMPILER_LAUNCHER
size() { printf '%-34s %8d KiB\n' "$1" "$(($(cat "${@:2}" | wc -c) / 1024))"; }
libraries=$(dirname "$(find "$2" -name liblobelia.a)")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
strip -o "$folder/shared" "$libraries/liblobelia.so"
strip --strip-unneeded -o "$folder/static.a" "$libraries/liblobelia.a"
size 'static library, stripped' "$folder/static.a"
size 'shared library, stripped' "$folder/shared"
size 'headers of the core' "$2"/include/lobelia/*.h
size 'GLSL' "$2"/include/lobelia/*.glsl

seconds() { # NAME COMMAND...
    local TIMEFORMAT="$1 %R s, of the processor %U s"
    time "${@:2}" >/dev/null
}
alone=(-DLOBELIA_HOST=OFF -DLOBELIA_CLI=OFF -DLOBELIA_TESTS=OFF -DLOBELIA_SHARED=OFF -DLOBELIA_INSTALL=OFF)
seconds 'configure the core alone:' \
    cmake -S "$1" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${alone[@]}"
seconds 'build it:' cmake --build "$folder/build"
"$3/costs"
