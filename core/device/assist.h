// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace burin {

/// The means of a device without motors that could hold the hand: the vibration of a gamepad, the weak motors of a
/// joystick with force feedback. They hint at forces; what keeps the tool out of the part is the loop alone.
struct AssistAbilities {
    bool rumble = false;   ///< it vibrates
    int forceAxes = 0;     ///< 0 … 2: axes of its stick that it can push
    bool permitted = true; ///< false: the user may not write to it, so that it shows nothing

    bool works() const noexcept { return permitted && (rumble || forceAxes > 0); }
};

/// What such a device shows in a tick, as shares of its strongest effect; none is greater than `ceiling`.
struct Assist {
    glm::dvec3 force{0.0}; ///< contact and cutting; device frame
    double contact = 0.0;  ///< how deep the hand pushes into what holds the tool
    double load = 0.0;     ///< how hard the tool cuts
    double ceiling = 0.0;  ///< 0 … 1, chosen by the user; 0: the device is left as it is
};

} // namespace burin
