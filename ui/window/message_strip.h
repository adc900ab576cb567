// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

class QLabel;

namespace burin {

/// One sentence above the viewport that the user may put away; it never stops anybody's work.
class MessageStrip final : public QFrame {
    Q_OBJECT
public:
    enum class Kind { information, warning, error };
    explicit MessageStrip(QWidget* parent = nullptr);

    void show(Kind kind, const QString& sentence);
    void dismiss();

private:
    QLabel* mark_ = nullptr;
    QLabel* text_ = nullptr;
};

} // namespace burin
