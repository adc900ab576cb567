// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

namespace burin {

class ElidedLabel;

/// A label on the left, a value with its unit right-aligned in tabular figures.
class ValueRow : public QWidget {
    Q_OBJECT
public:
    explicit ValueRow(const QString& label, QWidget* parent = nullptr);
    /// @param value   as displayed, with its unit
    /// @param spoken  what assistive programs read instead, where the displayed value has no unit
    void setValue(const QString& value, const QString& spoken = {});
    QString value() const;

private:
    ElidedLabel* label_ = nullptr;
    ElidedLabel* value_ = nullptr;
};

} // namespace burin
