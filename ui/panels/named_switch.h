// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;

namespace burin {

class ElidedLabel;

/// A check box for an item that the user named, with the item's state. Either text may be longer than the available
/// room.
class NamedSwitch : public QWidget {
    Q_OBJECT
public:
    /// @param name prefix of the object names of the check box ("<name>Switch") and of the text after it ("<name>News")
    NamedSwitch(const QString& name, const QString& toolTip, QWidget* parent = nullptr);
    void show(const QString& title, bool on, const QString& news); ///< never emits

signals:
    void switched(bool on); ///< by the user

protected:
    void mousePressEvent(QMouseEvent* event) override; ///< a click on the texts acts like one on the box

private:
    QCheckBox* box_;
    ElidedLabel *title_, *news_;
};

} // namespace burin
