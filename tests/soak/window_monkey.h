// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/benchmarks/stall_watch.h"
#include "tests/ui/window_driver.h"

#include <QFile>
#include <QObject>

#include <map>
#include <random>

class QAbstractButton;
class QFileDialog;

namespace burin::testing {

/// The resident memory of this process, MB.
double residentMegabytes();

/// Clicks, types, drags and drops in a window at random, by a seed, and checks whether the project still contains what
/// the window shows. It also acts in dialogs, inside their event loops.
class WindowMonkey {
public:
    /// The result of a run.
    struct Report {
        std::size_t steps = 0, projectsCompared = 0, stalls = 0;
        QStringList losses;                                         ///< where the file and the window disagree
        std::map<QString, std::size_t> byKind;                      ///< steps
        std::multimap<double, QString, std::greater<>> worstStalls; ///< ms, and the step that it followed
    };

    /// @param log  each step is written before it is taken, so that what led to a crash can be read
    WindowMonkey(WindowDriver& driver, StallWatch& watch, unsigned seed, const QString& log);
    /// Returns once the time is over and no dialog is open.
    Report run(double seconds);

private:
    void actSoon();
    void act();
    void actInDialog(QWidget& dialog);
    void actInFileDialog(QFileDialog& dialog);
    void actInPopup(QWidget& popup);
    void actInWindow();
    void triggerAction();
    void clickWidget(QWidget& in);
    void enterNumber(QWidget& in);
    void dragInView();
    void pressKey();
    void openSomeFile();
    void saveAndCompare();
    void closeAndOpen();
    void note(const QString& kind, const QString& what);
    void noteStall();
    void noteMemory();
    QString someFile();
    int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
    bool chance(int percent) { return below(100) < percent; }
    template <class T>
    T* oneOf(const QList<T*>& all) {
        return all.isEmpty() ? nullptr : all[below(static_cast<int>(all.size()))];
    }

    WindowDriver& driver_;
    StallWatch& watch_;
    std::mt19937 random_;
    QFile log_;
    QObject context_; ///< context of its timers
    Report report_;
    QString last_;
    double memoryNoted_ = 0.0; ///< MB
    int depth_ = 0;            ///< number of nested event loops of dialogs that it acts in
    bool ending_ = false;      ///< no new step is begun
    bool over_ = false;
};

} // namespace burin::testing
