// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/input_events/pad_reader.h"
#include "plugins/devices/input_events/pen_mapping.h"
#include "tests/plugins/virtual_input.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

namespace {

/// Takes numbers from the input; zeros when it is used up.
class Numbers {
public:
    explicit Numbers(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
    bool empty() const { return bytes_.empty(); }
    template <class Number>
    Number next() {
        Number number{};
        const std::size_t size = bytes_.size() < sizeof number ? bytes_.size() : sizeof number;
        std::memcpy(&number, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
        return number;
    }

private:
    std::span<const std::uint8_t> bytes_;
};

} // namespace

/// Whatever a device states about itself and sends: no fault, no deflection beyond full, no invalid pose.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Numbers numbers({data, size});
    std::vector<burin::test::VirtualAxis> axes;
    for (const unsigned int code : {ABS_X, ABS_Y, ABS_Z, ABS_RX, ABS_RY, ABS_RZ, ABS_PRESSURE, ABS_TILT_X, ABS_TILT_Y})
        if ((numbers.next<std::uint8_t>() & 1U) != 0)
            axes.push_back({code, numbers.next<std::int32_t>(), numbers.next<std::int32_t>(),
                            numbers.next<std::int32_t>(), numbers.next<std::int32_t>()});
    const auto device = burin::test::virtualInput(axes, {BTN_TOUCH, BTN_SOUTH, BTN_TOOL_PEN});
    burin::input_events::PadReader pad(*device);
    burin::input_events::TabletReader tablet(*device);
    burin::input_events::PenMapping mapping;
    while (!numbers.empty()) {
        const auto type = numbers.next<std::uint8_t>();
        const auto code = numbers.next<std::uint16_t>();
        const input_event event = burin::test::eventOf(type, code, numbers.next<std::int32_t>());
        (void)pad.take(event);
        for (const std::int16_t axis : pad.controls().axes)
            if (std::abs(axis) > burin::input_events::PadReader::fullScale) std::abort();
        (void)tablet.take(event);
        const burin::Pose pose = mapping.advance(tablet.pen(), 0.01);
        if (!std::isfinite(glm::length(pose.position)) || std::abs(glm::length(pose.rotation) - 1.0) > 1e-6)
            std::abort();
    }
    return 0;
}
