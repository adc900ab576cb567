// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/verify/verify.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace burin {

/// The cutting force over the time that a program takes, without its tool changes, which are marked: the greatest in
/// each column of pixels, its peak told in N. A click leads to the line of the motion that is cut then.
class LoadChart : public QWidget {
    Q_OBJECT
public:
    explicit LoadChart(QWidget* parent = nullptr);
    /// Its loads over the time that the program takes; null: none. Nothing is done when it shows it.
    void setReport(std::shared_ptr<const VerifyReport> report);
    void showTime(std::optional<double> seconds); ///< marks a time; nothing: none

    QSize sizeHint() const override;

signals:
    void lineChosen(int line); ///< from 1

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    std::span<const LoadStep> loads() const;
    /// A tool change, while which nothing is cut.
    struct Pause {
        double start = 0.0, length = 0.0; ///< s, of the program
    };
    double seconds() const;                       ///< that the chart shows
    double shownAt(double time) const;            ///< s of the chart at a time of the program
    double timeAt(double shown) const;            ///< the inverse; behind a pause at its place
    std::vector<double> columns(int count) const; ///< N, greatest force in each
    const MotionLoad* at(double seconds) const;   ///< what is cut then, or last before
    void choose(double x);

    std::shared_ptr<const VerifyReport> report_;
    std::vector<Pause> pauses_; ///< rising
    double peak_ = 0.0;         ///< N
    std::optional<double> time_;
};

} // namespace burin
