// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/setup/face_alignment.h"

namespace burin {

Result<Placement> alignedFace(const PartFace& face, const glm::dvec3& direction, const glm::dvec3& through) {
    if (face.kind == PartFace::Kind::other)
        return Error{ErrorCode::argumentInvalid, "face", "curved", "a plane face, a cylinder or a cone"};
    const bool against = face.kind == PartFace::Kind::round && glm::dot(face.direction, direction) < 0.0;
    return turnedTowards(face.direction, against ? -direction : direction, through);
}

} // namespace burin
