// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/cutting/contact.h"
#include "core/cutting/solid_columns.h"

#include <memory>
#include <optional>
#include <utility>

namespace burin {

/// Run units by which the shank of a tool that doesn't turn may overlap a line: a quarter of a voxel.
inline constexpr RunPosition solidContactTolerance = unitsPerVoxel / 4;

/// Checks the shank of an upright tool that doesn't turn, which has a model of its own, for contact with everything in
/// a workpiece, tick by tick. Remembers where the shank was last free: from there only what it enters is read. Between
/// two calls of `at` the volume may only lose material, otherwise call `forget`. Only on the writer's thread. No
/// allocation, lock or exception after construction.
class SolidContact {
public:
    /// @param columns never null, with a shank; made for the workpiece's grid @param piece of the shank, for
    /// ShankContact
    SolidContact(std::shared_ptr<const SolidColumns> columns, std::uint32_t piece)
        : columns_(std::move(columns)), piece_(piece) {}

    /// @param tip mm, setup frame; one that is not finite touches nothing
    ShankContact at(const RunVolume& workpiece, const glm::dvec3& tip) noexcept;
    void forget() noexcept { free_.reset(); }

private:
    std::shared_ptr<const SolidColumns> columns_;
    std::uint32_t piece_;
    std::optional<glm::dvec3> free_; ///< mm, tip at which the shank touched nothing
};

} // namespace burin
