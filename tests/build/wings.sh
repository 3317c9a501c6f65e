#!/usr/bin/env bash
# wings.sh COMMAND ROOM...: the command's files for the robot include no header of these rooms of the evaluation's wing,
# except where SYMSCENE_HAS_... asks for them. The build cannot see it, as the command links both wings. Lists the
# includes that do, and fails if there are any.
set -euo pipefail
command=$1
shift
rooms=$(IFS='|'; echo "$*")
find "$command" -maxdepth 1 -name '*.[ch]pp' -print0 | sort -z | xargs -0 awk -v rooms="^#include \"(symscene/)?($rooms)/" '
  FNR == 1 { optional = 0 }
  /^#if.*SYMSCENE_HAS_/ { optional = 1 }
  /^#(else|endif)/ { optional = 0 }
  !optional && $0 ~ rooms { print FILENAME ": " $0; found = 1 }
  END { exit found }'
