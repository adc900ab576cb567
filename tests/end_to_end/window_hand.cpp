// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// A user at the window, for tests that end the program by force: embeds a block, starts a recording and mills
// continuously. Writes its folder and the start of the recording to standard output; closes the window when told so on
// standard input.
#include "tests/ui/window_steps.h"

#include <QApplication>
#include <QSocketNotifier>
#include <QtTest>

#include <array>
#include <cstdio>
#include <unistd.h>

using namespace burin::testing;

namespace {

void tell(const QString& line) {
    std::puts(qPrintable(line));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    WindowDriver driver;
    tell("folder " + driver.folder().path());
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
    // The folder stays, so that the test can inspect what was saved.
    std::_Exit(0);
}
