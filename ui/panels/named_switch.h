// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

class QCheckBox;

namespace burin {

class ElidedLabel;

/// A check box for something that the user named, and what becomes of it; either text may be longer than its room.
class NamedSwitch : public QWidget {
    Q_OBJECT
public:
    /// @param name of the check box ("<name>Switch") and of the text behind it ("<name>News")
    NamedSwitch(const QString& name, const QString& toolTip, QWidget* parent = nullptr);
    void show(const QString& title, bool on, const QString& news); ///< never emits

signals:
    void switched(bool on); ///< by the user

protected:
    void mousePressEvent(QMouseEvent* event) override; ///< on the texts: as on the box

private:
    QCheckBox* box_;
    ElidedLabel *title_, *news_;
};

} // namespace burin
