// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/machine/envelope.h"

#include <algorithm>

namespace burin {

Envelope travelEnvelope(const MachineProfile& machine, const TravelPlacement& placement, const glm::dvec3& workOffset,
                        const glm::dvec3& stockTop) {
    Envelope envelope;
    if (!placement.on) return envelope;
    const glm::dvec3& travel = machine.travel;
    const glm::dvec3 middle(0.5 * travel.x, 0.5 * travel.y, travel.z - machine.toolChangeHeight);
    // The tool change height is measured from program zero, or from the top of the stock if that is higher.
    const glm::dvec3 assumed(stockTop.x, stockTop.y, std::max(stockTop.z, workOffset.z));
    envelope.tips.low = placement.zero ? workOffset - *placement.zero : assumed - middle;
    envelope.tips.high = envelope.tips.low + travel;
    return envelope;
}

} // namespace burin
