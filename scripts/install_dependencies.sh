#!/usr/bin/env bash
# Installs the Debian packages that are missing.
#
# Usage: scripts/install_dependencies.sh [build] [test] [checks] [packages] [documentation]
#   build   what configuring and building everything needs
#   test    what running the tests needs besides
#   checks  what scripts/check_all.sh needs besides
#   packages       what scripts/check_packages.sh needs besides
#   documentation  what the target documentation needs besides
# Without an argument: build and test.
set -euo pipefail

build=(build-essential cmake ninja-build ccache pkg-config libpcl-dev libboost-program-options-dev liblz4-dev
  libqhull-dev libpng-dev libx11-dev nlohmann-json3-dev libgtest-dev libbenchmark-dev pybind11-dev python3-dev)
test=(xvfb xauth openbox wmctrl xdotool python3-numpy python3-pytest python3-matplotlib)
checks=(clang libclang-rt-dev libomp-dev llvm clang-format clang-tidy gcovr shellcheck valgrind)
packages=(debootstrap dpkg-dev)
documentation=(doxygen)

(($#)) || set -- build test
wanted=()
for group in "$@"; do
  case "$group" in
    build) wanted+=("${build[@]}") ;;
    test) wanted+=("${test[@]}") ;;
    checks) wanted+=("${checks[@]}") ;;
    packages) wanted+=("${packages[@]}") ;;
    documentation) wanted+=("${documentation[@]}") ;;
    *)
      echo "install_dependencies.sh: no group '$group'; there are build, test, checks, packages and documentation" >&2
      exit 2
      ;;
  esac
done

if ! command -v apt-get dpkg-query > /dev/null; then
  echo "install_dependencies.sh: not a Debian system; these packages, by Debian's names, have to be there: ${wanted[*]}" >&2
  exit 0
fi

missing=()
for package in "${wanted[@]}"; do
  # shellcheck disable=SC2016 # ${Status} is dpkg-query's
  if [[ $(dpkg-query --show --showformat='${Status}' "$package" 2> /dev/null) != "install ok installed" ]]; then
    missing+=("$package")
  fi
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo > /dev/null; then
    echo "install_dependencies.sh: run as root, or install sudo, to install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=600 "$@" < /dev/null 2>&1
}

echo "Installing ${missing[*]}"
# The package lists are fetched only where those at hand do not do: they may be absent, or name versions that are gone.
if ! apt install --yes --no-install-recommends "${missing[@]}" > /dev/null; then
  if ! messages=$(apt update && apt install --yes --no-install-recommends "${missing[@]}"); then
    echo "$messages" >&2
    echo "install_dependencies.sh: could not install ${missing[*]}" >&2
    exit 1
  fi
fi
