// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/result.h"
#include "core/cad/import.h"
#include "core/cad/worker_message.h"

#include <chrono>
#include <sys/types.h>
#include <utility>

namespace burin {

/// One run of the import program: a child process in a group of its own, with limits on memory, processor time and wall
/// time. It is killed, with all that it started, when the object goes. Thread: the one that made it.
class WorkerProcess {
public:
    /// Starts `options.worker` on a request. `subject` is what its errors name.
    /// Errors: fileNotFound (no such program), internalFault (the system refuses a process).
    static Result<WorkerProcess> start(const WorkerRequest& request, const ImportOptions& options, std::string subject);

    WorkerProcess(WorkerProcess&& other) noexcept;
    WorkerProcess& operator=(WorkerProcess&&) = delete;
    ~WorkerProcess();

    /// Descriptor that becomes readable when the program writes or ends; -1 once it wrote all.
    int output() const noexcept { return output_; }
    /// Takes in what the program wrote, and notices its end and its limits. Never waits.
    void advance();
    bool finished() const noexcept { return answer_.has_value(); }
    double fraction() const noexcept { return fraction_; }
    /// What there is to see before the answer; nothing: not yet, or taken. One alone is ever given.
    std::optional<ModelPreview> takePreview() { return std::exchange(preview_, std::nullopt); }
    /// What the program answered, or the error that its end means. Call when finished.
    WorkerAnswer takeAnswer() { return std::move(*answer_); }

private:
    WorkerProcess() = default;
    void readOutput();
    void readFrames();
    void checkEnd();
    void finish(WorkerAnswer answer);
    void stop() noexcept;
    void checkTime();
    Error outOfProcessorTime() const;
    Error crashed(std::string detail) const;

    std::string subject_;
    ImportLimits limits_;
    std::chrono::steady_clock::time_point deadline_; ///< of the wall time
    pid_t process_ = -1;
    int output_ = -1;
    FrameReader frames_;
    double fraction_ = 0.0;
    std::optional<ModelPreview> preview_;
    bool previewed_ = false;
    std::optional<WorkerAnswer> answer_;
};

/// Runs one program for each request, side by side, until all have answered or one has failed; the answers in order.
/// `progress` shows their mean and stops them all when it is cancelled; `show` gets previews as they come.
Result<std::vector<WorkerAnswer>> runWorkers(const std::vector<WorkerRequest>& requests, const ImportOptions& options,
                                             const std::string& subject, Progress& progress,
                                             const PreviewSink& show = {});

} // namespace burin
