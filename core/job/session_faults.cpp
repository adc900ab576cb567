// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/job/session_faults.h"

#include <utility>

namespace burin {
namespace {

/// A device reports its fault some time after its readings became invalid: the record then still belongs to this fault.
constexpr std::chrono::seconds sameFault{2};
/// The device can also report its fault a moment before the record.
constexpr std::chrono::milliseconds recordPatience{200};

} // namespace

SessionFaults::SessionFaults(StylusDevice& device, double period, const std::filesystem::path& flights,
                             std::vector<std::string> materials, TickSink& loop)
    : device_(device), name_(device.description().name), loop_(loop) {
    if (flights.empty() || device.description().simulated) return;
    FlightSettings settings;
    settings.folder = flights;
    settings.device = name_;
    settings.period = period;
    settings.materials = std::move(materials);
    recorder_ = std::make_unique<FlightRecorder>(std::move(settings), loop);
}

std::filesystem::path SessionFaults::folderBeside(const std::filesystem::path& project) {
    return std::filesystem::path(project).replace_extension(".flights");
}

TickSink& SessionFaults::sink() noexcept {
    if (recorder_) return *recorder_;
    return loop_;
}

std::optional<Error> SessionFaults::take() {
    if (recorder_ && recorder_->writing()) return std::nullopt;
    if (std::optional<Error> fault = takeOfLoop()) return fault;
    return takeOfStylus();
}

std::optional<Error> SessionFaults::takeOfStylus() {
    const Clock::time_point now = Clock::now();
    if (!held_) {
        held_ = device_.takeFault();
        heldSince_ = now;
    }
    if (!held_) return std::nullopt;
    const bool recorded = !newest_.empty() && now - newestAt_ < sameFault;
    if (recorder_ && !recorded && !finished_ && now - heldSince_ < recordPatience) return std::nullopt;
    if (recorded) held_->place = newest_.string();
    return std::exchange(held_, std::nullopt);
}

std::optional<Error> SessionFaults::takeOfLoop() {
    while (recorder_) {
        const std::optional<FlightReport> report = recorder_->take();
        if (!report) break;
        newest_ = report->file;
        newestAt_ = Clock::now();
        const TextId reason = tickFaultReasons[static_cast<std::size_t>(report->fault)];
        if (*reason.text == '\0') continue; // the stylus reports it in its own words
        return Error{ErrorCode::deviceStopped, name_, report->file.string(), reason.text};
    }
    return std::nullopt;
}

} // namespace burin
