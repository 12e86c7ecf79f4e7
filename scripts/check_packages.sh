#!/usr/bin/env bash
# Builds the Debian packages and uses them as a user would, in a clean root: install, build against them, run, remove.
#
# Usage: scripts/check_packages.sh
# As root. The packages are left in build/packages/deb, the root, about 3 GB, is removed.
set -euo pipefail

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
help_if_asked "$@"
if ((EUID != 0)); then
  echo "check_packages.sh: debootstrap and chroot need root" >&2
  exit 1
fi
scripts/install_dependencies.sh build packages

configure release -B build/packages -D CMAKE_INSTALL_PREFIX=/usr -D PCL_ATTENTION_BUILD_TESTS=OFF \
  -D PCL_ATTENTION_BUILD_BENCHMARKS=OFF -D PCL_ATTENTION_BUILD_EXAMPLES=OFF
cmake --build build/packages --parallel 2
rm -rf build/packages/deb
say "Packing"
(cd build/packages && cpack -B deb)
packages=(build/packages/deb/*.deb)
library=$(basename build/packages/deb/libpcl-attention[0-9]*.deb) # its name has the version
library=${library%%_*}

root=$(mktemp -d build/packages/root.XXXXXX)
remove_root() {
  if mountpoint --quiet "$root/proc"; then
    umount "$root/proc"
  fi
  rm -rf --one-file-system "$root"
}
trap remove_root EXIT
in_root() {
  env --ignore-environment PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    chroot "$root" "$@" < /dev/null
}
install_in_root() { # PACKAGE...: those that were built here, or Debian's
  local files=() package
  for package in "$@"; do
    if compgen -G "$root/packages/${package}_*.deb" > /dev/null; then
      package=/packages/$(basename "$root/packages/$package"_*.deb)
    fi
    files+=("$package")
  done
  in_root apt-get -qq install --yes --no-install-recommends "${files[@]}" > "$root/apt.log" 2>&1 || {
    cat "$root/apt.log" >&2
    return 1
  }
}
expect() { # WHAT COMMAND...: says what holds, or ends
  local what=$1
  shift
  "$@" > "$root/output.log" 2>&1 || {
    cat "$root/output.log" >&2
    echo "check_packages.sh: fails: $what" >&2
    exit 1
  }
  echo "- $what"
}

say "Making a clean root"
codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
# shellcheck disable=SC2016 # $(SITE) is apt's
mirror=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' "Release: $codename" | head -n 1)
debootstrap --variant=minbase "$codename" "$root" "$mirror" > build/packages/debootstrap.log
mount -t proc proc "$root/proc" # the scripts of some packages look into it
# Packages come from where this system's come from.
rm -rf "$root/etc/apt/sources.list"
cp -r /etc/apt/. "$root/etc/apt/"
in_root apt-get -qq update
mkdir "$root/packages"
cp "${packages[@]}" "$root/packages/"
cp -r examples "$root/examples"
cp -r test/drop_in "$root/drop_in"

say "Library and Python module"
install_in_root "$library" python3-pcl-attention
expect "they come without VTK" bash -c "! chroot '$root' dpkg -l | grep -i vtk"
expect "Python finds objects" in_root python3 -c "import sys; sys.path.insert (0, '/examples/python')
import pcl_attention, table_scene; assert len (pcl_attention.segment (*table_scene.render ()[:2])) >= 3"

say "Programs"
install_in_root pcl-attention-tools
expect "a scene is rendered" in_root pcl_attention_make_scene /scene.pcd -kind clutter -seed 6 -width 320 -height 240
expect "and its objects are found" in_root pcl_attention_segment /scene.pcd -output_dir /results
expect "their labels are there" test -s "$root/results/scene/labels.pcd"

say "Consumers"
install_in_root libpcl-attention-dev g++ cmake make pkg-config
expect "a CMake project is configured" in_root cmake -S /examples/external_cmake -B /cmake
expect "it is built" in_root cmake --build /cmake
expect "it finds objects in a file" in_root bash -c "/cmake/segment_objects /scene.pcd | grep '^1: '"
expect "it finds objects in memory" in_root bash -c "/cmake/from_depth_image | grep '^2: '"
expect "library and consumer are linked without VTK" in_root cmake -P /drop_in/expect_no_vtk.cmake \
  "/usr/lib/$(dpkg-architecture -qDEB_HOST_MULTIARCH)/libpcl_attention.so" /cmake/from_depth_image
expect "a Makefile builds with pkg-config" in_root make -C /tmp -f /examples/external_pkg_config/Makefile
expect "its program finds objects" in_root bash -c "/tmp/segment_objects /scene.pcd | grep '^1: '"
expect "a consumer with -mavx2 is told why not" in_root bash -c "cmake -S /examples/external_cmake -B /avx \
  -D CMAKE_CXX_FLAGS=-mavx2 && ! cmake --build /avx > /avx.log 2>&1 && grep 'another Eigen alignment' /avx.log"
expect "a consumer of C++ alone is told what is missing" in_root bash -c "! cmake -S /drop_in/cxx_alone -B /cxx 2> /cxx.log &&
  grep 'This project enables C++ alone' /cxx.log"

say "Removal"
expect "the packages are removed" in_root apt-get purge --yes "$library" libpcl-attention-dev pcl-attention-tools \
  python3-pcl-attention
expect "nothing of them is left" bash -c "! find '$root/usr' '$root/etc' '$root/var/lib' -iname '*pcl?attention*' | grep ."
