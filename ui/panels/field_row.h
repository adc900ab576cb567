// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QLabel;

namespace burin {

/// A label on the left and its field on the right. The label is the field's buddy and its accessible name; a field
/// without a tooltip of its own gets `toolTip`.
class FieldRow : public QWidget {
    Q_OBJECT
public:
    static constexpr int numberWidth = 136, choiceWidth = 184; ///< width of the field, pixels; for a choice the minimum
    static constexpr int wholeWidth = 0;                       ///< the field is below its label and as wide as the row
    FieldRow(const QString& label, QWidget* field, const QString& toolTip, QWidget* parent = nullptr,
             int fieldWidth = numberWidth);

private:
    QLabel* label_ = nullptr;
};

} // namespace burin
