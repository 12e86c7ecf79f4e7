#!/usr/bin/env bash
# Finds the objects of one scene. Installs what is missing, builds the programs and writes into build/demo.
#
# Usage: scripts/demo.sh [SCENE.pcd]
# SCENE.pcd is an organized RGB-D cloud; without it a scene is rendered.
set -euo pipefail

# Before the working directory changes.
scene=${1:+$(realpath -- "$1")}

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
help_if_asked "$@"
if (($# > 1)); then
  print_usage >&2
  exit 2
fi
if [[ -n $scene && ! (-f $scene && -r $scene) ]]; then
  echo "demo.sh: cannot read '$scene'" >&2
  exit 1
fi
scripts/install_dependencies.sh
configure release
say "Building the programs"
cmake --build --preset release --target pcl_attention_make_scene pcl_attention_segment

if [[ -z $scene ]]; then
  say "Rendering a scene"
  mkdir -p build/demo
  scene=$PWD/build/demo/scene.pcd
  build/release/bin/pcl_attention_make_scene "$scene" -kind clutter -seed 6
fi
say "Finding its objects"
build/release/bin/pcl_attention_segment "$scene" -output_dir build/demo

stem=$(basename -- "$scene" .pcd)
cat << END

The picture to open:      $PWD/build/demo/$stem/overview.png
Objects and their planes: $PWD/build/demo/$stem/segments.json
The cloud with labels:    $PWD/build/demo/$stem/labels.pcd
END
