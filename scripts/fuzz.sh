#!/usr/bin/env bash
# Fuzzes by libFuzzer with the address and undefined-behaviour sanitizers, one target after the other.
#
# Usage: scripts/fuzz.sh [TARGET...]
# TARGET: a folder of fuzz/corpus; without one, all. FUZZ_RUNS overrides the number of inputs: 200000 for those that segment
# clouds, 1000000 for those that parse. What is found goes on from build/fuzz/corpus; an input that crashes, takes longer than ten
# seconds or more than 4 GB is put into build/fuzz/found.
set -euo pipefail

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
help_if_asked "$@"
scripts/install_dependencies.sh build checks
configure fuzz
say "Building the fuzz targets"
cmake --build --preset fuzz

# What the sanitizer remembers of every allocation takes most of the time of a parser. Leaks are the soak's subject.
export ASAN_OPTIONS=malloc_context_size=0:quarantine_size_mb=4:thread_local_quarantine_size_kb=64

runs_of() { # TARGET
  case "$1" in
    cloud | parameter_values) echo "${FUZZ_RUNS:-200000}" ;;
    *) echo "${FUZZ_RUNS:-1000000}" ;;
  esac
}

(($#)) || set -- fuzz/corpus/*
mkdir -p build/fuzz/found build/fuzz/logs
failed=0
for target in "$@"; do
  target=${target##*/}
  say "Fuzzing $target"
  mkdir -p "build/fuzz/corpus/$target"
  if ! build/fuzz/bin/pcl_attention_fuzz_"$target" -runs="$(runs_of "$target")" -max_len=2048 -timeout=10 -rss_limit_mb=4096 \
    -detect_leaks=0 -print_final_stats=1 -close_fd_mask=3 -artifact_prefix="build/fuzz/found/$target-" "build/fuzz/corpus/$target" "fuzz/corpus/$target" \
    > "build/fuzz/logs/$target" 2>&1; then
    tail -n 40 "build/fuzz/logs/$target"
    failed=1
  fi
  grep -E '^Done |number_of_executed_units' "build/fuzz/logs/$target" || true
done
exit "$failed"
