#!/usr/bin/env bash
# symbols.sh PREFIX: what the installed core needs and shows, as its object files say.
set -euo pipefail
shared=$(echo "$1"/lib*/liblobelia.so "$1"/lib/*/liblobelia.so | tr ' ' '\n' | grep -v '\*' | head -1)
static=${shared%.so}.a
failed=0
refuse() { # WHAT LINE...
    [[ -z $2 ]] || { printf '%s:\n%s\n' "$1" "$2"; failed=1; }
}

undefined=$(nm --undefined-only "$static" "$shared")
[[ $undefined == *malloc* || $undefined == *_Znwm* ]] || refuse "nm lists nothing that is undefined" "$undefined."
refuse "Vulkan functions that someone else would have to define" "$(grep -E ' vk[A-Z]' <<<"$undefined" || true)"

exported=$(nm --dynamic --defined-only --demangle "$shared")
[[ $exported == *"lobelia::Prefilter::create("* ]] || refuse "the shared library lacks Prefilter::create" "$exported."
refuse "exported, and not of lobelia" "$(grep -vE '^[0-9a-f]+ [A-Z] lobelia::' <<<"$exported" || true)"

needed=$(readelf --dynamic "$shared" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
[[ $needed == *libc.so* ]] || refuse "readelf lists no libc" "$needed."
refuse "needed beyond the C++ runtime and libc" \
    "$(grep -vE '^(libstdc\+\+|libm|libgcc_s|libc|ld-linux.*)\.so(\.[0-9]+)?$' <<<"$needed" || true)"
exit $failed
