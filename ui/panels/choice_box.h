// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>

namespace burin {

/// A choice of one of several texts. A long text is elided with "…" and shown in full in the tooltip; the list shows
/// all texts in full. The wheel changes the choice only when the box has the focus. `activated` is emitted only for the
/// user's choices. Assistive programs read the accessible name that it has when it is first shown.
class ChoiceBox : public QComboBox {
    Q_OBJECT
public:
    explicit ChoiceBox(QWidget* parent = nullptr);
    void showPopup() override;
    /// Replaces the offered texts only if they differ, so that an open list stays open.
    /// @param ids one per text @param chosen one of them, or none
    void offer(const QStringList& texts, const QStringList& ids, const QString& chosen);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void giveLabel();
    QString elided() const;
};

} // namespace burin
