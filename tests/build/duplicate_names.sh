#!/usr/bin/env bash
# duplicate_names.sh FOLDER...: two definitions of one name break the one-definition rule, and no linker says so where
# their functions are inline. Lists classes, structs and enumerations that two files define at namespace scope, outside
# unnamed namespaces, within one named namespace. Exits with 1 if there are any.
set -euo pipefail
find "$@" -name '*.[ch]pp' -print0 | sort -z | xargs -0 awk '
  FNR == 1 { unnamed = 0; scope = "" }
  /^namespace \{/ { unnamed = 1 }
  /^\}  \/\/ namespace$/ { unnamed = 0 }
  /^namespace [a-z_:]+ \{/ { scope = $2 }
  !unnamed && /^(template <.*> )?(class|struct|enum class|enum) [A-Z][A-Za-z0-9]*( final)?( :.*)? ?\{/ {
    for (i = 1; i <= NF; ++i) if ($i ~ /^[A-Z][A-Za-z0-9]*$/) { name = $i; break }
    key = scope "::" name
    if (key in file && file[key] != FILENAME) { print key ": " file[key] ", " FILENAME; found = 1 }
    file[key] = FILENAME
  }
  END { exit found }'
