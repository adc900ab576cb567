// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/pass_preview.h"
#include "ui/workbench/pass_controller.h"

#include <map>
#include <memory>
#include <optional>

namespace burin {

/// Shows an outline of a pass of the tool in force while the user edits its request. Stock and tool field, which all
/// previews of one request share, are made once, and again after the workpiece has changed.
class PassPreviewer final : public Controller {
    Q_OBJECT
public:
    PassPreviewer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path,
                  const ToolController& tools, std::shared_ptr<KeptLeads> kept, QObject* parent);

    /// Replaces the previous request; `changed` is emitted when there is a preview or a problem.
    void show(const RequestedPass& wanted);
    void clear(); ///< the request can't be shown; another may follow
    void end();   ///< no preview is needed any more; removes what is shown

    /// Of the pass requested last; null if not ready or not possible.
    const PassPreview* preview() const noexcept { return preview_.get(); }
    /// The lines of the pass requested last, also those of takes; mm, setup frame.
    const std::vector<PassLine>& leads() const noexcept { return leads_; }
    const std::optional<Error>& problem() const noexcept { return problem_; }
    bool busy() const noexcept { return wanted_.has_value(); }

private:
    bool heedsHand() const { return wanted_ && wanted_->request.hand != HandStrokes::ignore; }
    void goOn();
    void askLines(std::int64_t take);
    void makeBasis();
    void plan();
    void fail(const Error& error);
    void readersStop();

    const WorkpieceController& workpiece_;
    const PathController& path_;
    const ToolController& tools_;
    std::optional<RequestedPass> wanted_; ///< until its preview is ready
    std::shared_ptr<const PassBasis> basis_;
    std::shared_ptr<KeptLeads> kept_;
    std::shared_ptr<Progress> reading_;       ///< of a take; null: never begun
    std::map<std::int64_t, LeadLines> lines_; ///< of takes
    std::vector<PassLine> leads_;
    std::shared_ptr<const PassPreview> preview_;
    std::optional<Error> problem_;
    bool asked_ = false; ///< the project is being read, or the basis made
    quint64 questions_ = 0;
};

} // namespace burin
