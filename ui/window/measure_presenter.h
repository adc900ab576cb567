// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/input/face_picker.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

namespace burin {

/// Picks points to measure until ended by Esc.
class MeasurePicker final : public FacePicker {
    Q_OBJECT
public:
    using FacePicker::FacePicker;
    QString escapeMeaning() override { return tr("Esc: end measuring"); }
};

/// Measures the part at points clicked in the view, and shows the result there and above the view.
class MeasurePresenter final : public Presenter {
    Q_OBJECT
public:
    MeasurePresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    void connectActions(const Actions& actions);
    /// Sets the mark that the view shows while nothing is measured; std::nullopt: none.
    void setOtherMark(const std::optional<MeasureMark>& mark);
    void setHiddenBodies(const std::set<std::size_t>& bodies) { picker_.setHidden(bodies); }

signals:
    void told(const QString& sentences); ///< the result, or what to do next

private:
    void present() override;
    void ask(bool wanted);
    MeasureMark markOf(const PartMeasure& measure) const;

    Viewport& viewport_;
    MeasurePicker picker_;
    QAction* action_ = nullptr;
    InteractiveTool* before_ = nullptr; ///< the view's previous tool
    std::shared_ptr<const PartMeasure> told_;
    std::optional<MeasureMark> other_;
    bool asking_ = false;
};

} // namespace burin
