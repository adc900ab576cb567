// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/workbench/pass_previewer.h"

#include <algorithm>
#include <utility>

namespace burin {

namespace {

constexpr double usualAllowance = 1.0; // mm: a basis that is fine up to this allowance suits most passes

} // namespace

PassPreviewer::PassPreviewer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path,
                             const ToolController& tools, std::shared_ptr<KeptLeads> kept, QObject* parent)
    : Controller(desk, parent), workpiece_(workpiece), path_(path), tools_(tools), kept_(std::move(kept)) {
    connect(&workpiece_, &WorkpieceController::readersStop, this, &PassPreviewer::readersStop);
    connect(&workpiece_, &WorkpieceController::readersGoOn, this, &PassPreviewer::goOn);
}

void PassPreviewer::show(const RequestedPass& wanted) {
    wanted_ = wanted;
    problem_.reset();
    goOn();
}

void PassPreviewer::clear() {
    wanted_.reset();
    preview_.reset();
    problem_.reset();
    desk_.tasks.abandon(TaskKind::preview);
    emit changed();
}

void PassPreviewer::end() {
    ++questions_;
    asked_ = false;
    if (reading_) reading_->cancel();
    basis_.reset();
    lines_.clear();
    desk_.tasks.abandon(TaskKind::previewBasis);
    clear();
}

/// Starts the next missing step.
void PassPreviewer::goOn() {
    if (!wanted_ || asked_ || !workpiece_.milling() || workpiece_.changing() ||
        workpiece_.milling()->tool.id != tools_.current().id)
        return;
    const auto unknown =
        std::ranges::find_if(wanted_->leads, [this](std::int64_t take) { return !lines_.contains(take); });
    if (unknown != wanted_->leads.end())
        askLines(*unknown);
    else if (!basis_ || basis_->allowance < wanted_->request.allowance || (heedsHand() && !basis_->handStrokes))
        makeBasis();
    else
        plan();
}

void PassPreviewer::fail(const Error& error) {
    asked_ = false;
    wanted_.reset();
    preview_.reset();
    if (error.code != ErrorCode::cancelled) problem_ = error;
    emit changed();
}

/// What is under way is begun again when the workpiece has changed.
void PassPreviewer::readersStop() {
    ++questions_;
    asked_ = false;
    if (reading_) reading_->cancel();
    basis_.reset();
    desk_.tasks.abandon(TaskKind::previewBasis);
    desk_.tasks.abandon(TaskKind::preview);
}

void PassPreviewer::askLines(std::int64_t take) {
    asked_ = true;
    reading_ = std::make_shared<Progress>();
    const auto smooth = [this, take, question = questions_](Result<LeadTake> lead) {
        if (question != questions_) return;
        if (!lead) return fail(lead.error());
        desk_.tasks.start(
            TaskKind::previewBasis, tr("Preparing the preview"),
            [lead = std::move(*lead), kept = kept_](Progress& progress) mutable {
                return linesOf(std::move(lead), *kept, progress);
            },
            [this, take, question](const Result<LeadLines>& lines) {
                if (question != questions_) return;
                if (!lines) return fail(lines.error());
                asked_ = false;
                lines_[take] = *lines;
                goOn();
            });
    };
    desk_.project.ask([take, kept = kept_,
                       reading = reading_](const Project& project) { return readLead(project, take, *kept, *reading); },
                      smooth);
}

void PassPreviewer::makeBasis() {
    asked_ = true;
    const StoredPath path = path_.stored() != nullptr ? *path_.stored() : StoredPath{};
    const double allowance = std::max(usualAllowance, wanted_->request.allowance);
    const auto begin = [this, allowance, question = questions_](Result<std::vector<PathMatter>> before) {
        if (question != questions_) return;
        if (!before) return fail(before.error());
        desk_.tasks.start(
            TaskKind::previewBasis, tr("Preparing the preview"),
            [milling = workpiece_.milling(), before = std::move(*before), allowance,
             heeds = heedsHand()](Progress& progress) mutable -> Result<std::shared_ptr<const PassBasis>> {
                Result<PassBasis> basis = passBasis(*milling, std::move(before), allowance, heeds, progress);
                if (!basis) return std::move(basis).error();
                return std::make_shared<const PassBasis>(std::move(*basis));
            },
            [this, question](const Result<std::shared_ptr<const PassBasis>>& basis) {
                if (question != questions_) return;
                if (!basis) return fail(basis.error());
                asked_ = false;
                basis_ = *basis;
                goOn();
            });
    };
    desk_.project.ask(
        [path, tool = tools_.current().id, wanted = *wanted_](const Project& project) {
            return pathsBeforePass(project, path, tool, wanted.request, wanted.instead);
        },
        begin);
}

void PassPreviewer::plan() {
    PassRequest request = wanted_->request;
    std::vector<TakeLines> takes;
    for (const std::int64_t take : wanted_->leads) takes.push_back({take, lines_[take]});
    leadBy(takes, request);
    leads_ = request.lines;
    desk_.tasks.start(
        TaskKind::preview, tr("Computing the preview"),
        [milling = workpiece_.milling(), basis = basis_,
         request = std::move(request)](Progress& progress) -> Result<std::shared_ptr<const PassPreview>> {
            Result<PassPreview> preview = previewPass(*basis, *milling, request, progress);
            if (!preview) return std::move(preview).error();
            return std::make_shared<const PassPreview>(std::move(*preview));
        },
        [this, question = questions_](const Result<std::shared_ptr<const PassPreview>>& preview) {
            if (question != questions_) return;
            if (!preview) return fail(preview.error());
            preview_ = *preview;
            wanted_.reset();
            emit changed();
        });
}

} // namespace burin
