// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/pass_refresher.h"

#include "core/path/stroke.h"

#include <algorithm>
#include <memory>

namespace burin {

/// What is needed to compute a pass again without the project.
struct PassRefresher::Matter {
    std::int64_t pass = 0;
    PassRequest request;
    std::vector<LeadTake> leads; ///< that lead it, as they are now
    std::vector<PathMatter> before;
};

namespace {

using Refreshed = std::vector<ReplacedPass>;

/// Computes passes one after the other; each stands on those computed before it.
template <class Matter>
Result<Refreshed> computedAgain(const MillingContext& milling, std::vector<Matter> matters, KeptLeads& leads,
                                Progress& progress) {
    Refreshed done;
    for (Matter& matter : matters) {
        const auto count = static_cast<double>(matters.size()), number = static_cast<double>(done.size());
        const ProgressPart part(progress, number / count, (number + 1.0) / count);
        for (PathMatter& path : matter.before)
            for (SourceStrokes& source : path.sources)
                for (const ReplacedPass& earlier : done) {
                    if (source.info.source.id != earlier.instead) continue;
                    Result<SourceStrokes> strokes = strokesOf(earlier.moves);
                    if (!strokes) return std::move(strokes).error();
                    strokes->info.source.id = earlier.instead; // its position in the path
                    source = std::move(*strokes);
                }
        const Result<PassRequest> request =
            ledAnew(std::move(matter.request), std::move(matter.leads), leads, progress);
        if (!request) return request.error();
        Result<ComputedPass> pass = computePass(milling, std::move(matter.before), *request, progress);
        if (!pass) return std::move(pass).error();
        done.push_back({std::move(pass->moves), matter.pass});
    }
    return done;
}

bool heedsStrokes(const GeneratedInfo& pass) {
    const Result<PassRequest> request = passRequestFromJson(pass.request, pass.name);
    return request && (!request->leads.empty() || request->hand != HandStrokes::ignore);
}

/// The title of its kind.
std::string titleOf(const GeneratedInfo& pass) {
    const Result<PassRequest> request = passRequestFromJson(pass.request, pass.name);
    return request ? rowOf(request->kind).title.text : pass.name;
}

} // namespace

PassRefresher::PassRefresher(const Desk& desk, const WorkpieceController& workpiece, PathController& path,
                             const ToolController& tools, std::shared_ptr<KeptLeads> leads, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path), tools_(tools), leads_(std::move(leads)) {
    connect(&path_, &PathController::changed, this, &PassRefresher::look);
    connect(&path_, &PathController::versionChanged, this, &PassRefresher::look);
    connect(&workpiece_, &Controller::changed, this, &PassRefresher::look);
    connect(&workpiece_, &WorkpieceController::readersStop, this, &PassRefresher::readersStop);
    connect(&desk_.tasks, &TaskRunner::changed, this, &PassRefresher::proceed);
}

bool PassRefresher::ready() const {
    return workpiece_.embedded() && workpiece_.milling() && !workpiece_.changing() &&
           workpiece_.milling()->tool.id == tools_.current().id;
}

bool PassRefresher::possible() const {
    return !busy() && !outdated_.empty() && ready() && path_.stored() != nullptr &&
           !desk_.tasks.running(TaskKind::pass);
}

/// Asks again when path or recordings have changed.
void PassRefresher::look() {
    const StoredPath* path = path_.stored();
    const std::optional<Key> key = path != nullptr ? std::optional<Key>({path->id, path_.version()}) : std::nullopt;
    if (key && looked_ == key) return;
    const bool any = key && std::ranges::any_of(path_.passes(), heedsStrokes);
    if (any && !ready()) return;
    looked_ = key;
    ++questions_;
    know({});
    if (!any) return drop();
    if (looking_) looking_->cancel();
    looking_ = std::make_shared<Progress>();
    desk_.project.ask([path = *path, leads = leads_, reading = looking_](
                          const Project& project) { return ledPasses(project, path, *leads, *reading); },
                      [this, question = questions_](Result<LedPasses> led) {
                          if (question != questions_) return;
                          if (led) return find(std::move(*led));
                          emit failed(led.error());
                          drop();
                      });
}

void PassRefresher::stopReading() {
    for (const std::shared_ptr<Progress>& reading : {looking_, collecting_})
        if (reading) reading->cancel();
}

void PassRefresher::find(LedPasses led) {
    if (!ready()) return looked_.reset(); // looked for again once it is
    desk_.tasks.start(
        TaskKind::outdated, tr("Looking for passes that are out of date"),
        [led = std::move(led), milling = workpiece_.milling(), leads = leads_](Progress& progress) mutable {
            return outdatedPasses(std::move(led), *milling, *leads, progress);
        },
        [this, question = questions_](const Result<std::vector<std::int64_t>>& outdated) {
            if (question != questions_) return;
            if (outdated) know(*outdated);
            if (outdated && !outdated->empty()) return proceed();
            if (!outdated && outdated.error().code != ErrorCode::cancelled) emit failed(outdated.error());
            drop();
        });
}

void PassRefresher::know(std::vector<std::int64_t> outdated) {
    if (outdated == outdated_) return;
    outdated_ = std::move(outdated);
    emit changed();
}

void PassRefresher::refresh() {
    if (!possible()) return;
    std::vector<GeneratedInfo> passes = path_.passes();
    std::erase_if(
        passes, [this](const GeneratedInfo& pass) { return std::ranges::find(outdated_, pass.id) == outdated_.end(); });
    if (passes.empty()) return;
    refreshing_ = true;
    tool_ = tools_.current().id;
    title_ = titleOf(passes.front());
    emit changed();
    collecting_ = std::make_shared<Progress>();
    desk_.project.ask(
        [passes = std::move(passes), path = *path_.stored(), leads = leads_,
         reading = collecting_](const Project& project) -> Result<std::vector<Matter>> {
            std::vector<Matter> matters;
            for (const GeneratedInfo& pass : passes) {
                Result<PassRequest> request = passRequestFromJson(pass.request, pass.name);
                if (!request) return std::move(request).error();
                Result<std::vector<LeadTake>> takes = readLeads(project, takesOf(*request), *leads, *reading);
                if (!takes) return std::move(takes).error();
                Result<std::vector<PathMatter>> before = pathsBeforePass(project, path, pass.toolId, *request, pass.id);
                if (!before) return std::move(before).error();
                matters.push_back({pass.id, std::move(*request), std::move(*takes), std::move(*before)});
            }
            return matters;
        },
        [this, load = loads_](Result<std::vector<Matter>> matters) {
            if (load != loads_) return; // stopped, or another project
            if (!matters) {
                emit failed(matters.error());
                return end();
            }
            // Meanwhile another tool may have been loaded, or another pass begun, which must not be superseded.
            const bool same = tools_.current().id == tool_ && !desk_.tasks.running(TaskKind::pass);
            ready() && same ? compute(std::move(*matters)) : putOff();
        });
}

void PassRefresher::putOff() {
    waiting_ = true;
    end();
    proceed();
}

/// Starts what was put off, as soon as that is possible.
void PassRefresher::proceed() {
    if (!waiting_ || refreshing_) return;
    if (tools_.current().id != tool_) {
        drop();
        emit failed({ErrorCode::pathEmpty, title_, {}, "another tool was loaded before it was computed"});
        return;
    }
    if (outdated_.empty() || !ready() || desk_.tasks.running(TaskKind::pass)) return;
    waiting_ = false;
    refresh();
}

void PassRefresher::drop() {
    if (std::exchange(waiting_, false)) emit changed();
}

void PassRefresher::compute(std::vector<Matter> matters) {
    desk_.tasks.start(
        TaskKind::pass, tr("Computing the passes that are out of date"),
        [milling = workpiece_.milling(), matters = std::move(matters), leads = leads_](Progress& progress) mutable {
            return computedAgain(*milling, std::move(matters), *leads, progress);
        },
        [this, load = loads_, tool = tools_.current()](const Result<Refreshed>& passes) {
            if (load != loads_) return; // another project, or another workpiece
            if (passes)
                path_.replacePasses(*passes, tool);
            else if (passes.error().code != ErrorCode::cancelled)
                emit failed(passes.error());
            end();
        });
}

void PassRefresher::end() {
    refreshing_ = false;
    emit changed();
}

/// The code that changes the workpiece abandons the task that computes, which then reports nothing. The passes stay
/// marked, and are computed when the workpiece is ready again.
void PassRefresher::readersStop() {
    ++questions_;
    looked_.reset();
    stopReading();
    desk_.tasks.abandon(TaskKind::outdated);
    if (!refreshing_) return;
    ++loads_;
    waiting_ = true;
    end();
}

void PassRefresher::forget() {
    ++questions_;
    ++loads_;
    looked_.reset();
    outdated_.clear();
    waiting_ = false;
    stopReading();
    desk_.tasks.abandon(TaskKind::outdated);
    end();
}

} // namespace burin
