// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/input/hole_picker.h"
#include "ui/panels/job_states.h"
#include "ui/scene/viewport.h"
#include "ui/window/presenter.h"

#include <optional>

namespace burin {

/// Picks the holes or studs of a pass in the view, between two appearances of the pass dialog. Ends without a pass if
/// another tool takes the pointer, another step is shown, or the part changes.
class HolePresenter final : public Presenter {
    Q_OBJECT
public:
    HolePresenter(Workbench& workbench, Viewport& viewport, QObject* parent);
    /// Begins with the holes of a request. Does nothing without a part.
    void pick(const RequestedPass& wanted);
    void setShown(JobStep step); ///< picking ends when another step than the path's is shown

signals:
    void pickBegins();                               ///< the path step must be shown
    void picked(const burin::RequestedPass& wanted); ///< the user is done
    void told(const QString& sentences);             ///< what to do, or what was picked
    void marked(const std::optional<MeasureMark>&);  ///< of the picked holes

private:
    void present() override;
    void toggle(std::size_t hole);
    void leave();
    void mark(const std::optional<std::size_t>& newest);
    std::vector<UprightHole> offered() const; ///< what the places of the request name: holes, or studs

    Viewport& viewport_;
    HolePicker picker_;
    InteractiveTool* before_ = nullptr; ///< the view's previous tool
    std::shared_ptr<const MillingContext> milling_;
    std::optional<RequestedPass> wanted_; ///< empty: not picking
    bool studs_ = false;                  ///< whether studs may be picked as well: the tool mills threads
};

} // namespace burin
