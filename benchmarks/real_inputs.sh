#!/usr/bin/env bash
# One page with what SymScene finds in every real input, to look at:
#   benchmarks/real_inputs.sh BUILD DATA OUT
# BUILD holds the command (build/bin), DATA the real inputs (CONTRIBUTING.md), OUT takes the results and index.html, which
# is self-contained. Results that are there already are kept.
set -euo pipefail
[[ $# == 3 ]] || { echo "usage: $0 BUILD DATA OUT" >&2; exit 2; }
readonly symscene="$1/symscene" data=$2 out=$3
mkdir -p "$out"

image() { printf '<img alt="%s" src="data:image/png;base64,%s">\n' "$1" "$(base64 -w 0 "$1")"; }

# section TITLE RESULT LOG IMAGE...: what was said and seen of one input.
section() {
  printf '<section><h2>%s</h2><pre>' "$1"
  sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' "$2"
  echo '</pre>'
  local file
  for file in "${@:3}"; do [[ ! -e $file ]] || image "$file"; done
  echo '</section>'
}

# view NAME DEPTH [OPTION...]: a single depth image, or a folder with one.
view() {
  local folder="$out/$1"
  if [[ ! -e $folder.log ]]; then
    "$symscene" segment "$2" -o "$folder" --masks "$folder.masks" "${@:3}" >"$folder.part" 2>&1 || true
    mv "$folder.part" "$folder.log"
  fi
  section "$1" "$folder.log" "$folder".masks/overlays/*.png
}

# sequence NAME FRAMES [OPTION...]: tracked, reconstructed and segmented; overlays of its first, middle and last frame.
sequence() {
  local folder="$out/$1" overlays
  if [[ ! -e $folder.log ]]; then
    {
      "$symscene" reconstruct "$2" -o "$folder.scene" "${@:3}" &&
        "$symscene" segment "$folder.scene" -o "$folder" &&
        "$symscene" masks "$folder" "$2" -o "$folder.masks" "${@:3}"
    } >"$folder.part" 2>&1 || true
    mv "$folder.part" "$folder.log"
  fi
  overlays=("$folder".masks/overlays/*.png)
  section "$1" "$folder.log" "${overlays[0]}" "${overlays[$((${#overlays[@]} / 2))]}" "${overlays[-1]}"
}

page() {
  cat <<'HTML'
<!doctype html><meta charset="utf-8"><title>Real inputs</title>
<style>body { font: 14px sans-serif; margin: 1em; } img { max-width: 31%; } pre { white-space: pre-wrap; }
section { border-top: 1px solid #aaa; }</style><h1>What is found in real inputs</h1>
HTML
  local folder depth
  for folder in "$data"/ucn_views/view_*; do view "ucn_${folder##*/}" "$folder"; done
  for depth in $(ls -v "$data"/osd_learn/*.depth.png); do
    view "osd_$(basename "$depth" .depth.png)" "$depth" --intrinsics 525,525,319.5,239.5
  done
  sequence real_bin "$data/real_bin"
  sequence icl_living_room "$data/icl_living_room"
  sequence tum_fr1_xyz "$data/tum_fr1_xyz" --intrinsics 517.3,516.5,318.6,255.3
}

page >"$out/index.part"
mv "$out/index.part" "$out/index.html"
echo "$out/index.html"
