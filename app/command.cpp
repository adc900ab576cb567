// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"

#include "ui/messages/messages.h"

#include <CLI/CLI.hpp>

#include <atomic>
#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>
#include <unistd.h>

namespace burin {

namespace {

Progress theProgress; // a signal handler can reach nothing else

extern "C" void stopWork(int) {
    theProgress.cancel();
}

} // namespace

/// Shows stage and progress in one line of a terminal, from a thread of its own, until it is destroyed.
class CommandContext::ProgressLine {
public:
    explicit ProgressLine(std::string title) : title_(std::move(title)), thread_([this] { show(); }) {}
    ~ProgressLine() {
        ended_ = true;
        thread_.join();
        std::cerr << "\r\033[K" << std::flush;
    }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

private:
    void show() {
        while (!ended_) {
            std::cerr << "\r\033[K" << title_ << "  " << static_cast<int>(theProgress.fraction() * 100.0) << " %"
                      << std::flush;
            for (int i = 0; i < 10 && !ended_; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }
    std::string title_;
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

CommandContext::CommandContext() {
    std::signal(SIGINT, stopWork);
    std::signal(SIGTERM, stopWork);
}

CommandContext::~CommandContext() = default;

Progress& CommandContext::progress() noexcept {
    return theProgress;
}

void CommandContext::stage(const std::string& title) {
    line_.reset();
    theProgress.stage(0.0, 1.0);
    if (isatty(STDERR_FILENO) != 0) line_ = std::make_unique<ProgressLine>(title);
}

void CommandContext::answer(const nlohmann::json& object, const std::string& text) {
    line_.reset();
    std::cout << (json ? object.dump(2) : text) << std::endl;
}

void CommandContext::message(const std::string& text) {
    line_.reset();
    std::cerr << text << std::endl;
}

int CommandContext::fail(const Error& error) {
    line_.reset();
    const std::string sentence = Messages::sentence(error).toStdString();
    std::cerr << sentence << std::endl;
    const int status = static_cast<int>(errorClass(error.code));
    if (json)
        std::cout << nlohmann::json{{"error",
                                     {{"sentence", sentence},
                                      {"status", status},
                                      {"subject", error.subject},
                                      {"place", error.place}}}}
                         .dump(2)
                  << std::endl;
    return status;
}

void addJsonFlag(CLI::App& command, CommandContext& context) {
    command.add_flag("--json", context.json, "Print one JSON object on standard output");
}

} // namespace burin
