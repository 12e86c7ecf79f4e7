#!/usr/bin/env bash
# Holds doc/dependencies.md against the packages that scripts/install_dependencies.sh installs and the versions that CMake
# asks for.
#
# Usage: scripts/check_dependencies.sh
set -euo pipefail

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
help_if_asked "$@"

page=doc/dependencies.md
failed=0
complain() {
  echo "check_dependencies.sh: $*" >&2
  failed=1
}

# The lists build=(...), test=(...), ... up to the empty line after them.
mapfile -t packages < <(sed -n '/^build=(/,/^$/p' scripts/install_dependencies.sh | sed 's/^[a-z]*=//' | tr -d '()' |
  tr -s ' ' '\n' | sed '/^$/d')
((${#packages[@]} > 20)) || complain "the lists of install_dependencies.sh were not found"
for package in "${packages[@]}"; do
  grep --quiet --fixed-strings "\`$package\`" "$page" || complain "$page does not name $package"
done

# The second column of a row that begins with a name.
minimum_of() {
  sed -n "s/^| $1[^|]* | *\([0-9.]*\) *|.*/\1/p" "$page" | sort -u
}
while read -r name version; do
  found=$(minimum_of "${name//_/-}")
  [[ $found == "$version" ]] || complain "CMake asks for $name $version, $page says '$found'"
done < <({
  grep --recursive --no-filename --include=CMakeLists.txt --only-matching --extended-regexp \
    'find_package\([A-Za-z_0-9]+ [0-9.]+' CMakeLists.txt src apps evaluation python | sed 's/find_package(//'
  sed -n 's/cmake_minimum_required(VERSION \([0-9.]*\))/CMake \1/p' CMakeLists.txt
} | sort -u)
exit "$failed"
