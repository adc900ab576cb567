// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "plugins/devices/haply/driver.h"

#include "plugins/devices/haply/inventory.h"
#include "plugins/devices/haply/inverse_stylus.h"

#include <chrono>
#include <optional>

namespace burin::haply {
namespace {

// between queries for the arms of a running service: each query is a connection
constexpr std::chrono::seconds lookEvery{5};

class Driver final : public DeviceDriver {
public:
    std::vector<FoundDevice> find() override {
        const auto now = std::chrono::steady_clock::now();
        if (!lookedAt_ || arms_.empty() || now - *lookedAt_ >= lookEvery) {
            lookedAt_ = now;
            arms_ = look();
        }
        std::vector<FoundDevice> found;
        for (const std::string& arm : arms_) found.push_back({arm, "Haply Inverse3 " + arm, {}});
        return found;
    }

    Result<AnyStylus> make(const std::string& id, const std::string& mode) override {
        if (!mode.empty()) return Error{ErrorCode::nameUnknown, "stylus", mode, {}};
        auto stylus = InverseStylus::connect(id);
        if (!stylus) return stylus.error();
        return AnyStylus(std::move(*stylus));
    }

private:
    static std::vector<std::string> look() {
        const std::unique_ptr<ServiceConnection> connection = ServiceConnection::open(serviceAddress());
        return connection != nullptr ? armsOf(connection->first()) : std::vector<std::string>{};
    }

    std::vector<std::string> arms_;
    std::optional<std::chrono::steady_clock::time_point> lookedAt_;
};

} // namespace

std::unique_ptr<DeviceDriver> makeDriver() {
    return std::make_unique<Driver>();
}

} // namespace burin::haply
