#!/usr/bin/env bash
# Makes a part of about 200,000 triangles by a chain of exact Booleans, and a picture of it:
# an ellipsoid, minus a torus knot, minus drills, intersected with a gear.
# Then a gear box from a model file, its gears turned, and the whole of it moved.
# Usage: run_demo.sh BUILD_DIR OUT_DIR
set -euo pipefail

if [ $# -ne 2 ]; then
  echo "usage: $0 BUILD_DIR OUT_DIR" >&2
  exit 2
fi
build=$(cd "$1" && pwd)
mkdir -p "$2"
out=$(cd "$2" && pwd)

# The program NAME in the build folder or in one of its rooms' folders.
find_program() {
  local folder
  for folder in "$build" "$build/cli" "$build/examples" "$build/bin"; do
    if [ -f "$folder/$1" ] && [ -x "$folder/$1" ]; then
      echo "$folder/$1"
      return 0
    fi
  done
  return 1
}

missing() {
  echo "$0: $1 is not in $build; build with -DQUOIN_BUILD_EXAMPLES=ON" >&2
  exit 1
}

quoin=$(find_program quoin) || missing quoin
generate=$(find_program quoin-generate) || missing quoin-generate
gear_box=$(find_program quoin-gear-box) || missing quoin-gear-box
render=$(find_program quoin-render) || render=

say() { printf '\n== %s\n' "$*"; }
# Shows a command, its files without their folder, and runs it.
show() {
  local shown="quoin"
  local word
  for word in "$@"; do shown+=" ${word#"$out"/}"; done
  echo "   $shown"
  "$quoin" "$@"
}

say "Making the meshes (millimetres)"
"$generate" sphere --size 150000 --scale 42,42,26 -o "$out/body.off"
"$generate" knot --size 200000 --knot 2,9,26,11.5,4 -o "$out/knot.off"
"$generate" gear --size 6000 --scale 42,42,54 -o "$out/gear.off"
"$generate" cylinder --size 1600 --scale 11,11,30 -o "$out/bore.off"
# Nine drills on a circle of radius 28, one every 40 degrees: x and y of each.
drill_places=(28 0  21.449244 17.998053  4.862149 27.574617  -14 24.248711  -26.311393 9.576564
  -26.311393 -9.576564  -14 -24.248711  4.862149 -27.574617  21.449244 -17.998053)
drills=()
set -- "${drill_places[@]}"
while [ $# -gt 0 ]; do
  file="$out/drill$((${#drills[@]} + 1)).off"
  "$generate" cylinder --size 400 --scale 2.5,2.5,30 --offset "$1" "$2" 0 -o "$file"
  drills+=("$file")
  shift 2
done
echo "   body.off knot.off gear.off bore.off drill1.off .. drill${#drills[@]}.off"

say "The chain of Booleans; .quoin files keep every step exact, on a grid of 1/1000 mm"
show convert "$out/body.off" -o "$out/body.quoin" --step 1/1000
show difference "$out/body.quoin" "$out/knot.off" -o "$out/carved.quoin"
show difference "$out/carved.quoin" "$out/bore.off" "${drills[@]}" -o "$out/drilled.quoin"
show intersection "$out/drilled.quoin" "$out/gear.off" -o "$out/housing.quoin"
show convert "$out/housing.quoin" -o "$out/housing.stl"

say "The result"
show info "$out/housing.quoin"

# A law: two files are the same bytes.
same() {
  if ! cmp "$out/$1" "$out/$2"; then
    echo "$0: the law does not hold" >&2
    exit 3
  fi
  echo "   $1 and $2 are the same bytes"
}

say "A law: (A - B) u (A n B) is A, to the byte (A: body, B: knot)"
show intersection "$out/body.quoin" "$out/knot.off" -o "$out/common.quoin"
show union "$out/carved.quoin" "$out/common.quoin" -o "$out/whole_again.quoin"
same whole_again.quoin body.quoin

say "A model: a gear box of 202 primitives, with parameters"
"$gear_box" "$out/gear_box.json"
show eval "$out/gear_box.json" -o "$out/gear_box.quoin"
show eval "$out/gear_box.json" --set turn=10 --set wall=3 -o "$out/turned.quoin"
show move "$out/turned.quoin" --rotate 1,2,3 12.5 -o "$out/gear_box.stl"

say "A law: after a full turn of the gears it is what it was, to the byte"
show eval "$out/gear_box.json" --set turn=360 -o "$out/full_turn.quoin"
same full_turn.quoin gear_box.quoin

if [ -n "$render" ]; then
  say "The pictures"
  "$render" "$out/housing.stl" -o "$out/housing.png" --view 25 38
  "$render" "$out/gear_box.stl" -o "$out/gear_box.png" --view 25 50
else
  say "No pictures: quoin-render was not built (it needs libpng)"
fi

say "Where everything is"
echo "   $out/housing.stl     for the slicer"
echo "   $out/housing.quoin   the exact solid"
echo "   $out/gear_box.json   the model: change a number, and evaluate it again"
if [ -n "$render" ]; then echo "   $out/housing.png, $out/gear_box.png     the pictures"; fi
