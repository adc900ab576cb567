// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/base/number_range.h"
#include "core/machine/machine_profile.h"
#include "ui/panels/quantity_field.h"

#include <QWidget>

#include <functional>
#include <string>
#include <vector>

class QGridLayout;
class QLineEdit;

namespace burin {

class ChoiceBox;
class TorqueTable;

/// Fields for every value of a machine: name, dialect, and by sections the numbers with unit, allowed range and source.
/// A value that the user changes has them as its source until they state another. One row for a key of the machine's
/// file; names of the fields: the key, with "0", "1", "2" where it has several numbers; of a source: the key with
/// "Source".
class MachineForm final : public QWidget {
    Q_OBJECT
public:
    explicit MachineForm(QWidget* parent = nullptr);
    void setUnit(LengthUnit unit);
    void setDialects(const QStringList& names, const QStringList& ids);
    /// Never emits. @param locked the values are shown and can't be changed
    void showMachine(const MachineProfile& machine, bool locked);
    const MachineProfile& machine() const noexcept { return machine_; } ///< as the fields say

signals:
    void edited(); ///< by the user

private:
    using Get = std::function<double(const MachineProfile&)>;
    using Set = std::function<void(MachineProfile&, double)>;
    /// One number of a key; in the unit that its quantity has inside.
    struct Number {
        Quantity quantity = Quantity::length;
        NumberRange range;
        bool optional = false; ///< 0 stands for "not stated"
        Get get;
        Set set;
        std::function<bool(const MachineProfile&)> stated{}; ///< it has a value that can be changed; nothing: always
    };
    struct Choice {
        QStringList texts;
        std::function<int(const MachineProfile&)> get;
        std::function<void(MachineProfile&, int)> set;
    };

    void addGeneral();
    void addTravel();
    void addHome();
    void addFeeds();
    void addAccelerations();
    void addControl();
    void addArcs();
    void addSpindle();
    void addCoolant();
    void addTitle(const QString& text);
    int beginRow(const QString& label, QWidget* buddy, const QString& toolTip);
    void addNumbers(const char* key, const QString& label, const QString& toolTip, std::vector<Number> numbers,
                    bool withSource = true);
    void addChoice(const char* key, const QString& label, const QString& toolTip, Choice choice,
                   bool withSource = true);
    QLineEdit* addText(const char* name, const QString& label, const QString& toolTip,
                       std::string MachineProfile::*text);
    void addTorque();
    void addSource(const char* key, int row);
    void changed(const std::string& key);
    void refresh();

    MachineProfile machine_;
    LengthUnit unit_ = LengthUnit::millimetre;
    bool locked_ = false;
    QGridLayout* grid_;
    std::vector<std::function<void()>> refreshers_; ///< show what `machine_` says
    std::vector<QWidget*> fields_;
    std::vector<QuantityField*> numbers_;
    ChoiceBox* dialect_ = nullptr;
    TorqueTable* torque_ = nullptr;
    QStringList dialectNames_, dialectIds_;
};

} // namespace burin
