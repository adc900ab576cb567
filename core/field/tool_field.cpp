// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/field/tool_field.h"

#include "core/field/brick_field.h"
#include "core/field/field_builder.h"

#include <exception>
#include <new>

namespace burin {

ToolField::ToolField(std::unique_ptr<const BrickField> bricks) : bricks_(std::move(bricks)) {}
ToolField::~ToolField() = default;
ToolField::ToolField(ToolField&&) noexcept = default;
ToolField& ToolField::operator=(ToolField&&) noexcept = default;

Result<ToolField> ToolField::build(const MeshDistance& part, const ToolFieldRequest& request, Progress& progress) {
    if (Result<void> usable = checkFieldRequest(request); !usable) return std::move(usable).error();
    try {
        Result<BrickField> bricks = buildBrickField(part, request, progress);
        if (!bricks) return bricks.error();
        return ToolField(std::make_unique<const BrickField>(std::move(*bricks)));
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "boundary field of a tool", "", ""};
    } catch (const std::exception& fault) {
        return Error{ErrorCode::internalFault, "boundary field of a tool", "", fault.what()};
    }
}

FieldSample ToolField::at(const glm::dvec3& tip) const noexcept {
    return bricks_->sample(tip);
}
double ToolField::errorBound() const noexcept {
    return 2.0 * bricks_->interpolationBound + bricks_->quantum;
}
double ToolField::errorBoundAt(const glm::dvec3& tip) const noexcept {
    return bricks_->bound(tip);
}
double ToolField::spacing() const noexcept {
    return bricks_->spacing;
}
std::size_t ToolField::memoryBytes() const noexcept {
    return sizeof(BrickField) + bricks_->memoryBytes();
}

} // namespace burin
