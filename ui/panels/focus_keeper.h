// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointer>

class QKeyEvent;
class QWidget;

namespace burin {

/// Enables or disables a widget that may have the keyboard, or hold what has it. Qt would hand the focus on to what
/// comes next, where a key or the wheel changes a choice, or to nobody, where "4" turns the view. Instead it waits
/// beside the widget, and keys that go on being typed into a field mean nothing; it comes back when the widget is
/// enabled again, unless the user took it elsewhere.
void setEnabledKeepingFocus(QWidget* widget, bool enabled);
/// What waits beside a widget of this place comes back no more: the keyboard has gone on, though it waits here still.
void forgetKeptFocus(QWidget* place);

/// Whether a key writes something in a field of text, or corrects what stands there.
bool isTyped(const QKeyEvent& key);

/// Holds the keyboard for a widget that is disabled. Ends itself when the focus goes on.
class FocusKeeper final : public QObject {
    Q_OBJECT
public:
    /// @param place takes the focus, and owns this; @param kept gets it back
    FocusKeeper(QWidget* place, QWidget* kept);
    void giveBack(); ///< and ends
    QWidget* kept() const { return kept_; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* place_;
    QPointer<QWidget> kept_;
    QElapsedTimer typing_; ///< since the last key that was meant for a field; invalid: it is none
};

} // namespace burin
