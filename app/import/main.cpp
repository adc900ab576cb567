// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-import: the child process in which Burin reads CAD files. It takes one request on standard input and answers on
// standard output, both in the format of core/cad/worker_message.h; Burin sets its limits.
#include "core/cad/reader/reader.h"
#include "core/cad/worker_message.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <new>
#include <string>
#include <string_view>
#include <sys/prctl.h>
#include <unistd.h>
#include <utility>

namespace {

int channel = -1; // output for answers; a plain integer, because the out-of-memory handler needs it

void send(std::string_view bytes) noexcept {
    while (!bytes.empty()) {
        const ssize_t written = ::write(channel, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) ::_exit(EXIT_FAILURE); // nobody reads any more
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

/// Reserves standard output for answers: anything that OpenCASCADE prints is discarded.
void takeOutput() {
    channel = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDOUT_FILENO);
    ::dup2(nowhere, STDERR_FILENO);
}

/// Once memory is exhausted no message can be composed: the answer is prepared at the start.
void answerWhenMemoryRunsOut() {
    static const std::string answer =
        burin::encodeFrame(burin::WorkerAnswer(burin::Error{burin::ErrorCode::importOutOfMemory, {}, {}, {}}));
    std::set_new_handler([] {
        send(answer);
        ::_exit(EXIT_FAILURE);
    });
}

std::string readInput() {
    std::string content;
    std::array<char, 1 << 16> buffer; // NOLINT: filled by read
    while (true) {
        const ssize_t size = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        if (size < 0 && errno == EINTR) continue;
        if (size <= 0) return content;
        content.append(buffer.data(), static_cast<std::size_t>(size));
    }
}

/// The progress that was sent last.
burin::WorkerProgress shown;

// Some hundred messages are enough.
constexpr double leastAdvance = 0.002;

void reportFraction(double fraction) {
    if (fraction < shown.fraction + leastAdvance && fraction < 1.0) return;
    shown.fraction = fraction;
    send(burin::encodeFrame(shown));
}

void reportStage(burin::ImportStage stage, double done, double total) {
    const bool same = stage == shown.stage && total == shown.total;
    if (same && done < shown.done + leastAdvance * total) return;
    shown.stage = stage;
    shown.done = done;
    shown.total = total;
    send(burin::encodeFrame(shown));
}

void sendPreview(const burin::ModelPreview& preview) {
    send(burin::encodeFrame(preview));
}

template <class T>
burin::WorkerAnswer toAnswer(burin::Result<T> result) {
    if (result) return std::move(*result);
    return std::move(result).error();
}

burin::WorkerAnswer answerTo(const burin::WorkerRequest& request) {
    if (const auto* read = std::get_if<burin::ReadRequest>(&request))
        return toAnswer(burin::readModel(*read, {reportFraction, sendPreview, reportStage}));
    if (const auto* edges = std::get_if<burin::EdgeRequest>(&request)) return toAnswer(burin::followEdges(*edges));
    if (const auto* face = std::get_if<burin::FaceRequest>(&request)) return toAnswer(burin::findFace(*face));
    if (const auto* measure = std::get_if<burin::MeasureRequest>(&request))
        return toAnswer(burin::measureFaces(*measure));
    if (const auto* patches = std::get_if<burin::PatchRequest>(&request))
        return toAnswer(burin::meshFaces(*patches, reportFraction));
    return toAnswer(burin::measureDistances(*std::get_if<burin::DistanceRequest>(&request), reportFraction));
}

} // namespace

int main() {
    if (::isatty(STDIN_FILENO) != 0) {
        std::cerr << "burin-import is started by Burin to read CAD files; use: burin import MODEL\n";
        return 2;
    }
    ::prctl(PR_SET_PDEATHSIG, SIGKILL); // never outlives the Burin process that started it
    takeOutput();
    answerWhenMemoryRunsOut();
    const auto request = burin::decodeRequest(readInput());
    if (!request) return 2;
    send(burin::encodeFrame(answerTo(*request)));
    ::_exit(EXIT_SUCCESS); // skips OpenCASCADE's clean-up, which is not needed
}
