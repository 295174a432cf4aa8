#!/usr/bin/env bash
# pkg_config.sh PREFIX SOURCE COMPILER [OPTION...]: builds and runs it by what pkg-config says of the package.
set -euo pipefail
file=$(find "$1" -name lobelia.pc)
export PKG_CONFIG_PATH=${file%/*}
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
# shellcheck disable=SC2046 # several words
"${@:3}" -std=c++20 "$2" $(pkg-config --cflags --libs lobelia) -o "$folder/program"
LD_LIBRARY_PATH=$(pkg-config --variable=libdir lobelia) "$folder/program"
