// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/volume/runs/run_volume.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace burin {

/// The bricks in which two states of one volume differ, packed, before and after: a part of the cutting that can be
/// undone and redone. Needs no snapshot and none of the volume's reserved memory. Immutable.
class VolumeDelta {
public:
    /// Replaces the bricks of "after" in a volume by those of "before", or the reverse. Amounts are updated. Errors:
    /// volumeOutOfMemory (its reserve does not have room for both states of the bricks concerned); the volume is then
    /// unchanged. Allocates. Writer's thread, outside the haptic loop; the volume must be in the state that is left.
    /// Cost: some µs per brick.
    Result<void> applyBackward(RunVolume& volume) const { return apply(volume, &Brick::before); }
    Result<void> applyForward(RunVolume& volume) const { return apply(volume, &Brick::after); }

    std::size_t bricks() const noexcept { return bricks_.size(); }
    std::size_t memoryBytes() const noexcept {
        return bytes_.capacity() + bricks_.capacity() * sizeof(Brick) + sizeof *this;
    }

private:
    friend class VolumeDeltaPacker;
    struct Brick {
        LineIndex corner;
        std::uint64_t before = 0, after = 0; ///< start of its packed form
    };
    bool put(RunVolume& volume, std::uint64_t Brick::*moment) const;
    Result<void> apply(RunVolume& volume, std::uint64_t Brick::*moment) const;

    std::string bytes_;
    std::vector<Brick> bricks_;
};

/// Makes a VolumeDelta in steps, so that a thread with other work is never blocked for long. Holds both snapshots until
/// it is done.
class VolumeDeltaPacker {
public:
    /// Both must show the same volume. @throws std::bad_alloc
    VolumeDeltaPacker(VolumeSnapshot before, VolumeSnapshot after);
    ~VolumeDeltaPacker();
    VolumeDeltaPacker(VolumeDeltaPacker&&) noexcept;
    VolumeDeltaPacker& operator=(VolumeDeltaPacker&&) noexcept;

    /// Packs up to `bricks` further bricks (parallel, some µs each). True: done. @throws std::bad_alloc
    bool advance(std::size_t bricks);
    /// The result, once `advance` has returned true.
    VolumeDelta take();

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

/// Makes the delta in one step. Both must show the same volume. @throws std::bad_alloc
VolumeDelta deltaBetween(const VolumeSnapshot& before, const VolumeSnapshot& after);

} // namespace burin
