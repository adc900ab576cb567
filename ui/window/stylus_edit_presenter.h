// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/panels/path_panel.h"
#include "ui/window/path_scene_presenter.h"
#include "ui/window/presenter.h"

namespace burin {

/// The stylus on the path: its reach and the held point are marked in the view, its state is shown in the path panel.
/// The stylus is put down when the user leaves the step.
class StylusEditPresenter final : public Presenter {
    Q_OBJECT
public:
    StylusEditPresenter(Workbench& workbench, PathPanel& panel, PathScenePresenter& scene, QObject* parent);
    void setUnit(LengthUnit unit) override;
    void setShown(JobStep step);
    void toggle(bool wanted);

signals:
    void told(const QString& sentence);

private:
    void present() override;
    void showMarks();
    QString text() const;

    PathPanel& panel_;
    PathScenePresenter& scene_;
    bool shown_ = false;
};

} // namespace burin
