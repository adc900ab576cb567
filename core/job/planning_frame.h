// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/field/tool_field.h"
#include "core/job/milling_context.h"

namespace burin {

/// A milling context seen along a fixed tool axis (3+2): planners for an upright tool plan in this frame for a tilted
/// one. For the axis +Z it is bitwise identical to the setup frame. The MillingContext and the field must outlive it.
class PlanningFrame {
public:
    /// @param field of the milling context's tool with this axis. @param axis unit, setup frame, towards the holder
    PlanningFrame(const MillingContext& milling, const ClearanceField& field, const glm::dvec3& axis);

    /// Returns the field over tips in this frame; valid as long as this object.
    const ClearanceField& field() const noexcept { return upright_ ? *setupField_ : seenField_; }
    const Box& stock() const noexcept { return stock_; } ///< mm: the box around the stock
    const Box& part() const noexcept { return part_; }   ///< mm
    bool upright() const noexcept { return upright_; }
    /// @param place mm, this frame
    glm::dvec3 toSetup(const glm::dvec3& place) const noexcept { return upright_ ? place : place * turn_; }
    /// Returns the box in the setup frame around a box in this frame.
    Box toSetup(const Box& box) const noexcept;

private:
    /// The field over tips in this frame.
    class SeenField final : public ClearanceField {
    public:
        SeenField(const ClearanceField& field, const glm::dmat3& turn) noexcept : field_(&field), turn_(turn) {}
        FieldSample at(const glm::dvec3& tip) const noexcept override;
        double errorBound() const noexcept override { return field_->errorBound(); }
        double errorBoundAt(const glm::dvec3& tip) const noexcept override { return field_->errorBoundAt(tip * turn_); }
        double spacing() const noexcept override { return field_->spacing(); }

    private:
        const ClearanceField* field_;
        glm::dmat3 turn_;
    };

    bool upright_;
    glm::dmat3 turn_; ///< from the setup frame
    const ClearanceField* setupField_;
    SeenField seenField_;
    Box stock_, part_;
};

} // namespace burin
