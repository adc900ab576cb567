// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/setup_states.h"
#include "ui/theme/length_unit.h"

#include <QWidget>

namespace burin {

/// The setups of the job, and how the part lies in the one that is worked in.
class SetupPanel : public QWidget {
    Q_OBJECT
public:
    explicit SetupPanel(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setState(const SetupState& state); ///< never emits

signals:
    void setupChosen(qint64 number); ///< of its SetupId, for which Qt has no stream
    void additionRequested();
    void removalRequested();
    void named(const QString& name);         ///< the setup that is worked in
    void stockWanted();                      ///< anew from the setup that leaves it
    void turned(int axis, double angle);     ///< @param axis 0, 1, 2 for x, y, z @param angle rad
    void positioned(int axis, double place); ///< mm: where the box around the part is to begin
    void mirrored(int axis);                 ///< @param axis as in `turned`
    /// The user picks a face in the view for a direction, or does no longer (none).
    void facePickRequested(burin::FaceAim aim);

private:
    class Fields;
    Fields* fields_ = nullptr;
};

} // namespace burin
