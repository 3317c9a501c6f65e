#!/usr/bin/env bash
# The command is built with the protections that docs/security.md lists.
# usage: hardened.sh COMMAND
set -euo pipefail
command=$1
failures=0

expect() { # expect WHAT PATTERN READELF_OPTION
  if ! readelf -W "$3" "$command" | grep -E "$2" >/dev/null; then
    echo "$command: expected $1, readelf $3 shows no $2"
    failures=1
  fi
}

expect "a position-independent executable" "Type: +DYN" -h
expect "read-only relocations" GNU_RELRO -l
expect "symbols bound at the start" "BIND_NOW|Flags: .*NOW" -d
expect "a stack protector" __stack_chk_fail --dyn-syms
expect "checked calls of the C library" "_chk@" --dyn-syms
if readelf -W -l "$command" | grep -E GNU_STACK | grep RWE >/dev/null; then
  echo "$command: expected a stack that is not executable"
  failures=1
fi
exit $failures
