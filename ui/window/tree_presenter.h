// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/job_states.h"
#include "ui/panels/project_tree.h"
#include "ui/window/body_menu.h"
#include "ui/window/presenter.h"
#include "ui/window/scene_presenter.h"

#include <set>

namespace burin {

/// Fills the project tree and carries out its commands: open, switch, rename, delete, hide.
class TreePresenter final : public Presenter {
    Q_OBJECT
public:
    TreePresenter(Workbench& workbench, ProjectTree& tree, ScenePresenter& scene, QObject* parent);
    const std::set<std::size_t>& hiddenBodies() const noexcept { return hidden_; } ///< of the part
    /// Hides these bodies of the part that is there now, and shows all others.
    void hideBodies(std::set<std::size_t> bodies);

signals:
    void stepRequested(JobStep step); ///< the step for the item that was opened

private:
    void present() override;
    void open(ProjectRowKind kind, qint64 id);
    void switchRow(ProjectRowKind kind, qint64 id, bool on);
    void showMenu(ProjectRowKind kind, qint64 id, const QPoint& globalPosition);
    void showSetupMenu(qint64 id, const QPoint& globalPosition);
    /// The body of a row, or the bodies of its assembly; none if the row is of another kind.
    ChosenBodies chosenBodies(ProjectRowKind kind, qint64 id) const;
    void showFixtureMenu(std::size_t place, const QPoint& globalPosition);
    void showPassMenu(qint64 id, const QPoint& globalPosition);
    void hide(const std::set<std::size_t>& bodies);
    ProjectRow setups() const;
    ProjectRow bodies() const;
    ProjectRow fixtures() const;
    ProjectRow tools() const;
    ProjectRow takes() const;
    ProjectRow paths() const;
    ProjectRow programs() const;

    ProjectTree& tree_;
    ScenePresenter& scene_;
    std::shared_ptr<const Model> model_; ///< whose bodies `hidden_` refers to
    std::set<std::size_t> hidden_;       ///< of the model's bodies
};

} // namespace burin
