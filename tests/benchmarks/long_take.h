// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

#include <cstddef>
#include <string>

namespace burin::testing {

/// How a long take is recorded.
struct LongTake {
    std::size_t samples = 0;   ///< at 1 kHz
    std::size_t perCommit = 0; ///< a divisor of `samples`; a recorder commits some 50
    double noise = 0.0;        ///< mm, of the device, in each coordinate
};

/// Adds a take to a project that no other has open: rows along X, 2 mm apart, back and forth over the stock at 40 mm/s
/// with a tremor, 0.4 mm deeper each time. False: the project could not be changed.
bool recordLong(const QString& file, const std::string& tool, const LongTake& take);

} // namespace burin::testing
