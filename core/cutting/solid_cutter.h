// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/removed_units.h"
#include "core/cutting/solid_columns.h"
#include "core/volume/runs/run_volume.h"

#include <memory>
#include <optional>
#include <utility>

namespace burin {

/// Removes what the solid of an upright tool, which doesn't turn or is hollow, sweeps on straight moves from the
/// machinable runs of a workpiece, scanline by scanline and written at once; the deviation is that of SolidColumns.
/// Remembers where its last move ended: a move from there visits only what the tool enters. No allocation, lock or
/// exception in `cut`. Only on the workpiece's writer thread.
class SolidCutter {
public:
    /// @param columns never null; made for the grid of every workpiece that is cut
    explicit SolidCutter(std::shared_ptr<const SolidColumns> columns) : columns_(std::move(columns)) {}

    /// @param from, to tips, mm, setup frame, finite. Adds to `removed`.
    void cut(RunVolume& workpiece, const glm::dvec3& from, const glm::dvec3& to, RemovedUnits& removed) noexcept;
    /// Call after the workpiece was changed otherwise than by `cut`.
    void reset() noexcept { cleared_.reset(); }

private:
    std::shared_ptr<const SolidColumns> columns_;
    std::optional<glm::dvec3> cleared_; ///< mm, tip at which the flutes hold nothing machinable
};

} // namespace burin
