// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/check_memory.h"

#include <bit>
#include <cstdint>
#include <sstream>
#include <utility>

namespace burin {

namespace {

/// FNV-1a of all corners, word by word: bodies of different shape may have the same extent.
std::uint64_t digestOf(const MeshDistance& surface) {
    std::uint64_t digest = 14695981039346656037U;
    for (const Triangle& triangle : surface.triangles())
        for (const glm::dvec3& corner : triangle)
            for (int axis = 0; axis < 3; ++axis)
                digest = (digest ^ std::bit_cast<std::uint64_t>(corner[axis])) * 1099511628211U;
    return digest;
}

void write(std::ostream& text, const Box& box) {
    for (const glm::dvec3& corner : {box.low, box.high}) text << corner.x << ' ' << corner.y << ' ' << corner.z << ' ';
}

} // namespace

KeptCheck::KeptCheck() = default;
KeptCheck::~KeptCheck() = default;

std::size_t KeptCheck::bytes() const noexcept {
    return memory_ ? memory_->bytes() : 0;
}

CheckMemory& KeptCheck::begin(std::string basis) {
    if (!memory_ || memory_->basis != basis) {
        memory_.reset(); // before the new one needs memory
        memory_ = std::make_unique<CheckMemory>();
        memory_->basis = std::move(basis);
    }
    return *memory_;
}

/// Numbers of moves that no program has any more would otherwise be kept for ever.
void KeptCheck::end() noexcept {
    constexpr std::size_t programs = 8, some = 100'000;
    const bool isStale = memory_ && memory_->moves.count() > programs * memory_->movesOfProgram + some;
    if (isStale || bytes() > mostBytes) memory_.reset();
}

std::size_t CheckMemory::bytes() const noexcept {
    std::size_t bytes = basis.size() + moves.bytes() + obstacles.bytes() + passes.bytes() + rows.bytes() +
                        gouges.samples.bytes() + gouges.exact.points.capacity() * sizeof(glm::dvec3) + reach.bytes();
    if (embedded) {
        const Grid& grid = embedded->workpiece.grid();
        bytes += embedded->workpiece.reservedBytes();
        bytes +=
            outlines.size() * static_cast<std::size_t>(grid.lineCountU()) * static_cast<std::size_t>(grid.lineCountV());
    }
    return bytes;
}

std::string basisText(const VerifyRequest& request, std::span<const Tool> tools) {
    std::ostringstream text;
    text << std::hexfloat << request.setup.voxel << ' ' << static_cast<int>(request.setup.form) << ' '
         << static_cast<int>(request.setup.runs) << ' ' << request.setup.stockMaterial << ' ';
    write(text, request.setup.stock);
    text << digestOf(*request.part) << ' ' << request.gougeTolerance << ' ' << request.sampling << ' '
         << request.nearDistance << ' ';
    for (const ObstacleSolid& obstacle : solidsOf(request.obstacles))
        text << obstacle.on << ' ' << digestOf(*obstacle.surface) << ' ';
    for (const Tool& tool : tools) text << toJson(tool) << ' ';
    return text.str();
}

} // namespace burin
