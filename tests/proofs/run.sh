#!/usr/bin/env bash
# Checks every proof in docs/proofs with gappa. Exit code 77: gappa is missing.
#   run.sh                all proofs
#   run.sh --self-check   weakened bounds must fail
set -euo pipefail
proofs="$(cd "$(dirname "${BASH_SOURCE[0]}")/../../docs/proofs" && pwd)"
if ! command -v gappa > /dev/null; then echo "gappa is missing: proofs not checked"; exit 77; fi

# holds FILE: gappa accepts it; a search without end counts as a failure.
holds() { timeout 60 gappa -Wno-unbound-variable "$1" > /dev/null 2>&1; }

failures=0
if [ "${1:-}" = --self-check ]; then
  scratch=$(mktemp -d)
  trap 'rm -rf "$scratch"' EXIT
  # refuted FILE OLD NEW: with the text OLD replaced by NEW the proof fails.
  refuted() {
    local text
    text=$(< "$proofs/$1")
    if [[ $text != *"$2"* ]]; then echo "$1: no such text: $2"; failures=$((failures + 1)); return; fi
    printf '%s\n' "${text//"$2"/"$3"}" > "$scratch/$1"
    if holds "$scratch/$1"; then echo "$1: holds with $3 too"; failures=$((failures + 1)); else echo "refused: $1 with $3"; fi
  }
  refuted rounding.g '[-0x3.001p-53, 0x3.001p-53]' '[-0x2.fp-53, 0x2.fp-53]'
  refuted pair.g '<= 0x4.2p-53' '<= 4b-53'
  refuted side_filter.g '[-8b-53, 8b-53]' '[-5b-53, 5b-53]'
  refuted turn_term.g '<= 0x6.3p-53' '<= 6b-53'
  refuted turn_filter.g '[-16b-53, 16b-53]' '[-8b-53, 8b-53]'
  refuted orientation_filter.g '<= 0x7.fp-53' '<= 0x5.fp-53'
else
  count=0
  for proof in "$proofs"/*.g; do
    count=$((count + 1))
    if holds "$proof"; then echo "proved: ${proof##*/}"; else echo "NOT proved: ${proof##*/}"; failures=$((failures + 1)); fi
  done
  [ "$count" -gt 0 ]
fi
[ "$failures" -eq 0 ]
