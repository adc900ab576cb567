// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/machine/machine_profile.h"
#include "ui/panels/value_form.h"

namespace burin {

class ChoiceBox;
class TorqueTable;

/// Fields for every value of a machine: name, dialect, and in sections the numbers with unit, allowed range and source.
class MachineForm final : public RecordForm<MachineProfile> {
    Q_OBJECT
public:
    explicit MachineForm(QWidget* parent = nullptr);
    void setDialects(const QStringList& names, const QStringList& ids);
    /// Never emits. @param locked whether the values are read-only
    void showMachine(const MachineProfile& machine, bool locked);
    const MachineProfile& machine() const noexcept { return record_; } ///< the machine with the values of the fields

private:
    void addGeneral();
    void addTravel();
    void addHome();
    void addFeeds();
    void addAccelerations();
    void addControl();
    void addArcs();
    void addSpindle();
    void addCoolant();
    void addTorque();

    ChoiceBox* dialect_ = nullptr;
    TorqueTable* torque_ = nullptr;
    QStringList dialectNames_, dialectIds_;
};

} // namespace burin
