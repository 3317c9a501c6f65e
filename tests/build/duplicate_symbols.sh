#!/usr/bin/env bash
# duplicate_symbols.sh LIBRARY...: lists functions and variables that two objects of static libraries define. A linker
# passes over them in silence as long as it needs only one of the objects. Exits with 1 if there are any.
set -euo pipefail
nm --defined-only --extern-only --format=posix "$@" |
  awk '$2 ~ /^[TDBR]$/ && seen[$1]++ { print $1; found = 1 } END { exit found }' | c++filt
