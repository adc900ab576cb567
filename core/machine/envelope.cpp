// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/envelope.h"

namespace burin {

Envelope travelEnvelope(const MachineProfile& machine, const TravelPlacement& placement, const glm::dvec3& workOffset) {
    Envelope envelope;
    if (!placement.on) return envelope;
    const glm::dvec3& travel = machine.travel;
    const glm::dvec3 zero =
        placement.zero.value_or(glm::dvec3(0.5 * travel.x, 0.5 * travel.y, travel.z - machine.toolChangeHeight));
    envelope.tips.low = workOffset - zero;
    envelope.tips.high = envelope.tips.low + travel;
    return envelope;
}

} // namespace burin
