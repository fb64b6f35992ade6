#!/usr/bin/env bash
# Checks every proof in docs/proofs with gappa, with the numbers of exact/filter_bounds.h in the places of @NAME@.
# Exit code 77: gappa is missing.
#   run.sh                all proofs
#   run.sh --self-check   numbers below the proved ones, weakened bounds and unused numbers must fail
# Laws:
#   A number is a line "inline constexpr TYPE NAME = NUMBER;  // docs/proofs/FILE.g".
#   FILE.g exists and mentions @NAME@; every @NAME@ of a proof is a number of the header.
set -euo pipefail
root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
if ! command -v gappa > /dev/null; then echo "gappa is missing: proofs not checked"; exit 77; fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# read_numbers HEADER PROOFS: fills number[NAME]; false when a line is no definition, or its proof does not use it.
read_numbers() {
  local line form='^inline constexpr [a-z0-9_:]+ ([a-z_]+) = ([0-9a-fxp.-]+); +// docs/proofs/([a-z_]+[.]g)$'
  number=()
  while IFS= read -r line; do
    [[ $line == *constexpr* && $line != //* ]] || continue
    if ! [[ $line =~ $form ]]; then echo "not a number with its proof: $line"; return 1; fi
    number[${BASH_REMATCH[1]}]=${BASH_REMATCH[2]}
    if ! grep -qs "^[^#]*@${BASH_REMATCH[1]}@" "$2/${BASH_REMATCH[3]}"; then
      echo "${BASH_REMATCH[3]} does not use ${BASH_REMATCH[1]}"
      return 1
    fi
  done < "$1"
  [ "${#number[@]}" -gt 0 ]
}

# proved FILE: with the numbers in their places gappa accepts it; what it says is in $said. A search without end is no
# proof.
proved() {
  local text name
  text=$(< "$1")
  for name in "${!number[@]}"; do text=${text//@$name@/${number[$name]}}; done
  if [[ $text =~ @[a-z_]+@ ]]; then echo "${1##*/}: no number ${BASH_REMATCH[0]}"; return 1; fi
  printf '%s\n' "$text" > "$scratch/question.g"
  timeout 60 gappa -Wno-unbound-variable "$scratch/question.g" > "$said" 2>&1
}

# expect_refused WHAT FILE: gappa understands the proof FILE and does not find that it holds.
expect_refused() {
  if ! proved "$2" && grep -q 'some properties were not satisfied' "$said"; then
    echo "refused: ${2##*/} with $1"
  else
    echo "NOT refused: ${2##*/} with $1"
    failures=$((failures + 1))
  fi
}

# number_refused NAME NUMBER FILE: the proof fails when the header's number is another.
number_refused() {
  local right=${number[$1]}
  number[$1]=$2
  expect_refused "$1 = $2" "$proofs/$3"
  number[$1]=$right
}

# text_refused FILE OLD NEW: the proof fails when the text OLD is replaced by NEW.
text_refused() {
  local text
  text=$(< "$proofs/$1")
  if [[ $text != *"$2"* ]]; then echo "$1: no such text: $2"; failures=$((failures + 1)); return; fi
  printf '%s\n' "${text//"$2"/"$3"}" > "$scratch/$1"
  expect_refused "$3" "$scratch/$1"
}

# line_refused LINE: a header with this line is refused.
line_refused() {
  { cat "$header"; printf '%s\n' "$1"; } > "$scratch/filter_bounds.h"
  if (read_numbers "$scratch/filter_bounds.h" "$proofs") > /dev/null; then
    echo "accepted: $1"
    failures=$((failures + 1))
  else
    echo "refused: $1"
  fi
}

self_check() {
  text_refused rounding.g '[-0x3.001p-53, 0x3.001p-53]' '[-0x2.fp-53, 0x2.fp-53]'
  text_refused pair.g '<= 0x4.2p-53' '<= 4b-53'
  text_refused turn_term.g '<= 0x6.3p-53' '<= 6b-53'

  number_refused unit_roundoff 0x1p-54 rounding.g
  number_refused side_bound 5 side_filter.g
  number_refused side_bound 4 side_filter.g
  number_refused turn_bound 8 turn_filter.g
  number_refused turn_bound 2 turn_filter.g
  number_refused orientation_bound 12 orientation_filter.g
  number_refused orientation_bound 4 orientation_filter.g
  number_refused orientation_tail 2 orientation_filter.g
  number_refused quotient_below 1 quotient.g
  number_refused quotient_above 2 quotient.g
  number_refused snap_bound 3 snap_filter.g
  number_refused snap_origin 1 snap_filter.g
  number_refused snap_floor 0x1p-90 snap_filter.g
  number_refused crossing_slack 0x1p11 crossing.g
  number_refused area_bound 1 area_filter.g
  number_refused area_roundings 1 area_filter.g
  number_refused effect_bound 8 effect_filter.g
  number_refused effect_floor 0x1p-400 effect_filter.g
  number_refused map_bound 6 map_filter.g
  number_refused map_floor 0x1p-1074 map_filter.g

  line_refused 'inline constexpr double side_margin = 8;'
  line_refused 'inline constexpr double side_margin = 8;  // docs/proofs/side_filter.g'
  line_refused 'inline constexpr double side_bound = 8;  // docs/proofs/no_such_proof.g'
  unset 'number[side_bound]'
  if proved "$proofs/side_filter.g"; then failures=$((failures + 1)); fi
}

header=$root/exact/filter_bounds.h proofs=$root/docs/proofs said=$scratch/said
declare -A number
read_numbers "$header" "$proofs"
failures=0
if [ "${1:-}" = --self-check ]; then
  self_check
else
  count=0
  for proof in "$proofs"/*.g; do
    count=$((count + 1))
    if proved "$proof"; then echo "proved: ${proof##*/}"; else echo "NOT proved: ${proof##*/}"; failures=$((failures + 1)); fi
  done
  [ "$count" -gt 0 ]
fi
[ "$failures" -eq 0 ]
