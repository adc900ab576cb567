// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The setups of the job, and the placement of the part in the current one.
class SetupPanel : public QWidget {
    Q_OBJECT
public:
    explicit SetupPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const SetupState& state); ///< never emits

signals:
    void setupChosen(qint64 number); ///< number of its SetupId, for which Qt has no stream operator
    void additionRequested();
    void removalRequested();
    void named(const QString& name);         ///< the current setup's new name
    void stockRequested();                   ///< take the stock again from the setup that leaves it
    void turned(int axis, double angle);     ///< @param axis 0, 1, 2 for x, y, z @param angle rad
    void positioned(int axis, double place); ///< mm: new lower limit of the part's bounding box
    void mirrored(int axis);                 ///< @param axis as in `turned`
    /// The user starts to pick a face in the view for a direction, or stops picking (none).
    void facePickRequested(burin::FaceAim aim);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
