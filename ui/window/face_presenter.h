// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/face_quality.h"
#include "ui/actions/actions.h"
#include "ui/panels/deviation_card.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

#include <QPointer>

namespace burin {

class FaceDialog;

/// The table of the part's faces: has them inspected while it is open, and leads the view to the worst point of the
/// one that is chosen.
class FacePresenter final : public Presenter {
    Q_OBJECT
public:
    FacePresenter(Workbench& workbench, Viewport& viewport, DeviationCard& card, QObject* parent);
    void connectActions(const Actions& actions);
    void setUnit(LengthUnit unit) override;

signals:
    void marked(const std::optional<burin::MeasureMark>& mark); ///< in the view; nothing: no longer
    void exportRequested(const std::string& table);             ///< CSV

private:
    void present() override;
    void open();
    void showProgress();
    void lookAt(const FaceQuality& face);
    QString markText(const FaceQuality& face) const;

    Viewport& viewport_;
    DeviationCard& card_;
    QPointer<FaceDialog> dialog_; ///< null until it was opened once; its parent is the window
    std::shared_ptr<const std::vector<FaceQuality>> shown_;
};

} // namespace burin
