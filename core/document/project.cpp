// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/project.h"

#include "core/document/opening.h"
#include "core/document/project_impl.h"
#include "core/document/saving.h"
#include "core/document/stores.h"

#include <system_error>
#include <utility>

namespace burin {

namespace fs = std::filesystem;

namespace {

/// Returns the same name for the same file, however it was specified: the working copy and its lock are next to it.
fs::path plainName(const fs::path& file) {
    std::error_code failed;
    const fs::path whole = fs::absolute(file, failed);
    fs::path plain = fs::weakly_canonical(whole, failed);
    return failed ? whole : plain;
}

} // namespace

Project::Project(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Project::~Project() = default;
Project::Project(Project&&) noexcept = default;
Project& Project::operator=(Project&&) noexcept = default;

Result<Project> Project::create(const fs::path& file) {
    fs::path plain = plainName(file);
    Result<OpenedCopy> opened = createWorkingCopy(plain);
    if (!opened) return std::move(opened).error();
    return Project(std::make_unique<Impl>(std::move(plain), std::move(*opened)));
}

Result<Project> Project::open(const fs::path& file) {
    fs::path plain = plainName(file);
    Result<OpenedCopy> opened = openWorkingCopy(plain);
    if (!opened) return std::move(opened).error();
    Project project(std::make_unique<Impl>(std::move(plain), std::move(*opened)));
    if (!project.readOnly())
        if (Result<void> erased = project.impl_->note([](Database& database) { return eraseHiddenTakes(database); });
            !erased)
            return std::move(erased).error();
    return project;
}

Result<Project> Project::openForReading(const fs::path& file) {
    fs::path plain = plainName(file);
    Result<OpenedCopy> opened = burin::openForReading(plain);
    if (!opened) return std::move(opened).error();
    return Project(std::make_unique<Impl>(std::move(plain), std::move(*opened)));
}

const fs::path& Project::file() const noexcept {
    return impl_->file;
}
bool Project::recovered() const noexcept {
    return impl_->recovered;
}
const fs::path& Project::keptAside() const noexcept {
    return impl_->keptAside;
}
const fs::path& Project::keptEarlier() const noexcept {
    return impl_->keptEarlier;
}
bool Project::readOnly() const noexcept {
    return impl_->copy == nullptr;
}

Result<bool> Project::unsaved() const {
    const Result<DocumentState> state = documentState(impl_->database);
    if (!state) return state.error();
    return state->unsaved() && state->changes != impl_->savedChanges;
}

Result<void> Project::save() {
    return save({});
}

Result<void> Project::save(std::span<StagedFile> outputs) {
    if (readOnly()) return Error{ErrorCode::fileNotWritable, impl_->file.string(), {}, "open for reading alone"};
    Result<SavedSnapshot> saved = saveSnapshot(impl_->database, impl_->file, outputs);
    if (!saved) return std::move(saved).error();
    impl_->savedChanges = saved->changes;
    impl_->keptEarlier = std::move(saved->keptEarlier);
    return {};
}

Result<void> Project::saveAs(const fs::path& file) {
    fs::path plain = plainName(file);
    if (plain == impl_->file && !readOnly()) return save();
    if (impl_->copy.use_count() > 1) // a TakeWriter also uses it, and would continue with the old file
        return Error{ErrorCode::argumentInvalid, "take", {}, "no take under way"};
    if (readOnly())
        if (Result<void> writable = impl_->database.execute("PRAGMA query_only = OFF"); !writable) return writable;
    Result<OpenedCopy> opened = saveUnderAnotherName(impl_->database, plain);
    if (!opened) {
        if (readOnly()) static_cast<void>(impl_->database.execute("PRAGMA query_only = ON"));
        return std::move(opened).error();
    }
    if (!readOnly()) impl_->copy->abandon(); // everything in it is in the new file
    impl_->step.reset();
    impl_->database = std::move(opened->database); // the old connection must be closed before its working copy is
                                                   // removed
    impl_->copy = std::move(opened->copy);
    impl_->lock.reset();
    impl_->file = std::move(plain);
    impl_->recovered = false;
    impl_->savedChanges.reset();
    impl_->keptAside = std::move(opened->keptAside);
    return {};
}

Result<void> Project::beginStep() {
    impl_->step.reset();
    Result<StepRecorder> recorder = StepRecorder::begin(impl_->database);
    if (!recorder) return std::move(recorder).error();
    impl_->step = std::move(*recorder);
    return {};
}
Result<std::shared_ptr<const ProjectStep>> Project::endStep() {
    if (!impl_->step) return std::shared_ptr<const ProjectStep>();
    Result<std::shared_ptr<const ProjectStep>> step = impl_->step->end(impl_->file);
    impl_->step.reset();
    return step;
}
Result<std::shared_ptr<const ProjectStep>> Project::revert(const ProjectStep& step) {
    if (readOnly()) return Error{ErrorCode::fileNotWritable, impl_->file.string(), {}, "open for reading alone"};
    Result<StepRecorder> recorder = StepRecorder::begin(impl_->database);
    if (!recorder) return std::move(recorder).error();
    return impl_->change([&](Database& database) -> Result<std::shared_ptr<const ProjectStep>> {
        if (Result<void> reverted = revertRows(database, step); !reverted) return std::move(reverted).error();
        if (Result<void> removed = removeOrphans(database); !removed) return std::move(removed).error();
        return recorder->end(impl_->file);
    });
}

void Project::abandonChanges() noexcept {
    if (!readOnly()) impl_->copy->abandon();
}

Result<Take> Project::take(std::int64_t id) const {
    return impl_->read([id](Database& database) { return loadTake(database, id); });
}
Result<TakeOutline> Project::takeOutline(std::int64_t id) const {
    return impl_->read([id](Database& database) { return loadTakeOutline(database, id); });
}
Result<void> Project::visitSamples(std::int64_t id, const SampleVisitor& visit) const {
    return impl_->read([&](Database& database) { return burin::visitSamples(database, id, visit); });
}
Result<void> Project::setSwitchedOff(std::int64_t take, std::span<const SampleRange> off) {
    return impl_->change([&](Database& database) { return storeSwitchedOff(database, take, off); });
}
Result<std::vector<SampleRange>> Project::switchedOff(std::int64_t take) const {
    return impl_->read([&](Database& database) { return loadSwitchedOff(database, take, ~std::uint64_t{0}); });
}
Result<std::vector<SampleRange>> Project::takenBack(std::int64_t take) const {
    return impl_->read([&](Database& database) { return loadTakenBack(database, take, ~std::uint64_t{0}); });
}
Result<void> Project::nameTake(std::int64_t take, const std::string& name) {
    return impl_->change([&](Database& database) { return renameTake(database, take, name); });
}
Result<Sample> Project::sample(std::int64_t take, std::uint64_t index) const {
    return impl_->read([&](Database& database) { return loadSample(database, take, index); });
}
Result<std::int64_t> Project::duplicateTake(std::int64_t id) {
    return impl_->change([id](Database& database) { return copyTake(database, id); });
}
Result<void> Project::removeTake(std::int64_t id) {
    return impl_->change([id](Database& database) { return hideTake(database, id); });
}
Result<void> Project::restoreTake(std::int64_t id) {
    return impl_->change([id](Database& database) { return showTake(database, id); });
}

Result<void> Project::undoInterval(std::int64_t take, const SampleRange& interval) {
    return impl_->change([&](Database& database) { return storeUndone(database, take, interval); });
}
Result<void> Project::redoInterval(std::int64_t take, const SampleRange& interval) {
    return impl_->change([&](Database& database) { return eraseUndone(database, take, interval); });
}

Result<Project::TakeWriter> Project::beginTake(const TakeInfo& info) {
    if (readOnly()) return Error{ErrorCode::fileNotWritable, impl_->file.string(), {}, "open for reading alone"};
    TakeInfo meant = info;
    meant.setup = impl_->meant(info.setup);
    return TakeWriter::begin(impl_->copy, meant);
}

} // namespace burin
