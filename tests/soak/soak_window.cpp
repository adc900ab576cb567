// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// burin-window-monkey SECONDS SEED LOG: operates the window randomly for that time. Status 1: something was lost. A
// crash ends it as a crash; the last lines of the log show what led to it.
#include "tests/soak/window_monkey.h"
#include "ui/scene/surface_format.h"

#include <cstdlib>
#include <iostream>

using namespace burin::testing;

int main(int argc, char** argv) {
    if (argc != 4) {
        std::cerr << "burin-window-monkey SECONDS SEED LOG\n";
        return 2;
    }
    QSurfaceFormat::setDefaultFormat(burin::sceneSurfaceFormat());
    StallWatch watch(argc, argv);
    WindowDriver driver(QSize(1280, 800));
    WindowMonkey monkey(driver, watch, static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)),
                        QString::fromLocal8Bit(argv[3]));
    const double before = residentMegabytes();
    const WindowMonkey::Report report = monkey.run(std::strtod(argv[1], nullptr));
    std::cout << report.steps << " steps:";
    for (const auto& [kind, count] : report.byKind) std::cout << ' ' << kind.toStdString() << ' ' << count;
    std::cout << "\n"
              << report.projectsCompared << " saved projects compared, " << report.losses.size() << " losses\n"
              << "memory " << before << " MB at first, " << residentMegabytes() << " MB at last\n"
              << report.stalls << " stalls above 100 ms; the longest:\n";
    for (const auto& [milliseconds, text] : report.worstStalls) std::cout << "  " << text.toStdString() << '\n';
    for (const QString& loss : report.losses) std::cout << "lost: " << loss.toStdString() << '\n';
    return report.losses.isEmpty() ? 0 : 1;
}
