// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/job/tool_shape.h"
#include "ui/theme/length_unit.h"

#include <QDialog>

class QComboBox;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace burin {

class LengthField;
class QuantityField;

/// Asks for the models of a tool's flutes and shank and for the name of the new tool.
class ToolShapeDialog final : public QDialog {
    Q_OBJECT
public:
    /// @param like from which the new tool takes its other values
    /// @param folder initial folder for choosing models
    ToolShapeDialog(const Tool& like, const QString& folder, LengthUnit unit, QWidget* parent);

    /// The request without the id. Valid after the dialog was accepted.
    ToolShapeRequest request() const;
    const QString& folder() const noexcept { return folder_; } ///< of the model chosen last

private:
    /// A button that asks for a file and shows its name.
    struct FileChoice {
        QPushButton* button = nullptr;
        QString file;
    };
    void layOut(LengthUnit unit);
    FileChoice addFile(const QString& label, const QString& toolTip, const QString& objectName);
    void choose(FileChoice& choice, const QString& title);
    void update();

    Tool like_;
    QString folder_;
    FileChoice flutes_, shank_;
    QComboBox* unit_ = nullptr;
    QLineEdit* name_ = nullptr;
    QSpinBox* number_ = nullptr;
    QComboBox* motion_ = nullptr; ///< 0: turns with the spindle, 1: does not turn
    QuantityField* direction_ = nullptr;
    LengthField* tolerance_ = nullptr;
    QPushButton* make_ = nullptr;
};

} // namespace burin
