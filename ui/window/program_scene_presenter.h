// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/kinematics.h"
#include "ui/input/path_picker.h"
#include "ui/panels/job_states.h"
#include "ui/panels/program_panel.h"
#include "ui/window/presenter.h"
#include "ui/window/scene_presenter.h"

namespace burin {

/// The selected line of the program: its move in the viewport with the tool at its end, and the machine's state under
/// the text; also selects the line of a move that is clicked. Active while the program step is shown and no tool is
/// being moved.
class ProgramScenePresenter final : public Presenter {
    Q_OBJECT
public:
    ProgramScenePresenter(Workbench& workbench, Viewport& viewport, ProgramPanel& panel, ScenePresenter& scene,
                          QObject* parent);
    void setShown(JobStep step);
    void followLine(int line); ///< also selects the line in the text

signals:
    void hovered(const QPointF& position); ///< over the viewport, while active

private:
    void present() override;
    void choose(int line);
    void pick(std::size_t move);
    void showLine();
    void showTouched();
    void take(std::shared_ptr<const CheckedProgram> program);
    void followText();
    void chooseSelection();
    /// mm, setup frame.
    glm::dvec3 tipAt(const AxisValues& values) const { return kinematics_->poseOf(values).tip; }
    QString stateText(const NcMotion& motion) const;
    std::optional<double> endOf(const NcMotion& motion) const; ///< s from the start of the program
    QString loadText(std::size_t motion) const;
    QString handText(std::size_t motion) const;

    Viewport& viewport_;
    ProgramPanel& panel_;
    ScenePresenter& scene_;
    PathPicker picker_;
    std::shared_ptr<const CheckedProgram> program_;
    std::vector<NcMotion> moves_; ///< its moves as drawn and picked: straight ones
    std::unique_ptr<const Kinematics> kinematics_ = std::make_unique<ThreeAxes>(); ///< of the program's setup
    bool shown_ = false, active_ = false;
    int line_ = 0;             ///< from 1; 0: none is selected
    std::uint64_t lineOf_ = 0; ///< checksum of the text that the line belongs to
};

} // namespace burin
