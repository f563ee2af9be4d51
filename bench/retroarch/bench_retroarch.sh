#!/usr/bin/env bash
# What a frame costs in RetroArch, without a filter, with some of its own, and with ours: the test core replays the
# pictures of a folder, unthrottled, under a virtual display. Each way is run in turn, several rounds in one go; the
# best median counts. A filter's added time is its own less that without a filter, and ratios are to normal4x's.
set -euo pipefail

usage() {
  cat <<'TEXT'
bench_retroarch.sh [--build FOLDER] [--presets FOLDER] [--frames N] [--rounds N] [--json] FOLDER...

  FOLDER            frames of a game, pictures of one size
  --build FOLDER    of a release build with tests; build/release
  --presets FOLDER  of our presets; retroarch/depixel in the build
  --frames N        timed a run, after 60 that are not; 900
  --rounds N        3
  --json            print an object instead of a table
TEXT
}

fail() {
  echo "bench_retroarch.sh: $1" >&2
  exit 2
}

root=$(cd "$(dirname "$0")/../.." && pwd)
build=$root/build/release presets="" frames=900 rounds=3 json=false folders=()
while [ $# -gt 0 ]; do
  case $1 in
    --build | --presets | --frames | --rounds)
      [ $# -ge 2 ] || fail "$1 takes a value."
      printf -v "${1#--}" '%s' "$2"
      shift
      ;;
    --json) json=true ;;
    --help | -h) usage && exit 0 ;;
    -*) fail "There is no option $1." ;;
    *) folders+=("$1") ;;
  esac
  shift
done
[ ${#folders[@]} -gt 0 ] || fail "Which frames? See --help."
[[ $frames =~ ^[1-9][0-9]*$ && $rounds =~ ^[1-9][0-9]*$ ]] || fail "--frames and --rounds take numbers above 0."
presets=${presets:-$build/retroarch/depixel}
core=$(find "$build/tests" -name depixel_test_libretro.so -print -quit 2>/dev/null || true)
[ -n "$core" ] || fail "There is no test core in $build: build the target retroarch_tests."
own=$(find /usr/lib -path '*/retroarch/filters/video' -type d -print -quit)
[ -n "$own" ] || fail "RetroArch's own filters were not found."

names=(none 2xbr normal4x depixel-2x depixel-4x)
filters=("" "$own/2xBR.filt" "$own/Normal4x.filt" "$presets/Depixel-2x.filt" "$presets/Depixel-4x.filt")
for folder in "${folders[@]}"; do
  [ -d "$folder" ] || fail "$folder is no folder."
done
for filter in "${filters[@]:1}"; do
  [ -f "$filter" ] || fail "There is no $filter."
done

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Runs RetroArch with a filter, or none, and prints the median time of a frame in milliseconds.
run() { # FILTER
  {
    for folder in savefile savestate system; do echo "${folder}_directory = \"$work\""; done
    echo "video_filter = \"$1\""
    cat "$root/tests/retroarch/retroarch.cfg"
  } > "$work/ra.cfg"
  HOME=$work XDG_CONFIG_HOME=$work LIBGL_ALWAYS_SOFTWARE=1 DBUS_FATAL_WARNINGS=0 timeout -k 5 300 \
    xvfb-run -a -s "-screen 0 2600x2000x24" retroarch -v -c "$work/ra.cfg" -L "$core" \
    --max-frames=$((frames + 61)) "$work/play.frames" > "$work/log" 2>&1 || true
  sed -n 's/.*\[depixel-test\] [0-9]* frames, \([0-9.]*\) ms a frame in the median.*/\1/p' "$work/log" | grep . ||
    fail "RetroArch did not finish; its log ends: $(tail -n 3 "$work/log")"
}

# The best medians of a sequence, a line each way: name, ms.
measure() { # FOLDER
  local first size
  first=$(find "$1" -type f -name '*.png' | sort | sed -n 1p)
  [ -n "$first" ] || fail "There are no PNG pictures in $1."
  size=$(identify -format '%wx%h' "$first")
  printf 'geometry %s\nshow %s 200\n' "$size" "$(realpath "$1")" > "$work/play.frames"
  for ((round = 0; round < rounds; ++round)); do
    for i in "${!names[@]}"; do echo "${names[i]} $(run "${filters[i]}")"; done
  done | awk '!($1 in best) || $2 < best[$1] { best[$1] = $2 } END { for (name in best) print name, best[name] }'
}

for folder in "${folders[@]}"; do
  measure "$folder" > "$work/best"
  awk -v order="${names[*]}" -v game="$(basename "$folder")" -v json="$json" '
    { ms[$1] = $2 }
    END {
      count = split(order, names, " ")
      unit = ms["normal4x"] - ms["none"]
      if (json == "false") printf "%-18s %10s %10s %14s\n", game, "ms", "added ms", "to normal4x"
      for (i = 1; i <= count; ++i) {
        added = ms[names[i]] - ms["none"]
        ratio = (unit > 0 ? added / unit : 0)
        if (json == "true") {
          line = line sprintf("%s\"%s\":{\"ms\":%.4f,\"added_ms\":%.4f,\"to_normal4x\":%.3f}",
                              (i > 1 ? "," : ""), names[i], ms[names[i]], added, ratio)
        } else {
          printf "  %-16s %10.3f %10.3f %14.2f\n", names[i], ms[names[i]], added, ratio
        }
      }
      if (json == "true") printf "{\"name\":\"%s\",%s}\n", game, line
    }' "$work/best"
done | if $json; then paste -sd, | sed 's/.*/{"sequences":[&]}/'; else cat; fi
