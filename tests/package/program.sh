#!/usr/bin/env bash
# program.sh BUILD SOURCE PREFIX: the program is built from its own files and the public headers, which are those
# of the package, byte for byte, and linked with the package's libraries it is the same program.
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

libraries=$(dirname -- "$(find "$3" -name liblobelia_host.a)")
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
link=$(ninja -t commands lobelia_cli | tail -1)
replace() { # OLD NEW: in the link, once
    [[ $link == *" $1 "* ]] || { echo "the program's link has no $1: $link"; exit 1; }
    link=${link/ "$1" / "'$2'" }
}
replace viewer/lobelia "$folder/lobelia"
replace lib/host/liblobelia_host.a "$libraries/liblobelia_host.a"
replace lib/liblobelia.a "$libraries/liblobelia.a"
eval "$link"
[[ $("$folder/lobelia" --version) == $(viewer/lobelia --version) ]]
