// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/progress.h"
#include "core/volume/runs/run_volume.h"

#include <cstdint>
#include <memory>
#include <string>

namespace burin {

/// A stock that is given voxel by voxel: a scan, a casting, the stock left by another clamping. Kept in the form of a
/// volume file, as the project stores it. Immutable and thread-safe.
class StockVolume {
public:
    using Shared = std::shared_ptr<const StockVolume>;

    /// @param name of the file that it came from, for display
    /// Errors: those of writeVolume, stockInvalid (only air).
    static Result<Shared> of(const VolumeSnapshot& volume, const std::string& name, Progress& progress);
    /// @param content a volume file. Errors: those of readVolume, fileDamaged, stockInvalid (only air).
    static Result<Shared> read(std::string content, const std::string& name, Progress& progress);

    const std::string& name() const noexcept { return name_; }
    const Grid& grid() const noexcept { return grid_; } ///< setup frame
    const PropertyList& materials() const noexcept { return materials_; }
    const RunAmounts& amounts() const noexcept { return amounts_; } ///< by entry of `materials`
    const std::string& content() const noexcept { return content_; }
    std::uint64_t checksum() const noexcept { return checksum_; } ///< of the content
    /// Returns the entry of the material with the largest amount.
    PropertyIndex mainMaterial() const noexcept;

    /// Returns the volume with its runs and the same property list. Errors: those of readVolume.
    Result<RunVolume> unpack(Progress& progress) const;

private:
    StockVolume(std::string content, std::string name, const RunVolume& volume);
    std::string content_, name_;
    Grid grid_;
    PropertyList materials_;
    RunAmounts amounts_;
    std::uint64_t checksum_ = 0;
};

} // namespace burin
