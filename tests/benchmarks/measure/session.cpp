// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/measure/session.h"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <unistd.h>

namespace burin::benchmarks {

namespace {

volatile std::sig_atomic_t stopRequested = 0; // a signal handler may access nothing else

extern "C" void wantStop(int) {
    stopRequested = 1;
}

} // namespace

Session::Session(std::string only) : only_(std::move(only)), terminal_(isatty(STDERR_FILENO) != 0) {
    std::signal(SIGINT, wantStop);
    std::signal(SIGTERM, wantStop);
}

bool Session::cancelled() noexcept {
    return stopRequested != 0;
}

void Session::throwIfCancelled() {
    if (cancelled()) throw Cancelled();
}

bool Session::wants(std::string_view stem) const noexcept {
    return stem.starts_with(only_) || std::string_view(only_).starts_with(stem);
}

void Session::stage(const std::string& title) {
    throwIfCancelled();
    if (!terminal_) return;
    clearLine();
    std::cerr << title << " ..." << std::flush;
}

void Session::add(Figure figure) {
    if (!figure.name.starts_with(only_)) return;
    const auto known = std::ranges::find(figures_, figure.name, &Figure::name);
    if (known == figures_.end())
        figures_.push_back(std::move(figure));
    else
        *known = std::move(figure);
}

double Session::least(const std::string& name, double time) {
    return least(name, std::vector<double>{time}).front();
}

std::vector<double> Session::least(const std::string& name, std::vector<double> times) {
    std::vector<double>& known = least_[name];
    if (known.empty())
        known = std::move(times);
    else
        std::ranges::transform(known, times, known.begin(), [](double a, double b) { return std::min(a, b); });
    return known;
}

void Session::check(bool holds, const std::string& fact) {
    if (holds) return;
    ++failed_;
    note("CHECK FAILED: " + fact);
}

void Session::note(const std::string& text) {
    clearLine();
    std::cerr << text << std::endl;
}

void Session::countMismatches(std::size_t properties) noexcept {
    recounted_ = true;
    mismatches_ += properties;
}

void Session::countInterruptions(std::size_t allocations, std::size_t pageFaults) noexcept {
    watched_ = true;
    allocations_ += allocations;
    pageFaults_ += pageFaults;
}

void Session::finish() {
    clearLine();
    // Whichever figures were requested, these say whether the ticks were correct.
    if (recounted_)
        figures_.push_back(figure("recount.mismatches", static_cast<double>(mismatches_), "properties", 0.0));
    check(mismatches_ == 0, "removed volume per property equals a full recount");
    if (!watched_) return;
    figures_.push_back(figure("tick.allocations", static_cast<double>(allocations_), "calls", 0.0));
    figures_.push_back(figure("tick.page_faults", static_cast<double>(pageFaults_), "faults", 0.0));
}

void Session::clearLine() const {
    if (terminal_) std::cerr << "\r\033[K" << std::flush;
}

} // namespace burin::benchmarks
