// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// What a drag or a click paints on the part, as an area in plan.
enum class AreaShape {
    brush, ///< the area covered by a round brush
    lasso, ///< the area enclosed by a line
    face   ///< the face of the part that is clicked
};

} // namespace burin
