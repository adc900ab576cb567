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

/// The bricks in which two moments of one volume differ, packed, as they were before and after: a stretch of cutting
/// that can be taken back and done again. Needs no snapshot and none of the volume's reserved memory. Immutable.
class VolumeDelta {
public:
    /// Gives a volume that stands at "after" the bricks of "before", or the other way about. Amounts follow.
    /// Errors: volumeOutOfMemory (its reserve does not hold both moments of the bricks concerned); the volume is then
    /// what it was. Allocates. Writer's thread, outside the haptic loop; it must stand at the moment that is left.
    /// Cost: some µs a brick.
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
        std::uint64_t before = 0, after = 0; ///< where its packed form begins
    };
    bool put(RunVolume& volume, std::uint64_t Brick::*moment) const;
    Result<void> apply(RunVolume& volume, std::uint64_t Brick::*moment) const;

    std::string bytes_;
    std::vector<Brick> bricks_;
};

/// Makes a VolumeDelta bit by bit, so that a thread with other things to do is never held up for long. Holds both
/// snapshots until it is done.
class VolumeDeltaPacker {
public:
    /// Both must show the same volume. @throws std::bad_alloc
    VolumeDeltaPacker(VolumeSnapshot before, VolumeSnapshot after);
    ~VolumeDeltaPacker();
    VolumeDeltaPacker(VolumeDeltaPacker&&) noexcept;
    VolumeDeltaPacker& operator=(VolumeDeltaPacker&&) noexcept;

    /// Packs up to so many bricks more (parallel, some µs each). True: it is done. @throws std::bad_alloc
    bool advance(std::size_t bricks);
    /// What was packed, once `advance` has answered true.
    VolumeDelta take();

private:
    struct Work;
    std::unique_ptr<Work> work_;
};

/// All at once. Both must show the same volume. @throws std::bad_alloc
VolumeDelta deltaBetween(const VolumeSnapshot& before, const VolumeSnapshot& after);

} // namespace burin
