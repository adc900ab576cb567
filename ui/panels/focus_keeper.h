// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>

class QKeyEvent;
class QWidget;

namespace burin {

/// Enables or disables a widget that may have the keyboard focus, or contain the widget that has it. Qt would pass the
/// focus to the next widget, where a key or the wheel changes a choice, or to none, where "4" turns the view. Instead,
/// the parent widget holds the focus and ignores keys that the user continues to type into the field; the focus returns
/// when the widget is enabled again, unless the user has moved it elsewhere.
void setEnabledKeepingFocus(QWidget* widget, bool enabled);
/// Cancels the return of a focus that `place` holds: the user has moved on, although `place` still has the focus.
void forgetKeptFocus(QWidget* place);

/// Whether a key enters, deletes or confirms text in a text field.
bool isTyped(const QKeyEvent& key);

/// Holds the keyboard focus for a disabled widget. Deletes itself when the focus moves on.
class FocusKeeper final : public QObject {
    Q_OBJECT
public:
    /// @param place takes the focus and owns this object; @param kept gets the focus back
    FocusKeeper(QWidget* place, QWidget* kept);
    void giveBack(); ///< returns the focus and deletes this object
    QWidget* kept() const { return kept_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* place_;
    QPointer<QWidget> kept_;
    QElapsedTimer typing_; ///< since the last key that was meant for the field; invalid if `kept` takes no typed input
};

} // namespace burin
