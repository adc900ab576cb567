// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/cad/worker_process.h"

#include "core/base/file.h"
#include "core/base/numbers.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

extern char** environ; // NOLINT: declared by POSIX, in no header

namespace burin {

namespace fs = std::filesystem;

namespace {

constexpr int pollMilliseconds = 20;

fs::path workerProgram(const ImportOptions& options) {
    if (!options.worker.empty()) return options.worker;
    const fs::path here = executableDirectory();
    std::error_code ignored;
    for (const fs::path& folder : {here / "../lib/burin", here, here / ".."})
        if (fs::exists(folder / "burin-import", ignored)) return folder / "burin-import";
    return here / "burin-import";
}

void closeDescriptor(int& descriptor) noexcept {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
}

/// Writes the request to an anonymous file in memory, complete from the start, so that no pipe has to be fed.
int requestDescriptor(const WorkerRequest& request) {
    const std::string bytes = encodeRequest(request);
    int descriptor = ::memfd_create("burin-request", MFD_CLOEXEC);
    std::size_t done = 0;
    while (descriptor >= 0 && done < bytes.size()) {
        const ssize_t written = ::write(descriptor, bytes.data() + done, bytes.size() - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0)
            closeDescriptor(descriptor);
        else
            done += static_cast<std::size_t>(written);
    }
    if (descriptor >= 0) ::lseek(descriptor, 0, SEEK_SET);
    return descriptor;
}

/// Settings of a new process: a process group and signals of its own, the request as input, the pipe as output, no
/// error output.
class SpawnPlan {
public:
    SpawnPlan(int input, int output) {
        ::posix_spawn_file_actions_init(&actions_);
        ::posix_spawn_file_actions_adddup2(&actions_, input, STDIN_FILENO);
        ::posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        ::posix_spawn_file_actions_addopen(&actions_, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        ::posix_spawnattr_init(&attributes_);
        sigset_t none, all;
        ::sigemptyset(&none);
        ::sigfillset(&all);
        ::posix_spawnattr_setsigmask(&attributes_, &none);
        ::posix_spawnattr_setsigdefault(&attributes_, &all);
        ::posix_spawnattr_setpgroup(&attributes_, 0);
        ::posix_spawnattr_setflags(&attributes_,
                                   POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
    }
    ~SpawnPlan() {
        ::posix_spawn_file_actions_destroy(&actions_);
        ::posix_spawnattr_destroy(&attributes_);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    /// Starts the process; returns zero, or the system's error.
    int start(const std::string& program, pid_t& process) const {
        std::string name = program;
        std::array<char*, 2> arguments{name.data(), nullptr};
        return ::posix_spawn(&process, program.c_str(), &actions_, &attributes_, arguments.data(), environ);
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

void limit(pid_t process, __rlimit_resource resource, rlim_t soft, rlim_t hard) {
    const rlimit limits{soft, hard};
    ::prlimit(process, resource, &limits, nullptr);
}

/// Sets the limits from outside, so that they hold for any program that is started. The system's own limit of processor
/// time counts whole seconds; it is needed if the caller is stopped or killed.
void setLimits(pid_t process, const ImportLimits& limits) {
    limit(process, RLIMIT_CORE, 0, 0);
    // At the soft limit SIGXCPU ends the process, which identifies the cause; SIGKILL at the hard limit would not.
    const auto seconds = static_cast<rlim_t>(std::ceil(std::max(limits.seconds, 0.0))) + 1;
    limit(process, RLIMIT_CPU, seconds, seconds + 1);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // their shadow memory alone is terabytes
    limit(process, RLIMIT_AS, limits.memoryBytes, limits.memoryBytes);
#endif
}

/// Processor time used by a running process, s; zero if the system does not report it.
double processorSeconds(pid_t process) {
    clockid_t clock{};
    timespec used{};
    if (process <= 0 || ::clock_getcpuclockid(process, &clock) != 0 || ::clock_gettime(clock, &used) != 0) return 0.0;
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

} // namespace

Result<WorkerProcess> WorkerProcess::start(const WorkerRequest& request, const ImportOptions& options,
                                           std::string subject) {
    const fs::path program = workerProgram(options);
    std::array<int, 2> pipe{-1, -1};
    int input = requestDescriptor(request);
    if (input < 0 || ::pipe2(pipe.data(), O_CLOEXEC) != 0) {
        const int reason = errno;
        closeDescriptor(input);
        return Error{ErrorCode::internalFault, program.string(), {}, std::strerror(reason)};
    }
    WorkerProcess worker;
    const int failed = SpawnPlan(input, pipe[1]).start(program.string(), worker.process_);
    closeDescriptor(input);
    closeDescriptor(pipe[1]);
    worker.output_ = pipe[0];
    if (failed != 0) {
        worker.process_ = -1;
        const ErrorCode code = failed == ENOENT ? ErrorCode::fileNotFound : ErrorCode::internalFault;
        return Error{code, program.string(), {}, std::strerror(failed)};
    }
    setLimits(worker.process_, options.limits);
    ::fcntl(worker.output_, F_SETFL, O_NONBLOCK);
    worker.subject_ = std::move(subject);
    worker.limits_ = options.limits;
    worker.deadline_ = std::chrono::steady_clock::now() +
                       std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                           std::chrono::duration<double>(std::clamp(options.limits.waitSeconds, 0.0, 1e8)));
    return worker;
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : subject_(std::move(other.subject_))
    , limits_(other.limits_)
    , deadline_(other.deadline_)
    , process_(std::exchange(other.process_, -1))
    , output_(std::exchange(other.output_, -1))
    , frames_(std::move(other.frames_))
    , progress_(other.progress_)
    , preview_(std::move(other.preview_))
    , previewed_(other.previewed_)
    , answer_(std::move(other.answer_)) {}

WorkerProcess::~WorkerProcess() {
    stop();
}

void WorkerProcess::stop() noexcept {
    closeDescriptor(output_);
    if (process_ <= 0) return;
    ::kill(-process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
    process_ = -1;
}

void WorkerProcess::finish(WorkerAnswer answer) {
    if (auto* error = std::get_if<Error>(&answer)) {
        if (error->subject.empty()) error->subject = subject_;
        if (error->code == ErrorCode::importOutOfMemory)
            error->place = std::to_string(limits_.memoryBytes >> 20U) + " MiB";
    }
    answer_ = std::move(answer);
    stop();
}

Error WorkerProcess::outOfProcessorTime() const {
    return {ErrorCode::importTimedOut, subject_, formatShortest(limits_.seconds) + " s", {}};
}

Error WorkerProcess::crashed(std::string detail) const {
    return {ErrorCode::importCrashed, subject_, {}, std::move(detail)};
}

void WorkerProcess::advance() {
    if (!finished()) readOutput();
    if (!finished() && output_ < 0) checkEnd();
    if (!finished()) checkTime();
}

void WorkerProcess::checkTime() {
    if (processorSeconds(process_) >= limits_.seconds) return finish(outOfProcessorTime());
    if (std::chrono::steady_clock::now() >= deadline_)
        finish(Error{ErrorCode::importTimedOut, subject_, formatShortest(limits_.waitSeconds) + " s", "no answer"});
}

void WorkerProcess::readOutput() {
    std::array<char, 1 << 16> buffer; // NOLINT: filled by read
    // Limited in each call, so that cancelling and time limits still work while a program writes endlessly.
    for (int turn = 0; turn < 64 && output_ >= 0 && !finished(); ++turn) {
        const ssize_t size = ::read(output_, buffer.data(), buffer.size());
        if (size < 0 && errno == EINTR) continue;
        if (size < 0 && errno == EAGAIN) break;
        if (size <= 0) {
            closeDescriptor(output_);
            break;
        }
        frames_.append({buffer.data(), static_cast<std::size_t>(size)});
        readFrames();
    }
}

void WorkerProcess::readFrames() {
    while (!finished()) {
        std::optional<WorkerFrame> frame = frames_.next();
        if (frames_.damaged())
            finish(crashed("its answer is damaged"));
        else if (frames_.waitingBytes() > limits_.memoryBytes)
            finish(crashed("its answer has no end"));
        if (!frame || finished()) return;
        if (const auto* progress = std::get_if<WorkerProgress>(&*frame)) {
            const double before = progress_.fraction;
            progress_ = *progress;
            progress_.fraction = std::max(before, progress_.fraction);
        } else if (auto* preview = std::get_if<ModelPreview>(&*frame)) {
            if (!std::exchange(previewed_, true)) preview_ = std::move(*preview);
        } else
            finish(std::move(*std::get_if<WorkerAnswer>(&*frame)));
    }
}

void WorkerProcess::checkEnd() {
    int status = 0;
    const pid_t ended = ::waitpid(process_, &status, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR)) return;
    ::kill(-process_, SIGKILL); // any processes that it started
    process_ = -1;
    if (ended > 0 && WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return finish(outOfProcessorTime());
    if (ended > 0 && WIFSIGNALED(status))
        return finish(
            crashed("signal " + std::to_string(WTERMSIG(status)) + " (" + ::strsignal(WTERMSIG(status)) + ")"));
    finish(crashed(ended > 0 ? "exit status " + std::to_string(WEXITSTATUS(status)) + " without an answer"
                             : "its end was lost"));
}

namespace {

void waitForOutput(const std::vector<WorkerProcess>& workers) {
    std::vector<pollfd> waits;
    for (const WorkerProcess& worker : workers)
        if (worker.output() >= 0) waits.push_back({worker.output(), POLLIN, 0});
    ::poll(waits.data(), waits.size(), pollMilliseconds);
}

/// Returns whether all have answered; an error as soon as there is one.
Result<bool> advanceAll(std::vector<WorkerProcess>& workers, std::vector<std::optional<WorkerAnswer>>& answers,
                        Progress& progress, const PreviewSink& show) {
    double fractions = 0.0;
    bool all = true;
    for (std::size_t i = 0; i < workers.size(); ++i) {
        workers[i].advance();
        if (std::optional<ModelPreview> preview = workers[i].takePreview(); preview && show) show(std::move(*preview));
        if (workers[i].finished() && !answers[i]) answers[i] = workers[i].takeAnswer();
        if (answers[i])
            if (auto* error = std::get_if<Error>(&*answers[i])) return std::move(*error);
        all = all && answers[i].has_value();
        fractions += answers[i] ? 1.0 : workers[i].progress().fraction;
    }
    progress.report(fractions / static_cast<double>(workers.size()));
    const WorkerProgress& first = workers.front().progress();
    progress.describe(textOf(first.stage), first.done, first.total);
    return all;
}

} // namespace

Result<std::vector<WorkerAnswer>> runWorkers(const std::vector<WorkerRequest>& requests, const ImportOptions& options,
                                             const std::string& subject, Progress& progress, const PreviewSink& show) {
    std::vector<WorkerProcess> workers;
    for (const WorkerRequest& request : requests) {
        Result<WorkerProcess> worker = WorkerProcess::start(request, options, subject);
        if (!worker) return std::move(worker).error();
        workers.push_back(std::move(*worker));
    }
    std::vector<std::optional<WorkerAnswer>> answers(workers.size());
    while (true) {
        if (progress.cancelled()) return Error{ErrorCode::cancelled, subject, {}, {}};
        Result<bool> all = advanceAll(workers, answers, progress, show);
        if (!all) return std::move(all).error();
        if (*all) break;
        waitForOutput(workers);
    }
    std::vector<WorkerAnswer> ordered;
    for (std::optional<WorkerAnswer>& answer : answers) ordered.push_back(std::move(*answer));
    return ordered;
}

} // namespace burin
