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

/// One run of the import program: a child process in a process group of its own, with limits on memory, processor time
/// and wall time. The destructor kills it together with all processes that it started. Use it only on the thread that
/// created it.
class WorkerProcess {
public:
    /// Starts `options.worker` with a request. @param subject the subject of its errors.
    /// Errors: fileNotFound (no such program), internalFault (the system refuses a process).
    static Result<WorkerProcess> start(const WorkerRequest& request, const ImportOptions& options, std::string subject);

    WorkerProcess(WorkerProcess&& other) noexcept;
    WorkerProcess& operator=(WorkerProcess&&) = delete;
    ~WorkerProcess();

    /// File descriptor that becomes readable when the program writes or ends; -1 once all output was read.
    int output() const noexcept { return output_; }
    /// Reads what the program wrote, and checks whether it ended or exceeded its limits. Never blocks.
    void advance();
    bool finished() const noexcept { return answer_.has_value(); }
    /// The newest progress; its fraction never decreases.
    const WorkerProgress& progress() const noexcept { return progress_; }
    /// Returns the preview; empty if there is none yet, or if it was taken already. A program sends at most one.
    std::optional<ModelPreview> takePreview() { return std::exchange(preview_, std::nullopt); }
    /// Returns the answer of the program, or the error that corresponds to how it ended. Call only when finished.
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
    WorkerProgress progress_;
    std::optional<ModelPreview> preview_;
    bool previewed_ = false;
    std::optional<WorkerAnswer> answer_;
};

/// Runs one program for each request, in parallel, until all have answered or one has failed. Returns the answers in
/// order of the requests. `progress` shows their mean and what the first one is doing, and stops them all when it is
/// cancelled; `show` receives the previews as they arrive.
Result<std::vector<WorkerAnswer>> runWorkers(const std::vector<WorkerRequest>& requests, const ImportOptions& options,
                                             const std::string& subject, Progress& progress,
                                             const PreviewSink& show = {});

} // namespace burin
