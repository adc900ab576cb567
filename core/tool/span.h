// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace burin {

/// An interval of a line, mm along its direction; low < high.
struct Span {
    double low = 0.0, high = 0.0;
};

} // namespace burin
