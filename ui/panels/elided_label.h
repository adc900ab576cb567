// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace burin {

/// One line of plain text that is elided at its end (or in its middle) with "…" if there is not enough room. The full
/// text is then the tooltip, and it is always what assistive programs read.
class ElidedLabel : public QLabel {
    Q_OBJECT
public:
    explicit ElidedLabel(const QString& text = {}, QWidget* parent = nullptr);
    void setElideMode(Qt::TextElideMode mode);

    QSize minimumSizeHint() const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QString elided() const;
    Qt::TextElideMode mode_ = Qt::ElideRight;
};

} // namespace burin
