#!/usr/bin/env bash
# program.sh BUILD SOURCE PREFIX: the program is built from its own files and the public headers, which are those
# of the package, byte for byte.
set -euo pipefail
cd -- "$1"
used=$(ninja -t deps | awk -v root="$2/" '
    /^viewer\// { ours = 1; next }
    /^[^ ]/ { ours = 0; next }
    ours { print $1 }' | xargs -r realpath | sort -u)
[[ $used == *"$2/include/lobelia/host/gpu.h"* ]] || { echo "ninja knows of no public header in use"; exit 1; }
private=$(grep "^$2/" <<<"$used" | grep -vE "^$2/(viewer|include/lobelia|shaders/lobelia|build)/" || true)
[[ -z $private ]] || { printf 'the program includes what is not installed:\n%s\n' "$private"; exit 1; }
for folder in include shaders; do
    (cd -- "$2/$folder" && find lobelia -type f) | while read -r file; do
        cmp -- "$2/$folder/$file" "$3/include/$file"
    done
done
