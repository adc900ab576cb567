// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/core/geometry/shapes.h"
#include "tests/core/job/session_milling.h"

namespace burin::test {

/// The block with a smaller one in it as the part.
inline MillingContext partMilling(const Tool& tool, const Setup& setup = blockSetup()) {
    Body body;
    body.name = "block";
    body.box = {{6.0, 6.0, 1.0}, {14.0, 14.0, 8.0}};
    body.mesh = shapes::box(body.box.low, body.box.high);
    Model model;
    model.bodies = {body};
    Progress progress;
    Result<MillingContext> milling =
        makeMillingContext({std::make_shared<const Model>(model), setup, tool, "linuxcnc-mill", {}, {}}, progress);
    if (!milling) std::abort(); // the test's own set-up
    return std::move(*milling);
}

} // namespace burin::test
