#!/usr/bin/env bash
# duplicate_symbols.sh LIBRARY_OR_OBJECT...: lists functions and variables that two objects define. A linker does not
# report them while it takes only one of the objects from a static library. Exits with 1 if there are any.
set -euo pipefail
inputs=()
for file; do [[ $file == *.gch ]] || inputs+=("$file"); done # a precompiled header is not an object
nm --defined-only --extern-only --format=posix "${inputs[@]}" |
  awk '$2 ~ /^[TDBR]$/ && seen[$1]++ { print $1; found = 1 } END { exit found }' | c++filt
