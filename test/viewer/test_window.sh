#!/usr/bin/env bash
# Drives pcl_attention_viewer as a person would, with keys and the mouse, and looks at its pictures. Run under xvfb-run.
#
# Usage: test_window.sh FOLDER_OF_PROGRAMS CASE
# CASE: objects, slider, fixation, window, closing, sequence or screenshot. Exit code 77: skipped, a tool is missing.
# KEEP_PICTURES names a folder for the pictures, to look at them.
set -euo pipefail

programs=$1
readonly viewer=$programs/pcl_attention_viewer segment=$programs/pcl_attention_segment
readonly width=800 height=600 # of the window; below are places in it, as the layout makes them
readonly colour_view=(0 0 264 281) saliency_view=(266 0 264 281) patches_view=(0 283 264 281) objects_view=(266 283 264 281)
readonly theta_knob=(609 404) theta_low=(549 404)
readonly first_color=(77 175 74) second_color=(228 26 28)

for tool in xdotool wmctrl openbox; do
  if ! command -v "$tool" > /dev/null; then
    echo "SKIPPED: $tool is not installed (scripts/install_dependencies.sh)"
    exit 77
  fi
done

folder=$(mktemp -d)
viewer_id=
window=
openbox --sm-disable > /dev/null 2>&1 &
manager_id=$!
clean_up() {
  [[ -z $viewer_id ]] || kill "$viewer_id" 2> /dev/null || true
  kill "$manager_id" 2> /dev/null || true
  [[ -z ${KEEP_PICTURES:-} ]] || cp "$folder"/out/view_*.png "$KEEP_PICTURES" 2> /dev/null || true
  rm -rf "$folder"
}
trap clean_up EXIT
cd "$folder"

fail() {
  echo "FAILED: $*" >&2
  [[ ! -s viewer.log ]] || cat viewer.log >&2
  exit 1
}

# wait_for WHAT COMMAND...: until the command succeeds.
wait_for() {
  local what=$1 end=$((SECONDS + 60))
  shift
  until "$@"; do
    ((SECONDS < end)) || fail "waited in vain for $what"
    sleep 0.1
  done
}

make_scene() { # FILE [FLAG...]
  "$programs/pcl_attention_make_scene" "$@" -kind separate > /dev/null
}

find_window() {
  kill -0 "$viewer_id" 2> /dev/null || fail "the viewer has ended"
  window=$(xdotool search --onlyvisible --name '^pcl_attention_viewer$' 2> /dev/null | tail -n 1)
  [[ -n $window ]]
}

start_viewer() { # ARGUMENT...
  "$viewer" -size "${width}x$height" -output_dir out "$@" > viewer.log 2>&1 &
  viewer_id=$!
  wait_for "the window" find_window
}

# listens: whether the window has the focus and takes keys; what F6 saves shows it.
listens() {
  xdotool windowfocus "$window" key F6
  sleep 0.3
  [[ -s out/parameters.json ]]
}

open_viewer() { # ARGUMENT...
  start_viewer "$@"
  wait_for "the keyboard" listens
}

shots=0
# shoot: the viewer's own picture of its window, after all events before; its path is in $shot.
shoot() {
  shots=$((shots + 1))
  shot=$(printf 'out/view_%04d.png' $shots)
  xdotool key F12
  wait_for "$shot" test -s "$shot"
}

# count LEFT TOP WIDTH HEIGHT RED GREEN BLUE [TOLERANCE]: pixels of a colour in $shot.
count() {
  "$programs/pcl_attention_count_pixels" "$shot" "$1" "$2" "$3" "$4" "$5" "$6" "$7" "${8:-12}"
}

shows() { # LEAST LEFT TOP WIDTH HEIGHT RED GREEN BLUE: whether a new picture has the colour there
  shoot
  (($(count "${@:2}") >= $1))
}

shows_less() { # MOST LEFT TOP WIDTH HEIGHT RED GREEN BLUE [TOLERANCE]: whether a new picture has less of the colour there
  shoot
  (($(count "${@:2}") < $1))
}

press_at() { # X Y [BUTTON]
  xdotool mousemove --window "$window" "$1" "$2" click "${3:-1}"
}

# drag X Y X Y: from the one place to the other, as slowly as a hand. Of several moves that wait VTK takes the newest
# one before all else, even before the press between them.
drag() {
  xdotool mousemove --window "$window" "$1" "$2" mousedown 1
  shoot
  xdotool mousemove --window "$window" "$3" "$4"
  shoot
  xdotool mouseup 1
}

# save: what pcl_attention_segment would write, into out/scene.
save() {
  rm -rf out/scene
  xdotool key F9
  wait_for "the results" test -s out/scene/summary.json
}

saves_same_as() { # FOLDER
  save
  cmp -s out/scene/segments.json "$1/scene/segments.json"
}

# place RANK LEFT TOP: where the fixation of a rank is in a view, x and y of the window.
place() {
  awk -F, -v rank="$1" -v left="$2" -v top="$3" '$1 == rank {
    scale = 264 / 320
    printf "%d %d\n", left + scale * ($2 + 0.5), top + (281 - scale * 240) / 2 + scale * ($3 + 0.5)
  }' expected/scene/attention_points.csv
}

close_viewer() {
  wait_for "the window manager to know the window" wmctrl -c pcl_attention_viewer
  local code=0
  wait "$viewer_id" || code=$?
  viewer_id=
  ((code == 0)) || fail "exit code $code"
  ! grep -iE 'error|warn|assert' viewer.log || fail "the viewer complained"
}

make_scene scene.pcd -seed 1 -width 320 -height 240

case $2 in
  objects)
    "$segment" scene.pcd -output_dir expected > /dev/null
    open_viewer scene.pcd
    wait_for "the outline of the first object" shows 30 "${objects_view[@]}" "${first_color[@]}"
    (($(count "${colour_view[@]}" "${first_color[@]}" 4) == 0)) || fail "an outline over the colours"
    (($(count "${saliency_view[@]}" 255 165 30 40) > 5)) || fail "no saliency"
    (($(count "${colour_view[@]}" 255 165 30 40) == 0)) || fail "saliency over the colours"
    # The number, on its colour, is beside the fixation.
    read -r x y < <(place 1 "${objects_view[@]:0:2}")
    (($(count $((x - 20)) $((y - 20)) 40 40 "${first_color[@]}" 25) > 40)) || fail "no number beside the first fixation"

    xdotool key Right
    wait_for "the other outline to go" shows_less 150 "${objects_view[@]}" "${second_color[@]}" 8
    (($(count "${objects_view[@]}" "${first_color[@]}" 30) > 60)) || fail "the selected object is not outlined"
    xdotool key Down
    wait_for "the object in its growth" shows 50 "${patches_view[@]}" 70 170 230
    steps_before=$(count "${patches_view[@]}" 70 170 230 40)
    xdotool key Down Down Down
    shoot
    (($(count "${patches_view[@]}" 240 60 60) + $(count "${patches_view[@]}" 80 220 100) > 0)) || fail "no step"
    ((steps_before > 0)) || fail "no growth"
    xdotool key h
    wait_for "the help" shows 40 200 100 400 400 255 205 90 30
    xdotool key h Escape y F11 exclam # the last three have no meaning
    wait_for "all outlines again" shows 30 "${objects_view[@]}" "${second_color[@]}"
    close_viewer
    ;;
  slider)
    make_scene scene.pcd -seed 1 -width 320 -height 240 -noise 0 # noise would widen what the slider narrows
    "$segment" scene.pcd -output_dir expected > /dev/null
    "$segment" scene.pcd -output_dir tight -compactness_threshold 0 > /dev/null
    ! cmp -s expected/scene/segments.json tight/scene/segments.json || fail "the slider would change nothing"
    open_viewer scene.pcd
    wait_for "the objects" shows 30 "${objects_view[@]}" "${first_color[@]}"
    wait_for "the results of the program" saves_same_as expected
    drag "${theta_knob[@]}" "${theta_low[@]}"
    wait_for "the results of the slider's value" saves_same_as tight
    rm out/parameters.json
    xdotool key F6
    wait_for "the parameters" test -s out/parameters.json
    grep -q '"compactness_threshold": 0.0,' out/parameters.json || fail "other parameters were saved"
    xdotool key BackSpace
    wait_for "the results of the parameters before" saves_same_as expected
    xdotool key F7
    wait_for "the results of the loaded parameters" saves_same_as tight
    close_viewer
    ;;
  fixation)
    "$segment" scene.pcd -output_dir expected > /dev/null
    open_viewer scene.pcd
    wait_for "the objects" shows 30 "${objects_view[@]}" "${first_color[@]}"
    read -r x y < <(place 2 "${colour_view[@]:0:2}")
    xdotool keydown shift
    press_at "$x" "$y"
    xdotool keyup shift
    has_own() { save && grep -q '"kind": "user"' out/scene/segments.json; }
    wait_for "an object of the user's own" has_own
    rank=$(grep -c '"rank":' out/scene/segments.json)
    cmp -s "$(printf 'out/scene/mask_%04d.png' "$rank")" out/scene/mask_0002.png || fail "it is not the object there"
    shoot
    (($(count "${objects_view[@]}" "${first_color[@]}" 8) < 150)) || fail "another object is still outlined"
    xdotool key F8
    wait_for "the object" test -s "$(printf 'out/scene_object_%04d.pcd' "$rank")"
    xdotool key z
    wait_for "the objects as before" saves_same_as expected
    # A click selects, dragging turns the view, and the camera comes back.
    read -r x y < <(place 1 "${objects_view[@]:0:2}")
    press_at $((x - 4)) "$y"
    wait_for "the object that was clicked" shows_less 150 "${objects_view[@]}" "${second_color[@]}" 8
    readonly below=(0 205 264 60 19 20 24 3) # the picture does not reach there, but what is turned does
    before=$(count "${below[@]}")
    drag 100 100 160 140
    shoot
    turned=$(count "${below[@]}")
    ((turned < before - 1000)) || fail "dragging did not turn the view"
    xdotool key Home
    shoot
    (($(count "${below[@]}") > before - 200)) || fail "the camera did not come back"
    close_viewer
    ;;
  window)
    open_viewer scene.pcd
    wait_for "the objects" shows 30 "${objects_view[@]}" "${first_color[@]}"
    xdotool key F5
    wait_for "the large view" shows 100 0 0 540 560 "${first_color[@]}"
    (($(count 0 0 540 560 "${first_color[@]}" 25) > 100)) || fail "no large object"
    xdotool key Tab
    xdotool windowsize --sync "$window" 1000 740
    has_size() {
      shoot
      [[ $(od -An -j16 -N8 -tu1 "$shot" | tr -s ' ') == " 0 0 3 232 0 0 2 228" ]]
    }
    wait_for "the other size" has_size
    # The size of the picture may be there before the layout of the views.
    wait_for "the objects where the layout has them" shows 30 333 350 330 330 "${first_color[@]}"
    xdotool key q
    code=0
    wait "$viewer_id" || code=$?
    viewer_id=
    ((code == 0)) || fail "exit code $code"
    ;;
  closing)
    mkdir large
    make_scene large/a.pcd -seed 2 -width 1280 -height 960
    make_scene large/b.pcd -seed 3 -width 1280 -height 960
    open_viewer large -play -frame_rate 100 # there is always something to be computed
    close_viewer
    ;;
  sequence)
    mkdir frames
    make_scene frames/a.pcd -seed 3 -width 320 -height 240
    make_scene frames/b.pcd -seed 4 -width 320 -height 240
    open_viewer frames -play -frame_rate 40
    wait_for "frames" shows 30 "${objects_view[@]}" "${first_color[@]}" 25
    xdotool key space Next
    wait_for "the scene after it" shows 30 "${objects_view[@]}" "${first_color[@]}" 25
    save_b() { xdotool key F9 && sleep 1 && test -s out/b/summary.json; }
    wait_for "its results" save_b
    xdotool key F10
    wait_for "some pictures of a turn" test -s out/turn_0001/view_0003.png
    xdotool key Escape
    close_viewer
    ;;
  screenshot)
    "$viewer" scene.pcd -size 640x480 -screenshot all.png
    for view in saliency points patches segments; do
      "$viewer" scene.pcd -size 640x480 -screenshot $view.png -view $view
      ! cmp -s all.png $view.png || fail "the view $view is all of them"
    done
    shot=segments.png
    (($(count 0 0 430 440 "${first_color[@]}" 25) > 100)) || fail "no objects"
    shot=saliency.png
    (($(count 0 0 430 440 255 165 30 40) > 20)) || fail "no saliency"
    expect_error() { # EXIT_CODE TEXT COMMAND...
      local code=0 text=$2 expected=$1
      shift 2
      "$@" > log 2>&1 || code=$?
      ((code == expected)) || fail "$* ended with $code instead of $expected: $(< log)"
      grep -q -e "$text" log || fail "$* says '$(< log)' instead of '$text'"
    }
    expect_error 1 'missing.pcd: no such file' "$viewer" missing.pcd -screenshot x.png
    expect_error 1 'none/x.png: cannot be written' "$viewer" scene.pcd -screenshot none/x.png
    expect_error 1 'no display (DISPLAY is not set)' env -u DISPLAY "$viewer" scene.pcd
    expect_error 1 'cannot be opened' env DISPLAY=:987 "$viewer" scene.pcd
    expect_error 2 "-view is 'top'" "$viewer" -view top
    expect_error 2 '-size takes WIDTHxHEIGHT' "$viewer" -size 10x10
    [[ ! -e x.png ]] || fail "a picture of nothing"
    ;;
  *)
    fail "no case '$2'"
    ;;
esac
echo "passed"
