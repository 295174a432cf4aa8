#!/usr/bin/env bash
# headers.sh PREFIX COMPILER: each installed header of the core compiles alone, in C++20, without exceptions or
# run-time types and with hidden visibility; its signatures take no containers but span, array and string_view.
set -euo pipefail
cd -- "$1/include"
failed=0
count=0
for header in lobelia/*.h; do
    "$2" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror \
        -Wno-missing-field-initializers -fno-exceptions -fno-rtti -fvisibility=hidden -I. \
        -include "$header" -x c++ /dev/null || { echo "$header does not compile alone"; failed=1; }
    ((++count))
done
((count >= 15)) || { echo "only $count headers are installed"; failed=1; }
if grep -nE 'std::(vector|string|map|set|deque|list|function|optional|unordered_map)\b|glm::|\bthrow\b|#include <(vector|string|map|iostream)>' lobelia/*.h; then
    echo "these stand in headers of the core"
    failed=1
fi
if grep -nE '^class [A-Za-z]+ ' lobelia/*.h | grep -v LOBELIA_API; then
    echo "these are not in the shared library: they lack LOBELIA_API"
    failed=1
fi
exit $failed
