# SPDX-License-Identifier: MIT
# Prints each function longer than `limit` lines, signature included. Counts on clang-format: a definition begins in
# column 0, or in column 2 inside a class, and its last line is a brace in the same column.

function measure(depth) {
  if (body[depth] && FNR - start[depth] + 1 > limit)
    printf "%s:%d: function of %d lines, %d allowed\n", FILENAME, start[depth], FNR - start[depth] + 1, limit
  start[depth] = body[depth] = 0
}

# One line of code that may begin, continue or open a definition at `depth`.
function consider(depth, begins) {
  if (body[depth]) return
  if (code ~ /^ *(inline )?(namespace|class|struct|enum|union|using|extern "C")/ || code ~ /= *\{|\{\{/) {
    start[depth] = 0
    return
  }
  if (begins && !start[depth]) start[depth] = FNR
  # A brace that touches a name opens a value, not a body.
  if (start[depth] && code ~ /[^A-Za-z0-9_>]\{ *$/) body[depth] = 1
  if (!body[depth] && code ~ /[;}] *$/) start[depth] = 0
}

FNR == 1 { start[0] = start[2] = body[0] = body[2] = 0 }
{ code = $0; sub(/ *\/\/.*/, "", code) }
code ~ /^ *(#|$)/ { next }
code ~ /^}/ { measure(0); start[2] = body[2] = 0; next }
code ~ /^  }/ && !body[0] { measure(2); next }
code ~ /^[^ ]/ { start[2] = 0; consider(0, 1); next }
start[0] { consider(0, 0); next }
code ~ /^  [^ ]/ { consider(2, 1); next }
start[2] { consider(2, 0) }
