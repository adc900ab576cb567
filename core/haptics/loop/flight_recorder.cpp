// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/haptics/loop/flight_recorder.h"

#include "core/base/file.h"
#include "core/base/wall_clock.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <system_error>
#include <utility>

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds interval{20}; // between two checks for raised faults
constexpr std::string_view start = "flight-", ending = ".csv";

/// File names sort chronologically.
std::string fileName(double time, TickFault fault) {
    const auto seconds = static_cast<std::time_t>(std::floor(time));
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    char text[64];
    const auto milliseconds = static_cast<int>((time - std::floor(time)) * 1e3);
    const std::size_t size = std::strftime(text, sizeof text, "%Y%m%dT%H%M%S", &parts);
    std::snprintf(text + size, sizeof text - size, ".%03dZ-", milliseconds);
    return std::string(start) + text + std::string(nameOf(fault)) + std::string(ending);
}

void removeOldest(const fs::path& folder, int keep) {
    std::vector<fs::path> records;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with(start) && name.ends_with(ending)) records.push_back(entry->path());
    }
    std::ranges::sort(records);
    for (std::size_t i = 0; i + static_cast<std::size_t>(std::max(keep, 1)) < records.size(); ++i)
        fs::remove(records[i], failed);
}

} // namespace

FlightRecorder::FlightRecorder(FlightSettings settings, TickSink& next)
    : settings_(std::move(settings))
    , next_(next)
    , entries_(static_cast<std::size_t>(std::ceil(length / settings_.period)))
    , thread_([this](const std::stop_token& stop) { run(stop); }) {}

void FlightRecorder::finish() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

void FlightRecorder::tick(const Sample& sample, const TickTiming& timing) noexcept {
    Turn nobody = Turn::nobody;
    if (turn_.compare_exchange_strong(nobody, Turn::loop, std::memory_order_acquire)) {
        entries_[count_++ % entries_.size()] = {sample, timing};
        turn_.store(Turn::nobody, std::memory_order_release);
    }
    if (timing.fault != TickFault::none) raise(timing.fault);
    next_.tick(sample, timing);
}

void FlightRecorder::raise(TickFault fault) noexcept {
    raised_.raise(fault);
    wanted_.store(true, std::memory_order_release);
}

void FlightRecorder::run(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (!stop.stop_requested()) {
        lock.unlock();
        writeRaised();
        lock.lock();
        woken_.wait_for(lock, stop, interval, [] { return false; });
    }
    lock.unlock();
    writeRaised();
}

/// Returns the newest entries, the oldest first. The loop holds its turn for less than a microsecond, unless it is
/// descheduled right then.
std::vector<FlightRecorder::Entry> FlightRecorder::freeze() {
    for (Turn nobody = Turn::nobody; !turn_.compare_exchange_weak(nobody, Turn::writer, std::memory_order_acquire);
         nobody = Turn::nobody)
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    std::vector<Entry> ordered;
    const std::uint64_t size = entries_.size(), kept = std::min<std::uint64_t>(count_, size);
    ordered.reserve(kept);
    for (std::uint64_t i = count_ - kept; i < count_; ++i) ordered.push_back(entries_[i % size]);
    turn_.store(Turn::nobody, std::memory_order_release);
    return ordered;
}

void FlightRecorder::writeRaised() {
    // set before `wanted_` is cleared, so that `writing` is true without interruption
    writing_.store(true, std::memory_order_release);
    if (wanted_.exchange(false, std::memory_order_acq_rel)) writeRecord();
    writing_.store(false, std::memory_order_release);
}

void FlightRecorder::writeRecord() {
    std::vector<TickFault> faults;
    while (const std::optional<TickFault> fault = raised_.take()) faults.push_back(*fault);
    if (faults.empty()) return;
    // The record includes a short time after the fault; if the loop is dead, nothing more will come.
    std::this_thread::sleep_for(interval);
    const double time = unixTime();
    const fs::path file = settings_.folder / fileName(time, faults.front());
    std::error_code failed;
    fs::create_directories(settings_.folder, failed);
    const bool written = writeFileAtomically(file, formatFlight(settings_, faults.front(), time, freeze())).hasValue();
    if (written) removeOldest(settings_.folder, settings_.keep);
    const std::lock_guard lock(mutex_);
    for (const TickFault fault : faults) reports_.push_back({fault, written ? file : fs::path()});
}

std::optional<FlightReport> FlightRecorder::take() {
    const std::lock_guard lock(mutex_);
    if (reports_.empty()) return std::nullopt;
    FlightReport report = std::move(reports_.front());
    reports_.erase(reports_.begin());
    return report;
}

} // namespace burin
