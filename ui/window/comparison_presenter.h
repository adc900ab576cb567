// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/scene/camera_view.h"
#include "ui/scene/viewport.h"
#include "ui/window/comparison_dialog.h"
#include "ui/window/presenter.h"

#include <QPointer>

namespace burin {

/// Shows a comparison of two paths: the values in a modeless dialog, both paths and their differences in the view.
/// Closing the dialog restores the view.
class ComparisonPresenter final : public Presenter {
    Q_OBJECT
public:
    ComparisonPresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void connectActions(const Actions& actions);

private:
    void present() override;
    void begin();
    void end();
    void showDialog();
    void lookAtLargest(bool ofSecond);
    ComparisonState state() const;
    QString nameOf(const PathVersion& version) const;

    Viewport& viewport_;
    const QAction* showPath_ = nullptr;
    QPointer<ComparisonDialog> dialog_;
    std::shared_ptr<const ComparedPaths> drawn_;
    std::shared_ptr<const EvaluatedPath> drawnOther_; ///< drawn also while the deviations are not known
    std::optional<CameraView> before_;                ///< the view before it moved to a deviation
};

} // namespace burin
