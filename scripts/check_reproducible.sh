#!/usr/bin/env bash
# Builds the last commit twice, in different folders, and compares library, programs, Python module and packages byte by byte.
#
# Usage: scripts/check_reproducible.sh
set -euo pipefail

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
help_if_asked "$@"
scripts/install_dependencies.sh build packages

# The packages carry this date; a compiler cache would compare the first build with itself.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct)
export SOURCE_DATE_EPOCH CCACHE_DISABLE=1

mkdir -p build/reproducible
for folder in first a/longer/way/to/the/second; do
  source=build/reproducible/$folder
  rm -rf "$source"
  mkdir -p "$source"
  git archive HEAD | tar -x -C "$source"
  say "Building in $source"
  # The packages are what a distribution builds, the build folder what a developer has.
  (
    cd "$source"
    cmake --preset release -D CMAKE_INSTALL_PREFIX=/usr -D PCL_ATTENTION_BUILD_TESTS=OFF \
      -D PCL_ATTENTION_BUILD_BENCHMARKS=OFF -D PCL_ATTENTION_BUILD_EXAMPLES=OFF > configure.log 2>&1 || {
      cat configure.log >&2
      exit 1
    }
    cmake --build --preset release
    cd build/release
    cpack -B deb > cpack.log
    sha256sum lib/*.so.* bin/* python/pcl_attention/*.so deb/*.deb
  ) | tee "build/reproducible/$(basename "$folder").log"
  grep -E '^[0-9a-f]{64}  ' "build/reproducible/$(basename "$folder").log" > "build/reproducible/$(basename "$folder").sums"
done
say "Comparing"
diff build/reproducible/first.sums build/reproducible/second.sums
echo "$(wc -l < build/reproducible/first.sums) files are the same"
