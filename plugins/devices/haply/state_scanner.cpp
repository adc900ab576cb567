// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/state_scanner.h"

#include <array>
#include <charconv>
#include <cmath>

namespace burin::haply {
namespace {

constexpr std::size_t deepest = 8; // levels of a message: array, device, state, quantity, component, and some spare

/// The keys that lead to a value, without indices of arrays.
struct Path {
    std::array<std::string_view, deepest> keys{};
    std::size_t length = 0;

    std::string_view key(std::size_t level) const noexcept { return level < length ? keys[level] : std::string_view(); }
};

/// Walks through a JSON text once, and passes on its texts, numbers and booleans together with the keys above them.
/// Escapes in texts are not decoded, because none of the relevant keys has one.
template <class Taker>
class Walker {
public:
    Walker(std::string_view text, Taker& taker) noexcept : rest_(text), taker_(taker) {}

    bool walk() noexcept {
        skipSpace();
        return !rest_.empty() && rest_.front() == '{' && value(0);
    }

private:
    void skipSpace() noexcept {
        while (!rest_.empty() &&
               (rest_.front() == ' ' || rest_.front() == '\n' || rest_.front() == '\r' || rest_.front() == '\t'))
            rest_.remove_prefix(1);
    }
    bool take(char wanted) noexcept {
        skipSpace();
        if (rest_.empty() || rest_.front() != wanted) return false;
        rest_.remove_prefix(1);
        return true;
    }
    std::optional<std::string_view> text() noexcept {
        if (!take('"')) return std::nullopt;
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            if (rest_[i] == '\\') {
                ++i;
                continue;
            }
            if (rest_[i] != '"') continue;
            const std::string_view found = rest_.substr(0, i);
            rest_.remove_prefix(i + 1);
            return found;
        }
        return std::nullopt;
    }
    bool word(std::string_view wanted) noexcept {
        if (!rest_.starts_with(wanted)) return false;
        rest_.remove_prefix(wanted.size());
        return true;
    }
    bool value(std::size_t depth) noexcept {
        skipSpace();
        if (rest_.empty() || depth > 2 * deepest) return false;
        switch (rest_.front()) {
        case '{':
            return object(depth);
        case '[':
            return list(depth);
        case '"': {
            const auto found = text();
            if (found) taker_.text(path_, *found);
            return found.has_value();
        }
        case 't':
            if (!word("true")) return false;
            taker_.truth(path_, true);
            return true;
        case 'f':
            if (!word("false")) return false;
            taker_.truth(path_, false);
            return true;
        case 'n':
            return word("null");
        default:
            return number();
        }
    }
    bool number() noexcept {
        double found = 0.0;
        const auto [end, fault] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), found);
        if (fault != std::errc()) return false;
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        taker_.number(path_, found);
        return true;
    }
    bool object(std::size_t depth) noexcept {
        rest_.remove_prefix(1);
        if (path_.length == deepest) return false;
        taker_.begins(path_);
        if (take('}')) return true;
        do {
            skipSpace();
            const auto key = text();
            if (!key || !take(':')) return false;
            path_.keys[path_.length++] = *key;
            const bool good = value(depth + 1);
            --path_.length;
            if (!good) return false;
        } while (take(','));
        return take('}');
    }
    bool list(std::size_t depth) noexcept {
        rest_.remove_prefix(1);
        if (take(']')) return true;
        do {
            if (!value(depth + 1)) return false;
        } while (take(','));
        return take(']');
    }

    std::string_view rest_;
    Taker& taker_;
    Path path_;
};

constexpr std::string_view arms = "inverse3";
constexpr std::string_view grips[] = {"verse_grip", "wireless_verse_grip"};

/// Collects the data of one device of a list after the other. An arm's id may come before or after its state.
class Gatherer {
public:
    explicit Gatherer(std::string_view arm) noexcept : arm_(arm) {}

    void begins(const Path& path) noexcept {
        if (path.length != 1) return; // a device in a list
        keep();
        ours_ = isGrip(path.key(0));
        device_ = ServiceState{};
        kind_ = path.key(0);
    }
    void text(const Path& path, std::string_view value) noexcept {
        if (path.length == 2 && path.key(0) == arms && path.key(1) == "device_id") ours_ = value == arm_;
    }
    void truth(const Path& path, bool value) noexcept {
        if (path.key(0) == arms && path.key(1) == "status") {
            if (path.key(2) == "ready") device_.ready = value;
            if (path.key(2) == "calibrated") device_.calibrated = value;
        }
        if (!isGrip(path.key(0)) || path.key(1) != "state" || !value) return;
        if (path.key(2) == "button") device_.buttons |= 1U;
        if (path.key(2) != "buttons") return;
        const std::string_view button = path.key(3);
        if (button.size() == 1 && button[0] >= 'a' && button[0] <= 'c')
            device_.buttons |= 1U << static_cast<unsigned>(button[0] - 'a');
    }
    void number(const Path& path, double value) noexcept {
        if (path.key(1) != "state") return;
        if (path.key(2) == "battery_level") device_.batteryShare = value;
        const std::string_view component = path.key(3);
        if (component.size() != 1) return;
        if (path.key(2) == "cursor_position") put(device_.cursor, component[0], value);
        if (path.key(2) == "current_cursor_force") put(device_.force, component[0], value);
        if (path.key(2) == "orientation" && isGrip(path.key(0))) turn(component[0], value);
    }
    ServiceState finish() noexcept {
        keep();
        return found_;
    }

private:
    static bool isGrip(std::string_view list) noexcept { return list == grips[0] || list == grips[1]; }
    static void put(std::optional<glm::dvec3>& vector, char component, double value) noexcept {
        if (component < 'x' || component > 'z') return;
        if (!vector) vector = glm::dvec3(NAN); // until all three components are there
        (*vector)[component - 'x'] = value;
    }
    void turn(char component, double value) noexcept {
        if (!device_.grip) device_.grip = glm::dquat(NAN, NAN, NAN, NAN);
        switch (component) {
        case 'w':
            device_.grip->w = value;
            break;
        case 'x':
            device_.grip->x = value;
            break;
        case 'y':
            device_.grip->y = value;
            break;
        case 'z':
            device_.grip->z = value;
            break;
        default:
            break;
        }
    }
    /// Keeps the data of the collected device if it is one of the relevant devices.
    void keep() noexcept {
        if (!ours_) return;
        if (kind_ == arms) {
            found_.cursor = device_.cursor;
            found_.force = device_.force;
            found_.ready = device_.ready;
            found_.calibrated = device_.calibrated;
        } else if (device_.grip && !found_.grip) {
            found_.grip = device_.grip;
            found_.buttons = device_.buttons;
            found_.batteryShare = device_.batteryShare;
        }
        ours_ = false;
    }

    std::string_view arm_, kind_;
    ServiceState found_, device_;
    bool ours_ = false;
};

} // namespace

std::optional<ServiceState> scanState(std::string_view message, std::string_view arm) noexcept {
    Gatherer gatherer(arm);
    if (!Walker(message, gatherer).walk()) return std::nullopt;
    return gatherer.finish();
}

} // namespace burin::haply
