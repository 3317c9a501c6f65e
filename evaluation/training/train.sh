#!/bin/sh
# Makes the data of the models of objects and of their symmetries, and fits them:
#   evaluation/training/train.sh BUILD DATA WORK MODELS
# BUILD holds the programs (build/bin of a build with SYMSCENE_BUILD_TRAINING=ON), DATA the meshes
# and real views (CONTRIBUTING.md), WORK takes the data sets and samples, MODELS the models (models).
# Whatever is in WORK already is kept, so that an interrupted run goes on where it stopped.
# SCALE=0.1 makes a tenth of the scenes, to try it out.
set -eu
build=$1 data=$2 work=$3 models=$4
scale=${SCALE:-1}
mkdir -p "$work"

# make NAME SEED SCENES JSON [ARGUMENT...]: a data set and its samples, one kind of input.
make() {
  name=$1 make_seed=$2 scenes=$(awk "BEGIN { n = int($3 * $scale); print (n > 1 ? n : 2) }") json=$4
  shift 4
  [ -e "$work/$name.samples" ] && return
  echo "$json" > "$work/$name.json"
  "$build/symscene" dataset "$work/$name" --split training --scenes "$scenes" --seed "$make_seed" \
    --config "$work/$name.json" "$@"
  "$build/symscene_make_object_samples" "$work/$name" -o "$work/$name.samples" \
    --variants as-is posed
}

ycb="--meshes $data/ycb --symmetries $data/ycb_symmetries/searched.json"
sensor() { # the share of one sensor alone: NAME
  case $1 in
    structured) echo '"stereo": 0.0, "tof": 0.0' ;;
    stereo) echo '"stereo": 1.0, "tof": 0.0' ;;
    tof) echo '"stereo": 0.0, "tof": 1.0' ;;
  esac
}
vary() { # VIEWS SENSOR: the options of a kind
  case $1 in
    single) views='"single_views": 1.0, "few_views": 0.0' ;;
    few) views='"single_views": 0.0, "few_views": 1.0' ;;
    tracked) views='"single_views": 0.0, "few_views": 0.0, "max_tracked_frames": 60' ;;
  esac
  echo "{\"arranged_every\": 3, \"variation\": {\"enabled\": true, $views, $(sensor "$2")}}"
}

seed=2000
for sensor in structured stereo tof; do
  seed=$((seed + 10))
  make "single_$sensor" $((seed + 1)) 125 "$(vary single $sensor)" $ycb
  # Structured light is the most frequent sensor, and the one that is simulated best.
  few=25
  [ $sensor != structured ] || few=50
  make "few_$sensor" $((seed + 2)) $few "$(vary few $sensor)" $ycb
  make "tracked_$sensor" $((seed + 3)) 14 "$(vary tracked $sensor)" $ycb
done
make sweeps 2051 14 '{"camera": {"frames": 60}}' $ycb

# Real views: the even scenes are fitted to, the odd ones are held out.
if [ ! -e "$work/osd.samples" ]; then
  mkdir -p "$work/osd" "$work/osd_held_out"
  for n in $(seq 0 44); do
    folder=$([ $((n % 2)) = 0 ] && echo osd || echo osd_held_out)
    for kind in depth label; do
      ln -sf "$(realpath "$data")/osd_learn/learn$n.$kind.png" "$work/$folder/"
    done
  done
  "$build/symscene_make_object_samples" "$work/osd" -o "$work/osd.samples" --variants as-is posed
fi
[ -e "$work/osd_held_out.samples" ] || "$build/symscene_make_object_samples" "$work/osd_held_out" \
  -o "$work/osd_held_out.samples" --variants as-is
"$build/symscene_fit_object_score" "$work"/single_*.samples "$work"/few_*.samples \
  "$work"/tracked_*.samples "$work/sweeps.samples" "$work/osd.samples" \
  --held-out "$work/osd_held_out.samples" --depth 5 --rounds 300 --rate 0.05 --min-leaf 40 \
  --sample-share 0.5 --feature-share 0.4 \
  --report "$work/reliability.md" -o "$models" \
  --data "evaluation/training/train.sh, scale $scale"

# Symmetries of proposed and chosen objects, with the object models that were just fitted: first the
# axis, as the features of planes include it.
sets=""
for name in single_structured single_stereo single_tof few_structured few_stereo few_tof \
  tracked_structured tracked_stereo tracked_tof sweeps; do
  sets="$sets $work/$name"
done
for kind in axes planes; do
  # shellcheck disable=SC2086
  "$build/symscene_fit_symmetry_score" $kind $sets --noise 0 5 --models "$models" -o "$models" \
    --data "evaluation/training/train.sh, scale $scale"
done
