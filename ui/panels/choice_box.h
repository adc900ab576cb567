// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QComboBox>

namespace burin {

/// A choice of one of several texts; a long one ends in "…" and is the tooltip in whole, and the list shows all in
/// whole. The wheel changes it only when it has the focus. `activated` tells of the user alone.
class ChoiceBox : public QComboBox {
    Q_OBJECT
public:
    explicit ChoiceBox(QWidget* parent = nullptr);
    void showPopup() override;
    /// Replaces what is offered only when that is something else, so that an open list stays open.
    /// @param ids as many as texts @param chosen one of them, or none
    void offer(const QStringList& texts, const QStringList& ids, const QString& chosen);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QString elided() const;
};

} // namespace burin
