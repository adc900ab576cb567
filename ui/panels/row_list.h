// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ui/theme/theme.h"

#include <QListWidget>

#include <vector>

namespace burin {

/// One row: a title with a value on the right, and a quieter second line.
struct ListRow {
    QString title, value, detail, toolTip;
    QString badge; ///< a word in a frame before the value; empty: none
    QString icon;  ///< name of a themed icon; empty: none
    ColourRole iconRole = &Palette::text;
    QColor swatch; ///< of a material; invalid: none
    bool operator==(const ListRow&) const = default;
};

/// A list of rows that is as high as it has rows, up to a number of them, then scrolls.
class RowList : public QListWidget {
    Q_OBJECT
public:
    explicit RowList(QWidget* parent = nullptr);
    void setMaximumRows(int rows);
    /// Rows up to the maximum are shown where there is room for them, and so many at any rate.
    void setLeastRows(int rows);
    void setFillsHeight(bool fills); ///< takes the height that there is, however many rows it has
    void setTextsWrap(bool wrap);    ///< titles and details are whole sentences, over several lines
    /// Shows rows without a signal; nothing is done when it has them. The current row stays where it can.
    void setRows(const std::vector<ListRow>& rows);
    void setChosen(int row); ///< without a signal; -1: none
    const std::vector<ListRow>& rows() const noexcept { return rows_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// The user chose a row by mouse or keyboard; clicking the one that is chosen chooses it again.
    void rowChosen(int row);

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    std::vector<ListRow> rows_;
    int heightOfRows(int rows) const;
    void followRows();

    int maximumRows_ = 6;
    int leastRows_ = 0; ///< 0: the maximum
    int beforePress_ = -1;
};

} // namespace burin
