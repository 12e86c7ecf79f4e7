#!/usr/bin/env bash
# Runs the tests. Installs what is missing and builds everything first.
#
# Usage: scripts/test.sh [CTEST_ARGUMENT...]
# For instance scripts/test.sh -R symmetry --verbose. Tests on real scenes need the folder PCL_ATTENTION_DATA.
set -euo pipefail

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
help_if_asked "$@"
scripts/install_dependencies.sh
configure release
say "Building"
cmake --build --preset release
say "Testing"
exec ctest --preset release --parallel 2 --no-tests=error "$@"
