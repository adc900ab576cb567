// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <string>

namespace burin {

/// A hash of all that a volume holds: its grid, and on each scanline where its runs end, to 1/256 voxel, and the ids of
/// their materials. Volumes that hold the same have the same one, however they came to it and whichever machine cut
/// them; the values of materials are of no account. For telling two apart, not for security (CRC-64 of each row of
/// bricks, and of these). Parallel; any thread. Cost: about that of reading the runs once.
/// @throws std::bad_alloc
std::uint64_t fingerprint(const VolumeSnapshot& volume);

/// As people compare them: 16 hexadecimal digits.
std::string fingerprintText(std::uint64_t fingerprint);

} // namespace burin
