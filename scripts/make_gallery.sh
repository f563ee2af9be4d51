#!/usr/bin/env bash
# Makes the pictures of the README again, in docs/images: shipped sprites and a frame at 6x by nearest neighbour, by xbr
# (2x, then 3x) and by depixel; all steps; what options do; and the windows of the player and of RetroArch. Needs ffmpeg, imagemagick,
# RetroArch and Xvfb beside a release build.
set -euo pipefail
cd "$(dirname "$0")/.."

depixel=build/release/bin/depixel
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# One picture three ways, side by side. Transparent pixels, and those of the colour that stands for them, are put on a
# colour first: xbr knows no alpha.
row() { # PICTURE [CROP]
  convert "$1" ${2:+-crop "$2" +repage} -transparent '#ff00ff' -background '#5a7ba8' -alpha remove -alpha off "PNG24:$work/in.png"
  convert "$work/in.png" -filter point -resize 600% "$work/nearest.png"
  ffmpeg -loglevel error -y -i "$work/in.png" -vf 'format=bgr0,xbr=2,xbr=3' -frames:v 1 "$work/xbr.png"
  "$depixel" "$work/in.png" -o "$work/ours.png" --scale 6 --quiet
  convert "$work"/{nearest,xbr,ours}.png -bordercolor white -border 3 +append "$3"
}

i=0
for sprite in minetest_game_default_apple minetest_game_bucket_lava minetest_game_default_tool_mesesword \
  whichwayisup_blob_standing_0 whichwayisup_brown_key_0:34x14+5+26 pixelarticons_bell; do
  crop=${sprite#*:}
  [ "$crop" != "$sprite" ] || crop=
  row "tests/data/sprites/${sprite%%:*}.png" "$crop" "$work/row$((i++)).png"
done
convert \( "$work"/row[0-2].png -background white -append \) \( "$work"/row[3-5].png -background white -append \) \
  +append -colors 256 docs/images/gallery_sprites.png
row tests/data/frames/jumpnbump_0013.png 88x104+205+60 docs/images/gallery_frame.png
convert docs/images/gallery_frame.png -colors 256 docs/images/gallery_frame.png

for stage in bitmap similarity cells simplified contours polygons curves smoothed components; do
  "$depixel" tests/data/sprites/minetest_game_default_apple.png -o "$work/$stage.png" --stage "$stage" --scale 14 --quiet
  convert "$work/$stage.png" -background white -alpha remove -bordercolor white -border 4 "$work/$stage.png"
done
montage "$work"/{bitmap,similarity,cells,simplified,contours,polygons,curves,smoothed,components}.png \
  -tile 5x -geometry +2+2 -background white -colors 256 docs/images/stages.png

# What options do, for docs/gallery.md: parts of frames by nearest neighbour, by the defaults, and by options.
options() { # FRAME CROP SCALE PICTURE OPTIONS...
  convert "tests/data/frames/$1.png" -crop "$2" +repage "$work/part.png"
  convert "$work/part.png" -filter point -resize "$3"00% "$work/option0.png"
  local picture=$4 i=1
  for flags in "" "${@:5}"; do
    # Unquoted: several flags.
    "$depixel" "tests/data/frames/$1.png" -o "$work/whole.png" --scale "$3" --quiet $flags
    convert "$work/whole.png" -crop "$(scaled "$2" "$3")" +repage "$work/option$((i++)).png"
  done
  montage "$work"/option*.png -tile x1 -geometry +3+3 -background white "docs/images/$picture"
  rm "$work"/option*.png
}
scaled() { # WxH+X+Y SCALE
  awk -F '[x+]' -v s="$2" '{ printf "%dx%d+%d+%d", $1 * s, $2 * s, $3 * s, $4 * s }' <<< "$1"
}
merging=("--similarity merge" "--similarity merge --merge-luma 48"
  "--similarity merge --merge-luma 48 --shading gradient" "--soft-contours 20")
options davegnukem_0052 64x64+24+92 4 shading_gnukem.png "${merging[@]}"
options freedoom_0039 72x64+140+86 4 shading_freedoom.png "${merging[@]}"
options alex4_0036 76x56+54+24 5 dither_alex4.png "--dither blend"
for shape in arrow32 diamond24 triangle32; do
  small=tests/data/truth/$shape.lr.png
  convert "$small" -filter point -resize 800% "$work/corners_${shape}_0.png"
  "$depixel" "$small" -o "$work/corners_${shape}_1.png" --scale 8 --quiet --corners round
  "$depixel" "$small" -o "$work/corners_${shape}_2.png" --scale 8 --quiet
done
montage "$work"/corners_*.png -tile 3x -geometry +3+3 -background white -colors 256 docs/images/corners.png
convert docs/images/text.xpm "PNG24:$work/text.png"
convert "$work/text.png" -filter point -resize 800% "$work/text0.png"
"$depixel" "$work/text.png" -o "$work/text1.png" --scale 8 --quiet
"$depixel" "$work/text.png" -o "$work/text2.png" --scale 8 --quiet --text-safe
convert "$work"/text[0-2].png -background white -splice 0x6 -append docs/images/text.png

# The player, with a split view.
mkdir -p "$work/config/depixel"
echo '{"look": {"split": true, "divider": 0.62}}' > "$work/config/depixel/player.json"
XDG_CONFIG_HOME="$work/config" xvfb-run -a -s "-screen 0 1280x800x24" build/release/bin/depixel-player \
  tests/data/frames/jumpnbump_0013.png --size 1180x720 --scale 4 --frames 60 --screenshot "$work/player.png"
convert "$work/player.png" -colors 256 docs/images/player.png

# RetroArch with the filter: the test core shows a frame.
printf 'geometry 400x256\nshow %s 1000\n' "$PWD/tests/data/frames/jumpnbump_0013.png" > "$work/show.frames"
cat - tests/retroarch/retroarch.cfg > "$work/ra.cfg" <<CFG
video_vsync = "true"
video_scale = "3.000000"
video_filter = "$PWD/build/release/retroarch/depixel/Depixel-3x.filt"
video_font_enable = "true"
fps_show = "true"
CFG
cat > "$work/show.sh" <<'SH'
retroarch -c "$1/ra.cfg" -L "$2" --max-frames=100000 "$1/show.frames" &
sleep 8
import -window root "$1/retroarch.png"
kill $!
SH
HOME="$work" XDG_CONFIG_HOME="$work" LIBGL_ALWAYS_SOFTWARE=1 DBUS_FATAL_WARNINGS=0 xvfb-run -a -s "-screen 0 1200x768x24" \
  bash "$work/show.sh" "$work" "$PWD/build/release/tests/retroarch/core/depixel_test_libretro.so"
convert "$work/retroarch.png" -colors 256 docs/images/retroarch.png
