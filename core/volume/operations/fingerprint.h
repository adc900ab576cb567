// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <string>

namespace burin {

/// A hash of the content of a volume: its grid, and on each scanline the ends of its runs, to 1/256 voxel, with the ids
/// of their materials. Volumes with the same content have the same fingerprint, whatever their history and whichever
/// machine cut them; the values of materials are not included. For comparison, not for security (CRC-64 of each row of
/// bricks, and of these). Parallel; any thread. Cost: about that of reading the runs once.
/// @throws std::bad_alloc
std::uint64_t fingerprint(const VolumeSnapshot& volume);

/// The fingerprint in readable form: 16 hexadecimal digits.
std::string fingerprintText(std::uint64_t fingerprint);

} // namespace burin
