// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/apply.h"

namespace burin {

Result<Deviation> apply(const Reverse& edit, PathUnderEdit& state, const PathContext&, Progress&) {
    for (PathStroke& stroke : state.strokes)
        if (touches(edit.interval, stroke)) stroke = reversed(stroke);
    return Deviation{};
}

} // namespace burin
