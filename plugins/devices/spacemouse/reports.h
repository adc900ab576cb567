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

/// Which part of the controls a report changed.
enum class ReportKind : std::uint8_t { translation, rotation, motion, buttons, battery, unknown };

/// Adds reports to controls. Layouts are told apart by length, not by model:
/// id 1 with 12 bytes behind it: all axes, with 6: translations; id 2 with 6: rotations; id 3: button bits; id 0x1c
/// with 12: the numbers of up to six pressed buttons (Enterprise); id 0x17 with 2: battery. Longer reports count by
/// what stands at their beginning (some systems fill them up to the longest one). Little endian.
/// One thread; no allocation, no exception.
/// Source: descriptors and recordings of SpaceNavigator and SpaceMouse Wireless (AndunHH/spacemouse), the descriptor of
/// the Enterprise (TheHoodedFoot/SpaceLCD, issue 3).
class ReportReader {
public:
    ReportKind take(Bytes report) noexcept;
    const Controls& controls() const noexcept { return controls_; }
    /// As at rest: nothing moved, nothing pressed. The battery stays.
    void rest() noexcept;

private:
    void takeAxes(Bytes bytes, std::size_t first, std::size_t count) noexcept;
    void takeKeys(Bytes bytes) noexcept;
    void joinButtons() noexcept { controls_.buttons = bits_ | keyBits_; }

    Controls controls_;
    std::uint32_t bits_ = 0, keyBits_ = 0;
};

/// The output report that lights the LED. @param size of the report: 2 bytes.
std::array<std::uint8_t, 2> ledReport(bool on) noexcept;

} // namespace burin::spacemouse
