// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A user at the window, for tests that end the program by force. Writes its folder and what it does to standard output.
// Without arguments it embeds a block, starts a recording, mills continuously, and closes the window when told so on
// standard input. With a number, the seed, it goes to random moments of two takes, continues there, takes back and
// saves, until it is killed.
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QSocketNotifier>
#include <QtTest>

#include <array>
#include <cstdio>
#include <numeric>
#include <random>
#include <unistd.h>

using namespace burin::testing;

namespace {

void tell(const QString& line) {
    std::puts(qPrintable(line));
    std::fflush(stdout);
}

int millUntilTold(WindowDriver& driver) {
    burin::Workbench& workbench = driver.window().workbench();
    if (!makeReady(driver) || !driver.step(burin::JobStep::mill) || !driver.clickOn("millButton")) return 1;
    if (!driver.waitFor([&] { return workbench.mill.active(); }, 10000)) return 1;
    QSocketNotifier order(STDIN_FILENO, QSocketNotifier::Read);
    QObject::connect(&order, &QSocketNotifier::activated, &driver.window(), [&] {
        order.setEnabled(false);
        std::array<char, 16> line{};
        const bool save = ::read(STDIN_FILENO, line.data(), line.size()) > 0 && line[0] == 's';
        driver.whenDialogStands([&driver, save](QWidget& dialog) {
            if (save) chooseFile(driver, driver.folder().filePath("kept.burin"));
            answer(dialog, save ? "saveButton" : "discardButton");
        });
        driver.window().close();
    });
    tell("recording");
    for (int i = 0; driver.window().isVisible(); ++i) {
        const double y = -12.0 + i % 9 * 3.0;
        millLine(driver, {-18.0, y}, {18.0, y});
    }
    tell("closed");
    return 0;
}

/// Works with the timeline at random.
class TimeHand {
public:
    TimeHand(WindowDriver& driver, unsigned seed) : driver_(driver), random_(seed) {}

    bool begin() {
        if (!makeReady(driver_) || !saveAs(driver_, driver_.folder().filePath("kept.burin"))) return false;
        driver_.window().viewport().setStandardView(burin::StandardView::top);
        QTest::qWait(400); // the view turns
        for (const double y : {-8.0, 0.0})
            if (!recordLine(driver_, {-15.0, y}, {15.0, y}) || !driver_.settle()) return false;
        return driver_.step(burin::JobStep::mill) && save();
    }
    bool act() {
        switch (random_() % 4) {
        case 0:
            return goTo(part());
        case 1:
            return goTo(part()) && punchIn();
        case 2:
            return save();
        default:
            return takeBack();
        }
    }

private:
    burin::Workbench& workbench() { return driver_.window().workbench(); }
    double part() { return static_cast<double>(random_() % 1000) / 1000.0; }
    /// Of all takes whose recording has ended: they are on the disk.
    std::uint64_t samples() {
        const auto& takes = workbench().mill.allTakes();
        return std::accumulate(takes.begin(), takes.end(), std::uint64_t{0},
                               [](std::uint64_t sum, const burin::TakeInfo& take) { return sum + take.sampleCount; });
    }

    bool goTo(double part) {
        burin::TimeController& time = workbench().time;
        tell("goes");
        // Again if what is recorded was read anew meanwhile, as after a take-back.
        return driver_.waitFor([&] {
            if (!time.possible() || !time.recorded() || time.reading() || time.arriving()) return false;
            const double seconds = part * time.recorded()->seconds();
            if (time.shown() && time.shown()->moment == time.recorded()->momentAt(seconds)) return true;
            time.goTo(seconds);
            return false;
        });
    }
    bool punchIn() {
        const auto* button = driver_.visible("punchInButton");
        if (button == nullptr || !button->isEnabled()) return true; // nothing can be recorded from here, as at the end
        if (!driver_.clickOn("punchInButton")) return false;
        if (!driver_.waitFor([&] { return workbench().mill.recording(); })) return false;
        tell("records");
        const double y = -12.0 + 24.0 * part();
        millLine(driver_, {-15.0, y}, {15.0, y});
        tell("stops");
        if (!driver_.clickOn("millButton")) return false;
        if (!driver_.waitFor([&] { return !workbench().mill.active() && !workbench().session.running(); }))
            return false;
        if (!driver_.settle()) return false;
        tell("recorded " + QString::number(samples()));
        return true;
    }
    bool save() {
        tell("saves");
        driver_.key(Qt::Key_S, Qt::ControlModifier);
        if (!driver_.settle()) return false;
        tell("saved " + QString::number(samples()));
        return true;
    }
    bool takeBack() {
        tell("takes back");
        driver_.key(Qt::Key_Z, Qt::ControlModifier);
        return driver_.settle();
    }

    WindowDriver& driver_;
    std::mt19937 random_;
};

int workInTime(WindowDriver& driver, unsigned seed) {
    TimeHand hand(driver, seed);
    if (!hand.begin()) return 1;
    tell("recording");
    while (hand.act()) {
    }
    tell("failed");
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    WindowDriver driver;
    tell("folder " + driver.folder().path());
    const int status = argc > 1 ? workInTime(driver, QByteArray(argv[1]).toUInt()) : millUntilTold(driver);
    // The folder stays, so that the test can inspect what was saved.
    std::_Exit(status);
}
