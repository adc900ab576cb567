// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/job_evaluation.h"

#include <QPointer>

#include <algorithm>
#include <iterator>
#include <utility>

namespace burin {

namespace {

bool alike(const StoredPath& one, const StoredPath& other) {
    return one.name == other.name && one.sources == other.sources &&
           std::ranges::equal(one.edits, other.edits,
                              [](const Edit& a, const Edit& b) { return toJson(a) == toJson(b); });
}

/// Stores a path unless the project holds an equal one, so that a project that was only opened has no changes.
Result<void> keep(Project& project, const StoredPath& path) {
    const Result<std::vector<StoredPath>> kept = project.paths();
    if (!kept) return kept.error();
    const auto same = std::ranges::find(*kept, path.id, &StoredPath::id);
    if (same != kept->end() && alike(*same, path)) return {};
    return project.setPath(path);
}

/// Returns a path with newer recordings added, and what is needed to evaluate it.
Result<PathMatter> gather(Project& project, StoredPath path) {
    const Result<std::vector<SourceInfo>> sources = sourcesOf(project);
    if (!sources) return sources.error();
    addNewerTakes(path, *sources);
    if (const Result<void> done = keep(project, path); !done) return done.error();
    return matterOf(project, path);
}

} // namespace

JobEvaluation::JobEvaluation(const Desk& desk, WorkpieceController& workpiece, QObject* parent)
    : QObject(parent), desk_(desk), workpiece_(workpiece) {
    connect(&workpiece_, &WorkpieceController::readersStop, this, &JobEvaluation::readersStop);
    connect(&workpiece_, &WorkpieceController::readersGoOn, this, [this] {
        if (!workpiece_.changing() && std::exchange(interrupted_, false)) start();
    });
}

/// The running task is abandoned by the code that changes the workpiece. What it kept was made with the fixtures and
/// the materials that are about to change, possibly within the same extent.
void JobEvaluation::readersStop() {
    if (running_) interrupted_ = true;
    running_.reset();
    for (std::vector<Entry>* entries : {&entries_, &resting_})
        for (Entry& entry : *entries) entry.kept.reset();
}

void JobEvaluation::setJob(const std::vector<StoredPath>& inOrder, std::int64_t inForce) {
    std::vector<Entry> before = std::exchange(entries_, {});
    std::ranges::move(resting_, std::back_inserter(before));
    std::vector<Entry> entries;
    for (const StoredPath& path : inOrder) {
        Entry entry;
        const auto known = std::ranges::find(before, path.id, [](const Entry& each) { return each.path.id; });
        if (known != before.end()) {
            entry = std::move(*known);
            before.erase(known);
        }
        entry.path = path;
        if (path.id != inForce) forgetRecorded(entry); // takes are large; only those of one path are kept
        entries.push_back(std::move(entry));
    }
    entries_ = std::move(entries);
    resting_ = std::move(before);
    for (Entry& entry : resting_) forgetRecorded(entry);
    inForce_ = inForce;
}

void JobEvaluation::touch(std::int64_t path) {
    if (Entry* entry = find(path)) ++entry->revision;
}

void JobEvaluation::touchAll() {
    for (std::vector<Entry>* entries : {&entries_, &resting_})
        for (Entry& entry : *entries) {
            ++entry.revision;
            entry.kept.reset();
        }
}

void JobEvaluation::setRecorded(std::int64_t path, const RecordedKey& key) {
    Entry* entry = find(path);
    if (entry == nullptr || entry->key == key) return;
    entry->key = key;
    forgetRecorded(*entry);
}

void JobEvaluation::forget() {
    desk_.tasks.abandon(TaskKind::path);
    entries_.clear();
    resting_.clear();
    inForce_ = 0;
    running_.reset();
    ++loads_;
    wanted_ = reading_ = interrupted_ = false;
}

void JobEvaluation::start() {
    wanted_ = true;
    for (Entry& entry : entries_) entry.failedOn = {}; // tried again
    goOn();
}

std::size_t JobEvaluation::placeOf(std::int64_t path) const {
    const auto found = std::ranges::find(entries_, path, [](const Entry& entry) { return entry.path.id; });
    return static_cast<std::size_t>(found - entries_.begin());
}

const JobEvaluation::Entry* JobEvaluation::find(std::int64_t path) const {
    const std::size_t place = placeOf(path);
    return place < entries_.size() ? &entries_[place] : nullptr;
}

JobEvaluation::Entry* JobEvaluation::find(std::int64_t path) {
    const std::size_t place = placeOf(path);
    return place < entries_.size() ? &entries_[place] : nullptr;
}

std::shared_ptr<const EvaluatedPath> JobEvaluation::evaluated(std::int64_t path) const {
    const Entry* entry = find(path);
    return entry != nullptr ? entry->evaluated : nullptr;
}

std::vector<std::shared_ptr<const EvaluatedPath>> JobEvaluation::allBut(std::int64_t path) const {
    std::vector<std::shared_ptr<const EvaluatedPath>> all;
    for (const Entry& entry : entries_)
        if (entry.path.id != path && entry.evaluated) all.push_back(entry.evaluated);
    return all;
}

std::optional<Error> JobEvaluation::problem(std::int64_t path) const {
    const Entry* entry = find(path);
    return entry != nullptr ? entry->problem : std::nullopt;
}

bool JobEvaluation::isCurrent(std::int64_t path) const {
    const Entry* entry = find(path);
    return entry != nullptr && isSettledUpTo(path) && isCurrent(*entry, basisOf(*entry));
}

bool JobEvaluation::busy(std::int64_t path) const {
    const bool working = reading_ || running_ || interrupted_;
    return wanted_ && working && find(path) != nullptr && !isSettledUpTo(path);
}

/// Whether this path and all before it are settled.
bool JobEvaluation::isSettledUpTo(std::int64_t path) const {
    const std::size_t last = placeOf(path);
    for (std::size_t i = 0; i <= last && i < entries_.size(); ++i)
        if (!isSettled(entries_[i], basisOf(entries_[i]))) return false;
    return true;
}

bool JobEvaluation::isCurrent(const Entry& entry, const Basis& basis) const {
    return entry.evaluated && entry.evaluatedOn == basis;
}

bool JobEvaluation::isSettled(const Entry& entry, const Basis& basis) const {
    return isCurrent(entry, basis) || (entry.problem && entry.failedOn == basis);
}

/// Whether the path can't be evaluated in its present state.
bool JobEvaluation::isImpossible(const Entry& entry) {
    return entry.problem && entry.failedOn.revision == entry.revision && entry.failedOn.key == entry.key;
}

std::vector<std::int64_t> JobEvaluation::missingBefore(std::int64_t path) const {
    std::vector<std::int64_t> missing;
    if (find(path) == nullptr) return missing;
    for (std::size_t i = 0; i < placeOf(path); ++i)
        if (isImpossible(entries_[i])) missing.push_back(entries_[i].path.id);
    return missing;
}

/// Paths that can't be evaluated are not milled.
std::vector<MilledPath> JobEvaluation::milledBefore(const Entry& entry) const {
    std::vector<MilledPath> before;
    for (const Entry& each : entries_) {
        if (&each == &entry) break;
        if (each.evaluated && !isImpossible(each)) before.push_back({each.evaluated, each.tool});
    }
    return before;
}

JobEvaluation::Basis JobEvaluation::basisOf(const Entry& entry) const {
    Basis basis{entry.revision, entry.key, {}};
    for (const MilledPath& path : milledBefore(entry)) basis.before.push_back(path.evaluated);
    return basis;
}

/// Null if all entries are settled.
JobEvaluation::Entry* JobEvaluation::next() {
    for (Entry& entry : entries_)
        if (!isSettled(entry, basisOf(entry))) return &entry;
    return nullptr;
}

void JobEvaluation::goOn() {
    if (!wanted_ || reading_ || !workpiece_.milling()) return;
    if (workpiece_.changing()) { // evaluated after the change
        interrupted_ = next() != nullptr;
        return;
    }
    Entry* entry = next();
    if (entry == nullptr) return;
    const Basis basis = basisOf(*entry);
    if (running_ && running_->path == entry->path.id && running_->basis == basis) return;
    if (entry->recorded)
        evaluate(*entry, basis);
    else
        read(*entry);
}

void JobEvaluation::read(const Entry& entry) {
    reading_ = true;
    desk_.project.post([path = entry.path](Project& project) { return gather(project, path); },
                       [this, id = entry.path.id, asked = Basis{entry.revision, entry.key, {}},
                        load = loads_](Result<PathMatter> matter) {
                           if (load != loads_) return; // another project
                           reading_ = false;
                           takeRecorded(id, asked, std::move(matter));
                       });
    emit changed();
}

void JobEvaluation::takeRecorded(std::int64_t id, const Basis& asked, Result<PathMatter> matter) {
    if (matter) emit recordingsAdded(matter->path);
    Entry* entry = find(id);
    const bool asAsked = entry != nullptr && entry->revision == asked.revision && entry->key == asked.key;
    if (asAsked && matter) {
        forgetRecorded(*entry);
        entry->recorded =
            std::make_shared<const Recorded>(Recorded{std::move(matter->sources), std::move(matter->tool)});
    }
    if (asAsked && !matter) {
        entry->problem = matter.error();
        entry->failedOn = basisOf(*entry);
    }
    goOn();
    emit changed();
}

void JobEvaluation::forgetRecorded(Entry& entry) {
    entry.recorded.reset();
    entry.kept.reset();
}

/// Only the path in force keeps its states, as they are large.
std::shared_ptr<KeptEdits> JobEvaluation::keptOf(Entry& entry, const Before& before) const {
    if (entry.path.id != inForce_) return nullptr;
    const auto& milling = workpiece_.milling();
    if (!entry.kept || entry.keptOn.lock() != milling || entry.keptBehind != before) {
        entry.kept = std::make_shared<KeptEdits>();
        entry.keptOn = milling;
        entry.keptBehind = before;
    }
    return entry.kept;
}

void JobEvaluation::evaluate(Entry& entry, const Basis& basis) {
    running_ = Running{entry.path.id, basis};
    std::function<void(EvaluatedPath)> first;
    if (entry.evaluated && entry.path.id == inForce_)
        first = [tasks = &desk_.tasks, own = QPointer(this), asked = *running_](EvaluatedPath path) {
            auto shared = std::make_shared<const EvaluatedPath>(std::move(path));
            // The tasks outlive their work; this object may not.
            QMetaObject::invokeMethod(
                tasks,
                [own, asked, shared] {
                    if (own) own->takeFirst(asked, shared);
                },
                Qt::QueuedConnection);
        };
    desk_.tasks.start(
        TaskKind::path, tr("Editing the path"),
        [recorded = entry.recorded, workpiece = workpiece_.milling(), path = entry.path, before = milledBefore(entry),
         kept = keptOf(entry, basis.before), first](Progress& progress) {
            return evaluateStored({}, *workpiece, recorded->tool, path, before, progress,
                                  {kept.get(), first, &recorded->strokes});
        },
        [this, asked = *running_, tool = entry.recorded->tool](Result<EvaluatedPath> outcome) {
            takeEvaluated(asked, tool, std::move(outcome));
        });
    emit changed();
}

void JobEvaluation::takeFirst(const Running& asked, const std::shared_ptr<const EvaluatedPath>& path) {
    const bool stillAsked = running_ && running_->path == asked.path && running_->basis == asked.basis;
    if (stillAsked && asked.path == inForce_) emit firstResult(path);
}

void JobEvaluation::takeEvaluated(const Running& asked, const Tool& tool, Result<EvaluatedPath> outcome) {
    running_.reset();
    Entry* entry = find(asked.path);
    if (entry == nullptr) return;
    if (outcome) {
        entry->evaluated = std::make_shared<const EvaluatedPath>(std::move(*outcome));
        entry->tool = tool;
        entry->evaluatedOn = asked.basis;
        entry->problem.reset();
    } else {
        entry->problem = outcome.error();
        entry->failedOn = asked.basis;
        if (outcome.error().code == ErrorCode::cancelled) wanted_ = false; // evaluated again when the user starts it
    }
    if (entry->path.id != inForce_) forgetRecorded(*entry);
    const bool anew = entry->problem == std::nullopt;
    if (!anew && entry->evaluated && entry->path.id == inForce_) emit firstResult(entry->evaluated);
    goOn();
    if (anew) emit evaluatedAnew(asked.path);
    emit changed();
}

} // namespace burin
