// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/cap/controls.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace burin::spacemouse {

using Bytes = std::span<const std::uint8_t>;

using cap::Controls;

/// The part of the controls that a report changed.
enum class ReportKind : std::uint8_t { translation, rotation, motion, buttons, battery, unknown };

/// Applies reports to the controls. Layouts are distinguished by length, not by model: id 1 followed by 12 bytes: all
/// axes, by 6: translations; id 2 with 6: rotations; id 3: button bits; id 0x1c with 12: the numbers of up to six
/// pressed buttons (Enterprise); id 0x17 with 2: battery. Only the beginning of longer reports is used (some systems
/// pad reports to the longest one). Little endian.
/// One thread; no allocation, no exception.
/// Source: descriptors and recordings of SpaceNavigator and SpaceMouse Wireless (AndunHH/spacemouse), the descriptor of
/// the Enterprise (TheHoodedFoot/SpaceLCD, issue 3).
class ReportReader {
public:
    ReportKind take(Bytes report) noexcept;
    const Controls& controls() const noexcept { return controls_; }
    /// Resets to rest: no deflection, no button pressed. The battery state is kept.
    void rest() noexcept;

private:
    void takeAxes(Bytes bytes, std::size_t first, std::size_t count) noexcept;
    void takeKeys(Bytes bytes) noexcept;
    void joinButtons() noexcept { controls_.buttons = bits_ | keyBits_; }

    Controls controls_;
    std::uint32_t bits_ = 0, keyBits_ = 0;
};

/// The output report that switches the LED. @return the report, 2 bytes.
std::array<std::uint8_t, 2> ledReport(bool on) noexcept;

} // namespace burin::spacemouse
