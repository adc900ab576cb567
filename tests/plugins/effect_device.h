// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "plugins/devices/input_events/effect_port.h"

#include <cerrno>
#include <map>
#include <optional>
#include <vector>

namespace burin::test {

/// A device with force feedback in memory: what it renders at any time follows from the calls, by the rules of the
/// kernel's interface. An effect lasts `replay.length` from its start; all end when the port is closed.
class EffectDevice {
public:
    bool there = true;     ///< plugged in
    int openFault = 0;     ///< errno for the next attempts to open it
    int writeFault = 0;    ///< errno for all calls
    std::size_t room = 16; ///< number of effects
    double now = 0.0;      ///< s
    int opened = 0, uploads = 0, starts = 0;
    std::map<unsigned int, std::vector<int>> properties; ///< values that were set, in order

    input_events::OpenEffectPort opener() {
        return [this](int& fault) -> std::unique_ptr<input_events::EffectPort> {
            fault = there ? openFault : ENODEV;
            if (fault != 0) return nullptr;
            ++opened;
            return std::make_unique<Port>(*this);
        };
    }
    /// The effect of a type that is being played; empty: none is.
    std::optional<ff_effect> played(std::uint16_t type) const {
        for (const auto& [id, state] : effects_)
            if (state.effect.type == type && there && now < state.endsAt) return state.effect;
        return std::nullopt;
    }
    bool silent() const {
        return !played(FF_CONSTANT) && !played(FF_RUMBLE) && !played(FF_SPRING) && !played(FF_DAMPER);
    }
    std::size_t kept() const { return effects_.size(); }
    bool isOpen() const { return open_ > 0; }

private:
    struct State {
        ff_effect effect{};
        double endsAt = 0.0; ///< s
    };
    class Port final : public input_events::EffectPort {
    public:
        explicit Port(EffectDevice& device) : device_(device) { ++device_.open_; }
        ~Port() override {
            --device_.open_;
            device_.effects_.clear();
        }
        int upload(ff_effect& effect) noexcept override {
            if (const int fault = device_.fault(); fault != 0) return fault;
            if (effect.id < 0 && device_.effects_.size() == device_.room) return ENOSPC;
            if (effect.id < 0) effect.id = static_cast<std::int16_t>(device_.effects_.size());
            device_.effects_[effect.id].effect = effect;
            ++device_.uploads;
            return 0;
        }
        int play(int id, bool on) noexcept override {
            if (const int fault = device_.fault(); fault != 0) return fault;
            if (!device_.effects_.contains(id)) return EINVAL;
            State& state = device_.effects_[id];
            constexpr double milliseconds = 1e-3;
            state.endsAt = on ? device_.now + milliseconds * state.effect.replay.length : device_.now;
            device_.starts += on ? 1 : 0;
            return 0;
        }
        int set(unsigned int property, int value) noexcept override {
            if (const int fault = device_.fault(); fault != 0) return fault;
            device_.properties[property].push_back(value);
            return 0;
        }

    private:
        EffectDevice& device_;
    };
    int fault() const { return there ? writeFault : ENODEV; }

    std::map<int, State> effects_;
    int open_ = 0;
};

} // namespace burin::test
