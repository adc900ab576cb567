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
    void setValue(const QString& value); ///< as displayed, with its unit
    QString value() const;

private:
    ElidedLabel* label_ = nullptr;
    ElidedLabel* value_ = nullptr;
};

} // namespace burin
