// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/panels/key_lines.h"

#include <QDialog>

class QLabel;

namespace burin {

/// A group of shortcuts.
struct KeySection {
    QString title;
    std::vector<KeyLine> lines;
};

/// All shortcuts and the functions of the mouse on one page, in a separate window. Typed text is searched.
class KeyList final : public QDialog {
    Q_OBJECT
public:
    explicit KeyList(const std::vector<KeySection>& sections, QWidget* parent = nullptr);

private:
    struct Shown {
        QWidget* whole;
        KeyLines* lines;
    };
    QWidget* columnsOf(const std::vector<KeySection>& sections);
    void alignKeys();
    void showOnly(const QString& text);

    std::vector<Shown> sections_;
    QLabel* nothing_ = nullptr;
};

} // namespace burin
