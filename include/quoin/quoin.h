/// \file
/// Quoin: exact Boolean operations on polyhedral solids. This header includes the whole C++ API; each of the others
/// stands alone.
///
/// Units. A `Grid` has a step (model units per grid step) and an origin. Doors (files, arrays) speak model units;
/// exact quantities are rationals written as strings "p/q" or "p".
/// Errors. Doors and long operations return `Result`. Operators between solids, and a `Result` that is asked for what
/// it does not hold, throw `Exception`; memory exhaustion throws `std::bad_alloc`. Nothing else throws.
/// Names. `unite`, `intersect`, `difference`, `symmetric_difference`, `complement`: the same words for solids, and as
/// static functions of `Expression` and `Model`.
/// Threads. A `Solid` is an immutable value, cheap to copy and safe to read from many threads.
/// Lifetime. Quoin may be used while static objects are made and destroyed.
#pragma once

#include "quoin/export.h"

#include "quoin/arrays.h"
#include "quoin/boundary.h"
#include "quoin/error.h"
#include "quoin/expression.h"
#include "quoin/files.h"
#include "quoin/format.h"
#include "quoin/grid.h"
#include "quoin/history.h"
#include "quoin/import.h"
#include "quoin/labels.h"
#include "quoin/limits.h"
#include "quoin/model.h"
#include "quoin/motion.h"
#include "quoin/notice.h"
#include "quoin/options.h"
#include "quoin/questions.h"
#include "quoin/repair.h"
#include "quoin/report.h"
#include "quoin/result.h"
#include "quoin/solid.h"
#include "quoin/statistics.h"
#include "quoin/triangles.h"
#include "quoin/version.h"
