// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/part_field/part_field.h"

#include "tests/part_field/part_field_builder.h"
#include "tests/part_field/part_field_layers.h"

#include <exception>
#include <new>

namespace burin {

PartField::PartField(std::unique_ptr<const PartFieldLayers> layers) : layers_(std::move(layers)) {}
PartField::~PartField() = default;
PartField::PartField(PartField&&) noexcept = default;
PartField& PartField::operator=(PartField&&) noexcept = default;

Result<PartField> PartField::build(const TriangleMesh& mesh, const PartFieldRequest& request, Progress& progress) {
    try {
        return build(std::make_shared<const MeshDistance>(mesh), request, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "distance field of a part", "", ""};
    }
}

Result<PartField> PartField::build(std::shared_ptr<const MeshDistance> part, const PartFieldRequest& request,
                                   Progress& progress) {
    if (!(request.voxel > 0.0) || !std::isfinite(request.voxel))
        return Error{ErrorCode::argumentInvalid, "voxel", "", "greater than 0 mm"};
    if (!std::isfinite(request.reach)) return Error{ErrorCode::argumentInvalid, "reach", "", "finite, mm"};
    try {
        Result<std::unique_ptr<const PartFieldLayers>> layers = buildPartField(std::move(part), request, progress);
        if (!layers) return layers.error();
        return PartField(std::move(*layers));
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, "distance field of a part", "", ""};
    } catch (const std::exception& fault) {
        return Error{ErrorCode::internalFault, "distance field of a part", "", fault.what()};
    }
}

double PartField::value(const glm::dvec3& point) const noexcept {
    return static_cast<double>(layers_->sample(point).distance);
}
PartDistance PartField::at(const glm::dvec3& point) const noexcept {
    return layers_->sample(point);
}
void PartField::at(std::span<const glm::dvec3> points, std::span<PartDistance> answers) const noexcept {
    layers_->sample(points, answers);
}
double PartField::errorBoundAt(const glm::dvec3& point) const noexcept {
    return layers_->bound(point);
}
double PartField::lowerBound(const Box& box) const noexcept {
    return layers_->leastIn(box);
}
double PartField::voxel() const noexcept {
    return layers_->request.voxel;
}
double PartField::reach() const noexcept {
    return layers_->request.reach;
}
const MeshDistance& PartField::exact() const noexcept {
    return *layers_->part;
}
std::size_t PartField::memoryBytes() const noexcept {
    return layers_->memoryBytes();
}
std::size_t PartField::fineBytes() const noexcept {
    return layers_->fineBytes();
}
std::size_t PartField::bandVoxels() const noexcept {
    return layers_->bandVoxels;
}

} // namespace burin
