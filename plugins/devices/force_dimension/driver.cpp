// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/force_dimension/driver.h"

#include "plugins/devices/force_dimension/dhd_stylus.h"
#include "plugins/devices/vendor/late_api.h"

#include <charconv>

namespace burin::forcedimension {
namespace {

constexpr int mostDevices = 16;
constexpr const char* byItself = "self_calibrating";
constexpr const char* careful = "calibrated";

/// The device number; empty if the text is not a number.
std::optional<DhdId> numberOf(const std::string& id) {
    int number = -1;
    const auto [end, fault] = std::from_chars(id.data(), id.data() + id.size(), number);
    if (fault != std::errc() || end != id.data() + id.size() || number < 0 || number >= mostDevices)
        return std::nullopt;
    return static_cast<DhdId>(number);
}

class Driver final : public DeviceDriver {
public:
    Result<void> ready() override {
        const Result<const DhdApi*> api = api_.get();
        if (!api) return api.error();
        return {};
    }

    /// Names are known only once a device is open, and opening would switch it on.
    std::vector<FoundDevice> find() override {
        std::vector<FoundDevice> found;
        const Result<const DhdApi*> api = api_.get();
        const int count = api ? std::min((*api)->getDeviceCount(), mostDevices) : 0;
        for (int i = 0; i < count; ++i)
            found.push_back({std::to_string(i),
                             "Force Dimension " + std::to_string(i + 1),
                             {{careful, BURIN_TEXT("Device", "Calibrated devices only")},
                              {byItself, BURIN_TEXT("Device", "Self-calibrating: the device moves by itself")}}});
        return found;
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (!mode.empty() && mode != careful && mode != byItself)
            return Error{ErrorCode::nameUnknown, "stylus", mode, std::string(careful) + ", " + byItself};
        const Result<const DhdApi*> api = api_.get();
        if (!api) return api.error();
        const std::optional<DhdId> number = numberOf(id);
        if (!number || *number >= (*api)->getDeviceCount()) return Error{ErrorCode::deviceNotFound, id, {}, {}};
        auto stylus =
            DhdStylus::connect(**api, *number, mode == byItself ? Initialisation::byItself : Initialisation::refuse);
        if (!stylus) return stylus.error();
        return AnyStylus(std::move(*stylus));
    }

private:
    vendor::LateApi<DhdApi> api_{loadDhdApi};
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver() {
    return std::make_unique<Driver>();
}

} // namespace burin::forcedimension
