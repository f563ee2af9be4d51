#!/usr/bin/env bash
# Builds depixel, depixel-player and the plug-in for RetroArch, and draws the shipped frames and sprites, as PNG and as
# SVG, into out/demo.
set -euo pipefail
cd "$(dirname "$0")/.."

scripts/install_deps.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target depixel depixel-player depixel_softfilter

depixel=build/release/bin/depixel
for kind in frames sprites; do
  "$depixel" "tests/data/$kind" -o "out/demo/$kind/png" --scale 6 --verify
  "$depixel" "tests/data/$kind" -o "out/demo/$kind/svg" --format svg
done
"$depixel" tests/data/sprites/minetest_game_bucket_lava.png -o out/demo/cells.png --stage simplified --scale 32

echo
echo "The pictures are in $PWD/out/demo:"
find out/demo -type f | sort | sed 's/^/  /'

echo
echo "To look at them in a window: $PWD/build/release/bin/depixel-player tests/data/frames"
echo "To play with the filter, choose one of its presets in RetroArch, under Settings, Video, Video Filter:"
echo "  $PWD/build/release/retroarch/depixel"
