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

/// Presents the table of the part's faces: starts their inspection while the table is open, and moves the view to the
/// worst point of the chosen face.
class FacePresenter final : public Presenter {
    Q_OBJECT
public:
    FacePresenter(Workbench& workbench, Viewport& viewport, DeviationCard& card, QObject* parent);
    void connectActions(const Actions& actions);
    void setUnit(LengthUnit unit) override;

signals:
    void marked(const std::optional<burin::MeasureMark>& mark); ///< for the view; std::nullopt removes it
    void exportRequested(const std::string& table);             ///< CSV

private:
    void present() override;
    void open();
    void showProgress();
    void lookAt(const FaceQuality& face);
    QString markText(const FaceQuality& face) const;

    Viewport& viewport_;
    DeviationCard& card_;
    QPointer<FaceDialog> dialog_; ///< null until first opened; owned by the window
    std::shared_ptr<const std::vector<FaceQuality>> shown_;
};

} // namespace burin
