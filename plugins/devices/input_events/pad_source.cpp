// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/pad_source.h"

#include <new>

namespace burin::input_events {

bool PadSource::connect() noexcept {
    const bool again = port_.connect();
    if (!again) return false;
    try {
        reader_ = PadReader(port_.device()); // resets buttons that were pressed when it was unplugged
        return true;
    } catch (const std::bad_alloc&) {
        return false;
    }
}

cap::ControlSource::Heard PadSource::receive(cap::Controls& controls, int milliseconds) noexcept {
    input_event event;
    const EventPort::Heard heard = port_.next(event, milliseconds);
    if (heard != EventPort::Heard::event) return heard == EventPort::Heard::gone ? Heard::gone : Heard::nothing;
    const PadReader::Kind kind = reader_.take(event);
    if (kind == PadReader::Kind::none) return Heard::nothing;
    controls = reader_.controls();
    return kind == PadReader::Kind::motion ? Heard::motion : Heard::other;
}

} // namespace burin::input_events
