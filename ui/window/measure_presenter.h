// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/actions/actions.h"
#include "ui/input/face_picker.h"
#include "ui/input/workpiece_picker.h"
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

/// Measures the part, or the workpiece that is drawn, at points clicked in the view, and shows the result there and
/// above the view.
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
    enum class Target { none, part, workpiece };

    void present() override;
    void ask(Target wanted);
    bool possible(Target target) const;
    InteractiveTool* pickerOf(Target target);
    void enableActions();
    void tellResults();
    MeasureMark markOf(const PartMeasure& measure) const;
    MeasureMark markOf(const WorkpieceMeasure& measure) const;

    Viewport& viewport_;
    MeasurePicker picker_;
    WorkpiecePicker workpiecePicker_;
    QAction* action_ = nullptr;
    QAction* workpieceAction_ = nullptr;
    InteractiveTool* before_ = nullptr; ///< the view's previous tool
    std::shared_ptr<const PartMeasure> told_;
    std::shared_ptr<const WorkpieceMeasure> toldWorkpiece_;
    std::optional<MeasureMark> other_;
    Target asking_ = Target::none;
};

} // namespace burin
