// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "app/command.h"

#include "app/wording.h"
#include "core/base/clean_text.h"
#include "core/base/numbers.h"
#include "core/document/project.h"
#include "ui/messages/messages.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <iostream>
#include <mutex>
#include <semaphore.h>
#include <thread>
#include <unistd.h>

namespace burin {

namespace {

Progress theProgress; // global, as a signal handler cannot access anything else

sem_t stopAsked;

extern "C" void stopWork(int) {
    theProgress.cancel();
    sem_post(&stopAsked);
}

/// File names need not be UTF-8.
std::string written(const nlohmann::json& object) {
    return object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// What the work is doing, to follow its percentage; amounts as whole numbers if the total is one.
std::string wordsOf(const ProgressStep& step) {
    if (*step.text.text == '\0') return {};
    const int decimals = step.total == std::floor(step.total) ? 0 : 1;
    return "  " + worded(step.text, {formatFixed(step.done, decimals), formatFixed(step.total, decimals)});
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
                      << wordsOf(theProgress.step()) << std::flush;
            for (int i = 0; i < 10 && !ended_; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(20));
        }
    }
    std::string title_;
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

/// Waits for a request to stop, and ends the program if its work does not stop by itself.
class CommandContext::Ender {
public:
    Ender() : thread_([this] { watch(); }) {}
    ~Ender() {
        ended_ = true;
        sem_post(&stopAsked);
        thread_.join();
    }
    Ender(const Ender&) = delete;
    Ender& operator=(const Ender&) = delete;

    void work(const std::string& title) {
        const std::lock_guard guard(mutex_);
        title_ = title;
    }

private:
    static constexpr std::chrono::milliseconds patience{800};

    void watch() {
        while (sem_wait(&stopAsked) != 0) {
        }
        const auto end = std::chrono::steady_clock::now() + patience;
        while (!ended_ && std::chrono::steady_clock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        if (ended_) return;
        abandonStagedFiles();
        const std::lock_guard guard(mutex_);
        const std::string sentence = Messages::sentence({ErrorCode::cancelled, title_, {}, {}}).toStdString() + "\n";
        static_cast<void>(!::write(STDERR_FILENO, sentence.data(), sentence.size()));
        ::_exit(static_cast<int>(ErrorClass::cancelled));
    }
    std::mutex mutex_;
    std::string title_ = "burin";
    std::atomic<bool> ended_{false};
    std::thread thread_;
};

CommandContext::CommandContext() {
    sem_init(&stopAsked, 0, 0);
    ender_ = std::make_unique<Ender>();
    std::signal(SIGINT, stopWork);
    std::signal(SIGTERM, stopWork);
}

CommandContext::~CommandContext() = default;

Progress& CommandContext::progress() noexcept {
    return theProgress;
}

void CommandContext::stage(TextId title) {
    const std::string words = worded(title);
    line_.reset();
    theProgress.stage(0.0, 1.0);
    ender_->work(words);
    if (isatty(STDERR_FILENO) != 0) line_ = std::make_unique<ProgressLine>(words);
}

void CommandContext::answer(const nlohmann::json& object, const std::string& text) {
    line_.reset();
    std::cout << (json ? written(object) : cleanText(text)) << std::endl;
}

void CommandContext::message(const std::string& text) {
    line_.reset();
    std::cerr << cleanText(text) << std::endl;
}

int CommandContext::fail(const Error& error, const QString& standing) {
    line_.reset();
    QString words = Messages::sentence(error);
    if (!standing.isEmpty()) words = words.chopped(1) + " (" + standing + ").";
    const std::string sentence = cleanText(words.toStdString());
    std::cerr << sentence << std::endl;
    const int status = static_cast<int>(errorClass(error.code));
    if (json)
        std::cout
            << written(
                   {{"error",
                     {{"sentence", sentence}, {"status", status}, {"subject", error.subject}, {"place", error.place}}}})
            << std::endl;
    return status;
}

void tellKeptEarlier(CommandContext& context, const Project& project) {
    if (project.keptEarlier().empty()) return;
    context.message(
        QCoreApplication::translate(
            "Command", "An earlier version of Burin saved this project; the previous file is kept as \"%1\".")
            .arg(QString::fromStdString(project.keptEarlier().string()))
            .toStdString());
}

QString standingOutputs(std::span<const StagedFile> outputs) {
    QStringList words;
    for (const StagedFile& output : outputs)
        if (output.stands())
            words << QString::fromStdString(
                worded(BURIN_TEXT("Command", "\"%1\" was written already"), {output.file().string()}));
    return words.join("; ");
}

void addJsonFlag(CommandParser command, CommandContext& context) {
    command.flag("--json", context.json, BURIN_TEXT("Help", "Print one JSON object on standard output"));
}

} // namespace burin
