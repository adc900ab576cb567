// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>

#include <vector>

class QLabel;

namespace burin {

/// A sentence with an icon, so that its kind is not shown by colour alone. Hidden while there is no sentence.
class Notice : public QFrame {
    Q_OBJECT
public:
    enum class Kind { information, passed, warning, error };
    explicit Notice(QWidget* parent = nullptr);

    void tell(Kind kind, const QString& sentence); ///< an empty sentence hides the notice
    /// A longer sentence is elided with "…" and shown in full in the tooltip.
    void setMaximumLines(int lines);
    int heightOfLines(int lines) const; ///< pixels
    /// Breaks the sentence for a width, whatever width the notice has now, and returns the height that it needs;
    /// pixels.
    int fitTo(int width);
    void clear() { tell(Kind::information, {}); }
    QString sentence() const;
    Kind kind() const noexcept { return kind_; }

signals:
    void told();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void showText(int width);

    QLabel* text_ = nullptr;
    QString sentence_;
    Kind kind_ = Kind::information;
    int maximumLines_ = 0; ///< 0: no limit
};

/// Reserved space for notices that appear and disappear by themselves, so that nothing below moves under the pointer.
/// Only the first notice with a sentence is shown. A button that belongs to a short notice can be placed below it, in
/// the same space.
class NoticePlace : public QWidget {
    Q_OBJECT
public:
    explicit NoticePlace(QWidget* parent = nullptr);
    Notice* add(const char* name); ///< adds a notice with lower priority than the previous ones; owned by this
    void setFoot(QWidget* foot);   ///< button below the notice, hidden until `setFootRequested(true)`; owned by this
    void setFootRequested(bool wanted); ///< shows the button; the notice above it is then limited to one line

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {1, sizeHint().height()}; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void showFirst();

    std::vector<Notice*> notices_;
    QWidget* foot_ = nullptr;
    bool footRequested_ = false;
};

} // namespace burin
