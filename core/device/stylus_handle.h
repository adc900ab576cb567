// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/device/device_driver.h"

#include <variant>

namespace burin {

/// A non-owning reference to a stylus of either kind. Never empty; a copy refers to the same stylus.
class StylusHandle {
public:
    StylusHandle(Stylus& stylus) noexcept : held_(&stylus) {}          // NOLINT: implicit on purpose
    StylusHandle(SelfPacedStylus& stylus) noexcept : held_(&stylus) {} // NOLINT: implicit on purpose
    /// @param stylus not null
    StylusHandle(const AnyStylus& stylus) // NOLINT: implicit on purpose
        : held_(std::visit([](const auto& owned) -> Held { return owned.get(); }, stylus)) {}

    StylusDevice& device() const noexcept {
        if (Stylus* stylus = called()) return *stylus;
        return *selfPaced();
    }
    /// Null if the stylus is of the other kind.
    Stylus* called() const noexcept {
        Stylus* const* stylus = std::get_if<Stylus*>(&held_);
        return stylus != nullptr ? *stylus : nullptr;
    }
    SelfPacedStylus* selfPaced() const noexcept {
        SelfPacedStylus* const* stylus = std::get_if<SelfPacedStylus*>(&held_);
        return stylus != nullptr ? *stylus : nullptr;
    }

private:
    using Held = std::variant<Stylus*, SelfPacedStylus*>;
    Held held_;
};

} // namespace burin
