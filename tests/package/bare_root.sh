#!/usr/bin/env bash
# bare_root.sh BUILD FOLDER: makes the Debian package of the release build BUILD, installs it in a bare Debian 12 in
# FOLDER, and there builds the engines of tests/examples against it and runs them under validation: silent, and
# showing what the program shows. As root; needs debootstrap and openimageio-tools.
set -euo pipefail
build=$(realpath -- "$1") folder=$2 source=$(cd -- "$(dirname -- "$0")/../.." && pwd)
step() { printf '%s\n' "== $*"; }
inside() { chroot "$folder" env DEBIAN_FRONTEND=noninteractive LC_ALL=C HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin "$@"; }
add() { inside apt-get -qq -y --no-install-recommends install "$@" >"$folder.log" 2>&1 || { cat "$folder.log"; exit 1; }; }
fail() { echo "$*"; exit 1; }

step 'the package'
(cd -- "$build" && rm -f lobelia_*.deb && cpack --config CPackConfig.cmake -B "$build" >/dev/null)
[[ -e $folder/etc/debian_version ]] || debootstrap --variant=minbase bookworm "$folder" >/dev/null
mkdir -p "$folder/srv"
mount -t proc proc "$folder/proc"
mount --bind /dev "$folder/dev"
trap 'umount -- "$folder"/{proc,dev}' EXIT
cp -- "$build"/lobelia_*.deb "$folder/srv/lobelia.deb"
inside apt-get -qq update
add /srv/lobelia.deb

step 'the program'
inside sh -c 'cd /srv && lobelia render --size 96x96 -o sphere.exr && lobelia devices'

step 'the engines'
add g++ cmake ninja-build glslang-tools libvulkan-dev libvulkan-volk-dev libglfw3-dev vulkan-validationlayers xvfb xauth
rm -rf -- "$folder"/srv/{examples,engines}
cp -r -- "$source/tests/examples" "$folder/srv/examples"
inside cmake -S /srv/examples -B /srv/engines -G Ninja -DCMAKE_BUILD_TYPE=Release >/dev/null
inside ninja -C /srv/engines | tail -1
run() { # CHECKS COMMAND...: without a word of the validation layer
    local heard
    heard=$(inside env -C /srv VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation \
        VK_LAYER_ENABLES="VK_VALIDATION_FEATURE_ENABLE_$1_EXT" "${@:2}" 2>&1) || fail "${*:2} failed: $heard"
    ! grep -E 'VUID|SYNC-|UNASSIGNED' <<<"$heard" || fail "${*:2} said: $heard"
}
for engine in minimal async render_pass two_devices window; do
    shown=()
    [[ $engine != window ]] || shown=(xvfb-run -a)
    run SYNCHRONIZATION_VALIDATION "${shown[@]}" "engines/$engine" "$engine.pfm"
    oiiotool "$folder/srv/sphere.exr" --ch R,G,B "$folder/srv/$engine.pfm" --fail 0 --warn 0 --diff >/dev/null ||
        fail "$engine shows another picture than the program"
    echo "$engine: silent, the program's picture"
done
run SYNCHRONIZATION_VALIDATION engines/mesh knot knot.pfm 480 270 3
run GPU_ASSISTED engines/minimal again.pfm
cmp "$folder"/srv/{minimal,again}.pfm
echo 'mesh: silent; minimal: silent under GPU-assisted validation, too'
