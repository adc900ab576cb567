// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/path_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

class AreaCard;

/// The edits in order, each with its switch, position, parameters and the error that it caused; the error budget with
/// the point of the largest error. New edits are added from a menu.
class PathPanel : public QWidget {
    Q_OBJECT
public:
    explicit PathPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const PathState& state);       ///< never emits
    void setAtTime(const TimelinesPlace& place); ///< the part of the state that changes while the timeline is moved
    void setStylusEdit(const StylusEditState& state, LengthUnit unit); ///< never emits
    AreaCard& area() const; ///< the section of the panel for the area of the next pass

signals:
    void toolChosen(const std::string& id); ///< one of the tools that have takes
    void newPathRequested();
    void passRequested();
    void measureRequested();
    void refreshRequested(); ///< of the passes that are out of date
    // `id`: of one of the path's passes. `index`: of one of its edits, in their order.
    void passRemoved(std::int64_t id);
    void passChangeRequested(std::int64_t id);
    void placeRequested(const glm::dvec3& place); ///< mm, setup frame: the point that the view should show
    void passMovedUp(std::int64_t id);
    void editChanged(std::size_t index, const burin::Edit& edit); ///< switched on or off, or a parameter changed
    void editAdded(const burin::Edit& edit);
    void editRemoved(std::size_t index);
    void editMoved(std::size_t from, std::size_t to);
    void dragChosen(burin::DragChoice drag);
    void drawingRequested(bool wanted); ///< of a replacement for the selected part of the path
    void fieldDrawingRequested(const burin::DrawnField& field, bool wanted);
    void selectionCleared();
    void stylusRequested(bool wanted);    ///< to edit with the stylus
    void stylusReachEdited(double reach); ///< mm
    void evaluateRequested();
    void visibilityToggled(bool shown);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
