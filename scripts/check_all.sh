#!/usr/bin/env bash
# The long checks: what .ci/run has no time for. One line a check at the end; fails if one of them failed.
#
# Usage: scripts/check_all.sh [CHECK...]
# CHECK: release static clang library debug asan tsan valgrind builds fuzz soak steadiness coverage mutants packages
# reproducible documentation scripts; without one, all of them in this order.
set -euo pipefail

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

build_and_test() { # PRESET [CMAKE_ARGUMENT...]
  configure "$@" && cmake --build --preset "$1" && ctest --preset "$1" --parallel 2 --no-tests=error
}

# The presets' build folders are used for their own settings only: variations go into folders of their own.
build_and_test_in() { # FOLDER CMAKE_ARGUMENT...
  local folder=build/$1
  shift
  configure release -B "$folder" "$@" && cmake --build "$folder" --parallel 2 &&
    ctest --test-dir "$folder" --parallel 2 --no-tests=error --output-on-failure
}

# As a user's project has it in a subdirectory: nothing but the library, static, without OpenMP and VTK, by the other
# compiler.
build_library_alone() {
  cmake -S test/drop_in/subdirectory -B build/library -G Ninja -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ \
    -D BUILD_SHARED_LIBS=OFF -D PCL_ATTENTION_OPENMP=OFF && cmake --build build/library --parallel 2 &&
    build/library/from_depth_image | grep '^2: ' &&
    cmake -P test/drop_in/expect_no_vtk.cmake build/library/from_depth_image
}

# The same bytes from builds of other optimization, and with sanitizers; summary.json has times in it.
compare_builds() {
  local preset scenes=build/builds/scenes
  rm -rf build/builds
  mkdir -p "$scenes"
  for preset in release debug asan; do
    configure "$preset" &&
      cmake --build --preset "$preset" --target pcl_attention_segment pcl_attention_make_scene || return
  done
  build/release/bin/pcl_attention_make_scene "$scenes/clutter.pcd" -kind clutter -count 4 > /dev/null &&
    build/release/bin/pcl_attention_make_scene "$scenes/stacked.pcd" -kind stacked -count 2 -world > /dev/null || return
  for preset in release debug asan; do
    "build/$preset/bin/pcl_attention_segment" "$scenes" -output_dir "build/builds/$preset" > /dev/null 2>&1 &&
      "build/$preset/bin/pcl_attention_segment" "$scenes" -preset paper -output_dir "build/builds/$preset/paper" \
        > /dev/null 2>&1 || return
  done
  for preset in debug asan; do
    diff --recursive --brief --exclude=summary.json build/builds/release "build/builds/$preset" || return
  done
}

# The viewer's model, with leaks, and its window, where what the graphics driver leaves is not the viewer's.
check_by_valgrind() {
  local valgrind=(valgrind --quiet --error-exitcode=1 --suppressions=test/viewer/valgrind.supp) bin=build/release/bin
  configure release &&
    cmake --build --preset release --target pcl_attention_test_viewer pcl_attention_viewer pcl_attention_make_scene &&
    "${valgrind[@]}" --leak-check=full --errors-for-leak-kinds=definite --show-leak-kinds=definite "$bin/pcl_attention_test_viewer" &&
    mkdir -p build/valgrind &&
    "$bin/pcl_attention_make_scene" build/valgrind/scene.pcd -width 160 -height 120 > /dev/null &&
    xvfb-run --auto-servernum "${valgrind[@]}" "$bin/pcl_attention_viewer" build/valgrind/scene.pcd \
      -screenshot build/valgrind/views.png
}

# Called in a condition, where set -e does not reach: hence the &&.
check() {
  case "$1" in
    release | debug | asan) build_and_test "$1" ;;
    tsan)
      # All that has threads, at build time too, as the programs are asked for their tests. Debian's OpenMP run-time is not
      # instrumented itself; its archer tool tells the sanitizer what it synchronises, once it is told where the tool is.
      export TSAN_OPTIONS="suppressions=$PWD/test/tsan.supp ignore_noninstrumented_modules=1 ${TSAN_OPTIONS:-}"
      OMP_TOOL_LIBRARIES=$(realpath --canonicalize-existing "$(clang -print-resource-dir)/../../libarcher.so") || return
      export OMP_TOOL_LIBRARIES
      configure tsan &&
        cmake --build --preset tsan --target pcl_attention_test_{core,classes,apps,viewer} pcl_attention_soak &&
        ctest --preset tsan --parallel 2 --no-tests=error --tests-regex '^(core|classes|apps|viewer|soak)\.' \
          --exclude-regex TheNewOneCannotBeWritten # it limits the size of files, and this sanitizer's memory is one
      ;;
    static) build_and_test_in static -D BUILD_SHARED_LIBS=OFF ;;
    clang) build_and_test_in clang -D CMAKE_C_COMPILER=clang -D CMAKE_CXX_COMPILER=clang++ ;;
    library) build_library_alone ;;
    valgrind) check_by_valgrind ;;
    builds) compare_builds ;;
    mutants) scripts/check_mutants.py ;;
    fuzz) scripts/fuzz.sh ;;
    soak) configure release && cmake --build --preset release --target pcl_attention_soak && build/release/bin/pcl_attention_soak ;;
    steadiness)
      configure release && cmake --build --preset release --target pcl_attention_steadiness && build/release/bin/pcl_attention_steadiness
      ;;
    packages) scripts/check_packages.sh ;;
    reproducible) scripts/check_reproducible.sh ;;
    documentation) configure release && cmake --build --preset release --target documentation ;;
    coverage)
      # Threads may count below zero, which gcovr does not understand; the lines that ran are known all the same.
      build_and_test coverage &&
        gcovr --root . --gcov-ignore-parse-errors --filter src/ --filter include/ --exclude-throw-branches --print-summary --fail-under-line 95 \
          --html-details build/coverage/report.html build/coverage
      ;;
    scripts) shellcheck --external-sources .ci/run scripts/*.sh test/viewer/*.sh && scripts/check_dependencies.sh ;;
    *)
      echo "check_all.sh: no check '$1'" >&2
      return 2
      ;;
  esac
}

help_if_asked "$@"
scripts/install_dependencies.sh build test checks packages documentation
(($#)) || set -- release static clang library debug asan tsan valgrind builds fuzz soak steadiness coverage mutants \
  packages reproducible documentation scripts

results=()
failed=0
for name in "$@"; do
  started=$SECONDS
  say "Check $name"
  result=passed
  check "$name" || result=failed
  [[ $result == passed ]] || failed=1
  results+=("$(printf '%-13s %s, %d s' "$name" "$result" $((SECONDS - started)))")
done
say "Summary"
printf '%s\n' "${results[@]}"
exit "$failed"
