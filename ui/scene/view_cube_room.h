// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// The square in the upper right corner of a view that is occupied by its view cube, device-independent pixels.
struct ViewCubeRoom {
    static constexpr double side = 104.0, margin = 8.0;
};

} // namespace burin
