// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/effect_player.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace burin::input_events {
namespace {

ff_effect effectOf(std::uint16_t type) noexcept {
    ff_effect effect{};
    effect.type = type;
    effect.id = -1;
    effect.replay.length = EffectPlayer::replayMilliseconds;
    return effect;
}

std::int16_t coefficient(std::uint16_t type) noexcept {
    constexpr double strongest = 0x7fff;
    const double share = type == FF_SPRING ? EffectPlayer::springShare : EffectPlayer::damperShare;
    return static_cast<std::int16_t>(std::lround(share * strongest));
}

/// The effect of a type for these levels.
ff_effect effectFor(std::uint16_t type, const EffectLevels& levels) noexcept {
    ff_effect effect = effectOf(type);
    if (type == FF_CONSTANT) {
        effect.direction = levels.direction;
        effect.u.constant.level = levels.level;
    } else if (type == FF_RUMBLE) {
        effect.u.rumble.strong_magnitude = levels.strong;
        effect.u.rumble.weak_magnitude = levels.weak;
    } else {
        for (ff_condition_effect& axis : effect.u.condition) {
            axis.right_saturation = axis.left_saturation = levels.ceiling;
            axis.right_coeff = axis.left_coeff = coefficient(type);
        }
    }
    return effect;
}

bool isSilent(const ff_effect& effect) noexcept {
    if (effect.type == FF_CONSTANT) return effect.u.constant.level == 0;
    if (effect.type == FF_RUMBLE) return effect.u.rumble.strong_magnitude == 0 && effect.u.rumble.weak_magnitude == 0;
    return effect.u.condition[0].right_saturation == 0;
}

/// The greatest difference of a value, as a share of its range.
double differenceOf(const ff_effect& one, const ff_effect& other) noexcept {
    constexpr double word = 0xffff, level = 0x7fff;
    const auto off = [](int first, int second, double range) { return std::abs(first - second) / range; };
    if (one.type == FF_CONSTANT) {
        const int turned = static_cast<std::int16_t>(one.direction - other.direction); // the shorter way round
        return std::max(off(one.u.constant.level, other.u.constant.level, level), std::abs(turned) / word);
    }
    if (one.type == FF_RUMBLE)
        return std::max(off(one.u.rumble.strong_magnitude, other.u.rumble.strong_magnitude, word),
                        off(one.u.rumble.weak_magnitude, other.u.rumble.weak_magnitude, word));
    return off(one.u.condition[0].right_saturation, other.u.condition[0].right_saturation, word);
}

} // namespace

int EffectPlayer::add(const ff_effect& effect) {
    Effect added{effect};
    const int fault = port_.upload(added.uploaded);
    if (fault == 0) effects_.push_back(added);
    return fault;
}

int EffectPlayer::begin() {
    if (abilities_.gain)
        if (const int fault = port_.set(FF_GAIN, full); fault != 0) return fault;
    if (abilities_.constant)
        if (const int fault = add(effectOf(FF_CONSTANT)); fault != 0) return fault;
    if (abilities_.rumble)
        if (const int fault = add(effectOf(FF_RUMBLE)); fault != 0 && !abilities_.constant) return fault;
    if (!abilities_.constant) return 0;
    const bool springs = abilities_.spring && add(effectFor(FF_SPRING, {})) == 0;
    if (abilities_.damper) add(effectFor(FF_DAMPER, {})); // does without, if there is no room
    if (!springs || !abilities_.autocentre) return 0;
    centringOff_ = true;
    return port_.set(FF_AUTOCENTER, 0);
}

int EffectPlayer::show(const EffectLevels& levels, double now) noexcept {
    for (Effect& effect : effects_)
        if (const int fault = show(effect, effectFor(effect.uploaded.type, levels), now); fault != 0) return fault;
    return 0;
}

int EffectPlayer::show(Effect& effect, const ff_effect& wanted, double now) noexcept {
    constexpr double noticed = 1.0 / 128.0;
    const int id = effect.uploaded.id;
    if (isSilent(wanted)) return std::exchange(effect.playing, false) ? port_.play(id, false) : 0;
    const double difference = differenceOf(wanted, effect.uploaded), since = now - effect.changedAt;
    const bool changes = !effect.playing || (difference >= noticed && since >= changeAfter) || since >= settleAfter;
    if (changes && difference > 0.0) {
        effect.uploaded = wanted;
        effect.uploaded.id = static_cast<std::int16_t>(id);
        if (const int fault = port_.upload(effect.uploaded); fault != 0) return fault;
        effect.changedAt = now;
    }
    if (effect.playing && now - effect.startedAt < renewAfter) return 0;
    effect.playing = true;
    effect.startedAt = now;
    return port_.play(id, true);
}

void EffectPlayer::end() noexcept {
    for (Effect& effect : effects_)
        if (effect.playing) port_.play(effect.uploaded.id, false);
    if (centringOff_) port_.set(FF_AUTOCENTER, full);
    effects_.clear();
    centringOff_ = false;
}

} // namespace burin::input_events
