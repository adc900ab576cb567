// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <linux/input.h>

#include <filesystem>
#include <functional>
#include <memory>

namespace burin::input_events {

/// The effects of an input device: the kernel's force feedback. One thread. Functions return 0, or the system's error
/// number; they may block. The effects end and are removed when the object ends.
class EffectPort {
public:
    virtual ~EffectPort() = default;
    /// Makes an effect, or changes it. @param effect its id: -1 for a new one, which receives its id
    virtual int upload(ff_effect& effect) noexcept = 0;
    /// Starts an effect from its beginning, also if it is being played, or stops it.
    virtual int play(int id, bool on) noexcept = 0;
    /// @param property FF_GAIN or FF_AUTOCENTER. @param value 0 … 0xFFFF
    virtual int set(unsigned int property, int value) noexcept = 0;
};

/// Opens the port of a device; null with an error number if it is not there or must not be written.
using OpenEffectPort = std::function<std::unique_ptr<EffectPort>(int& fault)>;

/// The port of a device of the system. @param node in /dev/input
std::unique_ptr<EffectPort> openEffectPort(const std::filesystem::path& node, int& fault);

} // namespace burin::input_events
