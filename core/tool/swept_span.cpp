// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/tool/swept_span.h"

namespace burin {

namespace {

std::variant<UprightSweep, TiltedSweep> sweepOf(const RevolvedPiece& piece, const glm::dvec3& fromTip,
                                                const glm::dvec3& toTip, const glm::dvec3& axis) noexcept {
    if (axis == glm::dvec3(0.0, 0.0, 1.0) && !piece.bulges()) return UprightSweep(piece, fromTip, toTip);
    return TiltedSweep(piece, fromTip, toTip, axis);
}

} // namespace

SweptPiece::SweptPiece(const RevolvedPiece& piece, const glm::dvec3& fromTip, const glm::dvec3& toTip,
                       const glm::dvec3& axis) noexcept
    : sweep_(sweepOf(piece, fromTip, toTip, axis)) {}

std::optional<Span> SweptPiece::shadow(double y) const noexcept {
    return std::visit([y](const auto& sweep) { return sweep.shadow(y); }, sweep_);
}

Box SweptPiece::bounds() const noexcept {
    return std::visit([](const auto& sweep) -> Box { return sweep.bounds(); }, sweep_);
}

} // namespace burin
