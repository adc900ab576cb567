// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/pass_preview.h"
#include "ui/workbench/pass_controller.h"

#include <map>
#include <memory>
#include <optional>

namespace burin {

/// Shows in outline what a pass of the tool in force would be, while the user still asks for it. What all previews of
/// one question share, the stock and the tool's field, is made once.
class PassPreviewer final : public Controller {
    Q_OBJECT
public:
    PassPreviewer(const Desk& desk, const WorkpieceController& workpiece, const PathController& path,
                  const ToolController& tools, QObject* parent);

    /// Replaces what was wanted before; `changed` tells when there is a preview, or a problem.
    void show(const WantedPass& wanted);
    void clear(); ///< what is wanted can't be shown; another may be wanted next
    void end();   ///< nothing is wanted any more, and nothing shown

    /// Of the pass wanted last; null: none yet, or it can't be made.
    const PassPreview* preview() const noexcept { return preview_.get(); }
    const std::optional<Error>& problem() const noexcept { return problem_; }
    bool busy() const noexcept { return wanted_.has_value(); }

private:
    void goOn();
    void askLines(std::int64_t take);
    void makeBasis();
    void plan();
    void fail(const Error& error);

    const WorkpieceController& workpiece_;
    const PathController& path_;
    const ToolController& tools_;
    std::optional<WantedPass> wanted_; ///< until there is a preview of it
    std::shared_ptr<const PassBasis> basis_;
    std::map<std::int64_t, std::vector<PassLine>> lines_; ///< of takes
    std::shared_ptr<const PassPreview> preview_;
    std::optional<Error> problem_;
    bool asked_ = false; ///< the project, or for the basis
    quint64 questions_ = 0;
};

} // namespace burin
