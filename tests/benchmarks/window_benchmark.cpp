// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
// How the window keeps up while the sample part is milled with the mouse and the view orbits. Writes a JSON list of
// figures to standard output and readable text to standard error. With --excess the workpiece is coloured by its excess
// stock meanwhile. With --answers it measures instead how long the window's answers take, with --hour how long a
// project of one hour's recording takes to open. A benchmark is not a test: the exit status is 0.
#include "tests/benchmarks/event_loop.h"
#include "tests/benchmarks/stall_watch.h"
#include "tests/benchmarks/window_answers.h"
#include "tests/benchmarks/window_opening.h"
#include "tests/benchmarks/window_phases.h"
#include "tests/benchmarks/window_report.h"
#include "tests/ui/window_driver.h"
#include "ui/scene/surface_format.h"

#include <QEventLoop>
#include <QMouseEvent>
#include <QTimer>
#include <QtTest>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

using namespace burin;
using namespace burin::testing;

namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto mouseInterval = 8ms; // 125 Hz, the rate of mice

/// Mouse input over the viewport.
class Hand {
public:
    explicit Hand(Viewport& viewport) : viewport_(viewport) {}

    void press(Qt::MouseButton button) {
        buttons_ |= button;
        send(QEvent::MouseButtonPress, button);
    }
    void release(Qt::MouseButton button) {
        buttons_ &= ~Qt::MouseButtons(button);
        send(QEvent::MouseButtonRelease, button);
    }
    void moveTo(const QPointF& place) {
        place_ = place;
        send(QEvent::MouseMove, Qt::NoButton);
    }
    /// Moves the pointer with one event after the other. @param way  position at a share 0 … 1
    void lead(Clock::duration time, const std::function<QPointF(double)>& way) {
        QEventLoop loop;
        QTimer mouse;
        mouse.setTimerType(Qt::PreciseTimer);
        const Clock::time_point begin = Clock::now();
        QObject::connect(&mouse, &QTimer::timeout, &loop, [&] {
            const double share = std::min(1.0, secondsSince(begin) / std::chrono::duration<double>(time).count());
            moveTo(way(share));
            if (share >= 1.0) loop.quit();
        });
        mouse.start(mouseInterval);
        loop.exec();
    }
    QPointF place() const { return place_; }

private:
    void send(QEvent::Type type, Qt::MouseButton button) {
        QMouseEvent event(type, place_, viewport_.mapTo(viewport_.window(), place_), viewport_.mapToGlobal(place_),
                          button, buttons_, Qt::NoModifier);
        QCoreApplication::sendEvent(&viewport_, &event);
    }

    Viewport& viewport_;
    Qt::MouseButtons buttons_;
    QPointF place_;
};

/// Observes what is drawn and how the loop keeps up.
class Observer : public QObject {
public:
    explicit Observer(MainWindow& window) : window_(window) {
        connect(&window.viewport(), &Viewport::painted, this, [this] { painted(); });
        connect(&window.workbench().session, &SessionRunner::ticked, this, [this] { ticked(); });
    }
    /// States whether from now on strokes are milled or the view orbits.
    void setMoving(bool moving) {
        moving_ = moving;
        lastMotion_ = Clock::now();
        resting_ = false;
    }
    bool atFullDetail() const { return resting_; }

    std::size_t mostTriangles = 0;
    double slowestFullDetail = 0.0; ///< s
    double slowestRate = 1e9;       ///< Hz, after the loop has run for two seconds

private:
    void ticked() {
        const SessionState& state = window_.workbench().session.state();
        if (state.sample.proxy.tip != tip_) lastMotion_ = Clock::now();
        tip_ = state.sample.proxy.tip;
        if (state.ticks > 2000) slowestRate = std::min(slowestRate, state.rateHz);
    }
    void painted() {
        const FrameStatistics statistics = window_.viewport().statistics();
        if (moving_) mostTriangles = std::max(mostTriangles, statistics.triangles);
        if (moving_ || resting_ || !statistics.fullDetail || statistics.busy) return;
        resting_ = true;
        slowestFullDetail = std::max(slowestFullDetail, secondsSince(lastMotion_));
    }

    MainWindow& window_;
    glm::dvec3 tip_{0.0};
    Clock::time_point lastMotion_;
    bool moving_ = false, resting_ = true;
};

/// Mills adjacent lanes, so that each stroke meets uncut stock.
class Miller {
public:
    Miller(WindowDriver& driver, Observer& observer)
        : driver_(driver), observer_(observer), hand_(driver.window().viewport()) {}

    void mill(Clock::duration time) {
        const Clock::time_point begin = Clock::now();
        for (; Clock::now() - begin < time; ++stroke_) {
            const bool alongPart = stroke_ % 4 >= 2, orbiting = stroke_ % 2 == 1;
            driver_.clickOn(alongPart ? "alongPartButton" : "levelButton");
            observer_.setMoving(true);
            alongPart ? millLane(0.62 - 0.05 * stroke_, 0.22, 0.5, orbiting)
                      : millLane(0.06 + 0.1 * stroke_, 0.04, 1.0, orbiting);
            observer_.setMoving(false);
        }
    }
    /// Waits until everything is drawn at full detail again.
    void rest() {
        runUntil([this] { return observer_.atFullDetail(); }, 10s);
    }

private:
    /// @param lane  share of the stock's width @param inset  from its ends @param height  share of its height
    void millLane(double lane, double inset, double height, bool orbiting) {
        const Box& stock = driver_.window().workbench().setup.setup().stock;
        const auto seen = [&](double along) {
            const glm::dvec3 place = stock.low + stock.size() * glm::dvec3(inset + (1.0 - 2.0 * inset) * along,
                                                                           std::clamp(lane, 0.05, 0.95), height);
            return driver_.window().viewport().project(place);
        };
        hand_.moveTo(seen(0.0));
        runFor(250ms);
        hand_.press(Qt::LeftButton);
        if (orbiting) { // the pointer runs ahead; while the tool follows, the right button orbits the view
            hand_.lead(200ms, seen);
            orbit(1600ms);
        } else {
            hand_.lead(1800ms, seen);
        }
        hand_.release(Qt::LeftButton);
    }
    void orbit(Clock::duration time) {
        const QPointF middle = hand_.place();
        hand_.press(Qt::RightButton);
        hand_.lead(time, [&](double share) {
            const double turn = 6.2832 * share; // there and back
            return middle + QPointF(160.0 * std::sin(turn), 30.0 * std::sin(2.0 * turn));
        });
        hand_.release(Qt::RightButton);
    }

    WindowDriver& driver_;
    Observer& observer_;
    Hand hand_;
    int stroke_ = 0;
};

std::string loadAverage() {
    std::string load;
    std::getline(std::ifstream("/proc/loadavg"), load);
    return load;
}

/// CPU time of all cores that other programs use, including the X server, s.
class OtherPrograms {
public:
    OtherPrograms() : begin_(now()), start_(Clock::now()) {}
    double coresUsed() const { return (now() - begin_) / secondsSince(start_); }

private:
    static double now() {
        std::ifstream stat("/proc/stat");
        std::string cpu;
        double user = 0.0, niced = 0.0, system = 0.0;
        stat >> cpu >> user >> niced >> system;
        rusage own{};
        getrusage(RUSAGE_SELF, &own);
        const auto seconds = [](const timeval& time) {
            return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        };
        return (user + niced + system) / static_cast<double>(sysconf(_SC_CLK_TCK)) - seconds(own.ru_utime) -
               seconds(own.ru_stime);
    }
    double begin_;
    Clock::time_point start_;
};

void answer(WindowDriver& driver, Report& report) {
    if (!measureAnswers(driver, report))
        std::cerr << "The answers could not be measured: " << qPrintable(driver.message()) << '\n';
    report.print();
    std::cerr << "load after: " << loadAverage() << '\n';
}

int run(StallWatch& watch) {
    Report report;
    std::cerr << "load before: " << loadAverage() << '\n';
    WindowDriver driver;
    runFor(500ms);
    Workbench& workbench = driver.window().workbench();
    Viewport& viewport = driver.window().viewport();
    Observer observer(driver.window());
    if (!importSample(driver, watch, report) || !embedSample(driver, watch, report)) {
        std::cerr << "The sample part could not be embedded: " << qPrintable(driver.message()) << '\n';
        return 0;
    }
    if (QCoreApplication::arguments().contains(QStringLiteral("--answers"))) {
        answer(driver, report);
        return 0;
    }
    if (QCoreApplication::arguments().contains(QStringLiteral("--hour"))) {
        if (!measureOpening(driver, report)) std::cerr << "The project of one hour could not be opened.\n";
        report.print();
        return 0;
    }

    driver.step(JobStep::mill);
    driver.clickOn("millButton");
    if (!runUntil([&] { return workbench.mill.active(); }, 5s)) {
        std::cerr << "Mill mode did not begin: " << qPrintable(driver.message()) << '\n';
        return 0;
    }
    if (QCoreApplication::arguments().contains(QStringLiteral("--excess"))) driver.key(Qt::Key_8, Qt::ControlModifier);
    runFor(500ms);
    watch.beginPhase();
    viewport.resetStatistics();
    const Clock::time_point begin = Clock::now();
    const OtherPrograms others;
    Miller miller(driver, observer);
    for (int round = 0; round < 3; ++round) {
        miller.mill(4500ms);
        miller.rest();
    }
    const double seconds = secondsSince(begin);
    const FrameStatistics drawn = viewport.statistics();
    const SessionState state = workbench.session.state();
    report.add("cut_to_screen_p95", drawn.cutToScreenP95, "ms", 150.0);
    report.add("cut_to_screen_max", drawn.cutToScreenMaximum, "ms");
    report.add("cuts_shown", static_cast<double>(drawn.cutsShown), "");
    report.addStalls("gui_stall_max", watch);
    report.add("gui_stalls_beyond_50", static_cast<double>(watch.longerThan(50.0)), "");
    report.add("triangles_moving_max", static_cast<double>(observer.mostTriangles), "", 100000.0);
    report.add("full_detail_after", observer.slowestFullDetail, "s", 1.0);
    report.add("tick_cpu_p999", state.cpuP999, "us", 200.0);
    report.add("tick_wall_p999", state.workP999, "us");
    report.add("haptic_rate_min", observer.slowestRate, "Hz");
    report.add("missed_edges", static_cast<double>(state.missed), "");
    report.add("ticks", static_cast<double>(state.ticks), "");
    report.add("strokes", static_cast<double>(workbench.workpiece.strokes().count()), "");
    report.add("paint_p95", drawn.paintP95, "ms");
    report.add("paint_max", drawn.paintMaximum, "ms");
    report.add("paint_processor_mean", watch.processorPerRendering(), "ms");
    report.add("frames_per_second", static_cast<double>(drawn.frames) / seconds, "1/s");
    report.add("cores_used_by_others", others.coresUsed(), "");
    if (qEnvironmentVariableIsSet("BURIN_BENCHMARK_PICTURE")) driver.shoot("window-benchmark");
    if (!workOn(driver, watch, report) || !openAgain(driver, watch, report))
        std::cerr << "The rest of the job could not be done: " << qPrintable(driver.message()) << '\n';
    report.print();
    std::cerr << "load after: " << loadAverage() << '\n';
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    QSurfaceFormat::setDefaultFormat(sceneSurfaceFormat());
    StallWatch watch(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() == 4 && arguments[1] == QStringLiteral("--open"))
        return openAndMeasure(arguments[2], arguments[3].toLongLong());
    return run(watch);
}
