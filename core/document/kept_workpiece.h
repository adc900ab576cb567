// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/recording/take_moment.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace burin {

/// A workpiece at a moment of its setup's recordings, stored so that it need not be cut again.
struct KeptWorkpiece {
    TakeMoment at;
    std::map<std::int64_t, std::size_t> strokes; ///< number of strokes not undone, for each take that has ended by then
    std::string volume;                          ///< in the format of a volume file
};

/// Identifies everything that a setup's workpiece is made of at one time: stock, recordings, and which parts of them
/// count. Only for comparison.
struct RecordedState {
    TakeMoment end; ///< of the last take
    std::int64_t digest = 0;
    friend bool operator==(const RecordedState&, const RecordedState&) = default;
};

} // namespace burin
