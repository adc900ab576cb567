// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/setup/setup.h"
#include "ui/theme/length_unit.h"

#include <QPushButton>
#include <QWidget>

#include <functional>
#include <vector>

namespace burin {

class ChoiceBox;
class LengthField;
class NamedSwitch;

/// The shape of the stock: box, cylinder or bodies; around the part or at stated coordinates; and whether there is a
/// part at all.
class StockShapeFields : public QWidget {
    Q_OBJECT
public:
    explicit StockShapeFields(QWidget* parent = nullptr);
    void showSetup(const Setup& setup, bool locked); ///< never emits
    void setUnit(LengthUnit unit);

signals:
    void edited(const burin::Setup& setup);
    void fileRequested(); ///< file to read the stock from; the form changes once it has been read

private:
    using Get = std::function<double(const Setup&)>;
    using Set = std::function<void(Setup&, double)>;
    struct Field {
        LengthField* field;
        QWidget* row;
        StockForm form;
        Get get;
    };
    void addField(StockForm form, const QString& label, const char* name, double least, Get get, Set set);
    void addBoxFields();
    void addCylinderFields();
    void addFileRow();
    void chooseForm(StockForm form);
    void chooseAxis(int axis);
    int axisChosen() const;

    Setup setup_;
    ChoiceBox *form_, *axis_;
    QWidget *axisRow_, *fileRow_;
    QPushButton* file_;
    NamedSwitch *stated_, *freeCarving_;
    std::vector<Field> fields_;
};

} // namespace burin
