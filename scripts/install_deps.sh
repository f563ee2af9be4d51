#!/usr/bin/env bash
# Installs the Debian 12 packages that building and testing need and that are missing; as root, or through sudo.
set -euo pipefail

packages=(
  g++ cmake make pkg-config git dpkg-dev                       # building
  libglm-dev libexpected-dev libfmt-dev libcli11-dev           # everywhere; the command line
  libstb-dev libturbojpeg0-dev libgif-dev zlib1g-dev           # reading and writing pictures
  python3-glad libgl-dev libegl-dev libosmesa6-dev             # drawing by OpenGL
  libegl1 libosmesa6 libgl1-mesa-dri libglx-mesa0              # ... also without a graphics card
  libglfw3-dev libimgui-dev                                    # the player
  xvfb xauth xdotool imagemagick                               # its tests
  retroarch retroarch-dev libretro-core-info                   # the plug-in's, in the real thing
  libretro-nestopia efp libretro-gambatte libretro-mgba libretro-bsnes-mercury-balanced
  libgtest-dev librapidcheck-dev libpugixml-dev                # tests
  librsvg2-bin chromium                                        # ... which open SVGs
  libbenchmark-dev nlohmann-json3-dev                          # benchmarks
  libavfilter-dev libavutil-dev xbrzscale                      # what they compare with
  clang-format clang-tidy                                      # checks
)

missing=()
for package in "${packages[@]}"; do
  status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
  [ "$status" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
[ "$(id -u)" = 0 ] || as_root=(sudo)
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update --quiet=2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install --yes --quiet=2 --no-install-recommends "${missing[@]}" </dev/null >/dev/null
