// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/machine_form.h"

#include "core/machine/machine_ranges.h"
#include "ui/panels/choice_box.h"
#include "ui/panels/torque_table.h"

#include <QLineEdit>

#include <cmath>

namespace burin {

namespace {

double valueOf(const MachineProfile& machine, double MachineProfile::*member) {
    return machine.*member;
}

} // namespace

MachineForm::MachineForm(QWidget* parent) : RecordForm(tr("as stated in the machine's source"), parent) {
    setObjectName(QStringLiteral("machineForm"));
    addGeneral();
    addTravel();
    addFeeds();
    addAccelerations();
    addSpindle();
    addCoolant();
    addControl();
    addArcs();
    closeRows();
}

void MachineForm::addGeneral() {
    addText("name", tr("Name"), tr("Name in the list of machines"), &MachineProfile::name);
    dialect_ = new ChoiceBox(this);
    dialect_->setObjectName(QStringLiteral("dialect"));
    const QString tip = tr("NC dialect that the machine's control reads");
    const int row = beginRow(tr("Dialect"), dialect_, tip);
    placeWide(dialect_, row);
    connect(dialect_, &QComboBox::activated, this, [this](int index) {
        record_.dialect = dialectIds_[index].toStdString();
        emit edited();
    });
    onRefresh([this] { dialect_->offer(dialectNames_, dialectIds_, QString::fromStdString(record_.dialect)); });
    addText("source", tr("Source"), tr("Source of the values that have none of their own"), &MachineProfile::source);
}

void MachineForm::addTravel() {
    using namespace machine_range;
    addTitle(tr("Travel"));
    const auto axis = [](int i) {
        return Number{Quantity::length, travel, false, [i](const MachineProfile& m) { return m.travel[i]; },
                      [i](MachineProfile& m, double value) { m.travel[i] = value; }};
    };
    addNumbers("travel_mm", tr("Travel X, Y, Z"), tr("Travel of each axis"), {axis(0), axis(1), axis(2)});
    const auto own = [](Quantity quantity, NumberRange range, bool optional, double MachineProfile::*member) {
        return Number{quantity, range, optional, [member](const MachineProfile& m) { return valueOf(m, member); },
                      [member](MachineProfile& m, double value) { m.*member = value; }};
    };
    addNumbers("tool_change_height_mm", tr("Tool change height"),
               tr("Height above program zero that is always free; below the travel of Z"),
               {own(Quantity::length, machine_range::height, false, &MachineProfile::toolChangeHeight)});
    addNumbers("tool_change_s", tr("Tool change time"), tr("From chip to chip"),
               {own(Quantity::time, toolChange, false, &MachineProfile::toolChangeSeconds)});
    addHome();
}

void MachineForm::addHome() {
    const auto stated = [](const MachineProfile& m) { return m.home.has_value(); };
    addChoice(
        "home_mm", tr("Home"),
        tr("Parking position of the spindle for a tool change and at the end of a program (G53), if the dialect "
           "supports it"),
        {{tr("Not stated"), tr("At a machine position")},
         [stated](const MachineProfile& m) { return stated(m) ? 1 : 0; },
         [](MachineProfile& m, int index) { m.home = index == 0 ? std::nullopt : std::optional(glm::dvec3(0.0)); }},
        false);
    const auto axis = [stated](int i) {
        return Number{Quantity::length,
                      machine_range::home,
                      false,
                      [i](const MachineProfile& m) { return m.home ? (*m.home)[i] : 0.0; },
                      [i](MachineProfile& m, double value) {
                          if (m.home) (*m.home)[i] = value;
                      },
                      stated};
    };
    addNumbers(
        "home_mm", tr("Home X, Y, Z"),
        tr("In machine coordinates, no farther from machine zero than the travel. Z is moved first, straight from "
           "above the work, so it has to be the top of the travel"),
        {axis(0), axis(1), axis(2)});
}

void MachineForm::addFeeds() {
    using namespace machine_range;
    addTitle(tr("Feeds and rapids"));
    addNumbers("maximum_feed_mm_per_min", tr("Greatest feed"), tr("While it cuts"),
               {{Quantity::feed, feed, false, [](const MachineProfile& m) { return m.maximumFeed; },
                 [](MachineProfile& m, double value) { m.maximumFeed = value; }}});
    addNumbers("rapid_feed_mm_per_min", tr("Rapid feed"), tr("Of the fastest axis"),
               {{Quantity::feed, feed, false, [](const MachineProfile& m) { return m.rapidFeed; },
                 [](MachineProfile& m, double value) { m.rapidFeed = value; }}});
    const auto axis = [](int i) {
        return Number{Quantity::feed, feed, true, [i](const MachineProfile& m) { return m.axisRates[i]; },
                      [i](MachineProfile& m, double value) { m.axisRates[i] = value; }};
    };
    addNumbers("axis_rates_mm_per_min", tr("Greatest rate X, Y, Z"),
               tr("Maximum feed of each axis; at most the rapid feed, which applies to axes without a value"),
               {axis(0), axis(1), axis(2)});
    addChoice("rapids", tr("Rapids"), tr("Motion of several axes in a rapid"),
              {{tr("Straight, all axes arrive together"), tr("Each axis at its own rate (with bends)"),
                tr("Straight, the tip at the rapid feed")},
               [](const MachineProfile& m) { return static_cast<int>(m.rapids); },
               [](MachineProfile& m, int index) { m.rapids = static_cast<RapidMode>(index); }});
}

void MachineForm::addAccelerations() {
    using namespace machine_range;
    addTitle(tr("Accelerations"));
    addNumbers("acceleration_mm_per_s2", tr("Acceleration"), tr("For axes without a value of their own"),
               {{Quantity::acceleration, acceleration, false, [](const MachineProfile& m) { return m.acceleration; },
                 [](MachineProfile& m, double value) { m.acceleration = value; }}});
    const auto axis = [](Quantity quantity, NumberRange range, glm::dvec3 MachineProfile::*member, int i) {
        return Number{quantity, range, true, [member, i](const MachineProfile& m) { return (m.*member)[i]; },
                      [member, i](MachineProfile& m, double value) { (m.*member)[i] = value; }};
    };
    std::vector<Number> accelerations, jerks;
    for (int i = 0; i < 3; ++i) {
        accelerations.push_back(axis(Quantity::acceleration, acceleration, &MachineProfile::axisAccelerations, i));
        jerks.push_back(axis(Quantity::jerk, jerk, &MachineProfile::axisJerks, i));
    }
    addNumbers("axis_accelerations_mm_per_s2", tr("Acceleration X, Y, Z"), tr("Of each axis"),
               std::move(accelerations));
    addNumbers("axis_jerks_mm_per_s3", tr("Jerk X, Y, Z"), tr("Limit of each axis"), std::move(jerks));
}

void MachineForm::addSpindle() {
    using namespace machine_range;
    addTitle(tr("Spindle"));
    const auto own = [](Quantity quantity, NumberRange range, bool optional, double MachineProfile::*member) {
        return Number{quantity, range, optional, [member](const MachineProfile& m) { return valueOf(m, member); },
                      [member](MachineProfile& m, double value) { m.*member = value; }};
    };
    addNumbers("minimum_spindle_speed_rpm", tr("Lowest speed"), tr("At most the highest speed"),
               {own(Quantity::rotation, spindleSpeed, false, &MachineProfile::minimumSpindleSpeed)});
    addNumbers("maximum_spindle_speed_rpm", tr("Highest speed"), tr("Above 0"),
               {own(Quantity::rotation, spindleSpeed, false, &MachineProfile::maximumSpindleSpeed)});
    addNumbers("spindle_power_w", tr("Power"), tr("Continuous power of the spindle"),
               {own(Quantity::power, spindlePower, true, &MachineProfile::spindlePower)});
    addTorque();
}

void MachineForm::addCoolant() {
    addTitle(tr("Coolant"));
    static constexpr Coolant mist = Coolant::mist, flood = Coolant::flood;
    const auto index = [](const MachineProfile& m) {
        if (!m.coolants) return 0;
        return 1 + (m.has(mist) ? 1 : 0) + (m.has(flood) ? 2 : 0);
    };
    const auto choose = [](MachineProfile& m, int chosen) {
        m.coolants.reset();
        if (chosen == 0) return;
        m.coolants.emplace();
        if (((chosen - 1) & 1) != 0) m.coolants->push_back(mist);
        if (((chosen - 1) & 2) != 0) m.coolants->push_back(flood);
    };
    addChoice("coolant", tr("Coolant"), tr("Coolant that the machine can switch on"),
              {{tr("Not stated"), tr("None"), tr("Mist"), tr("Flood"), tr("Mist and flood")}, index, choose});
}

void MachineForm::addControl() {
    using namespace machine_range;
    addTitle(tr("Control"));
    addChoice("junctions", tr("Corners"), tr("Motion from one block to the next"),
              {{tr("Exact stop"), tr("As an arc within the tolerance"), tr("Blended within the tolerance")},
               [](const MachineProfile& m) { return static_cast<int>(m.junctions); },
               [](MachineProfile& m, int index) { m.junctions = static_cast<JunctionRule>(index); }});
    addNumbers("junctions.tolerance_mm", tr("Tolerance of corners"),
               tr("Largest distance of the motion from a corner; above 0 unless the machine stops there"),
               {{Quantity::length, tolerance, false, [](const MachineProfile& m) { return m.junctionTolerance; },
                 [](MachineProfile& m, double value) { m.junctionTolerance = value; }}},
               false);
    addNumbers("blocks_per_second", tr("Blocks per second"), tr("Maximum that the control executes"),
               {{Quantity::rate, blockRate, true, [](const MachineProfile& m) { return m.blocksPerSecond; },
                 [](MachineProfile& m, double value) { m.blocksPerSecond = value; }}});
    addNumbers(
        "coordinate_decimals", tr("Decimal places"), tr("Decimal places of a coordinate in mm"),
        {{Quantity::count,
          {fewestDecimals, mostDecimals},
          false,
          [](const MachineProfile& m) { return static_cast<double>(m.coordinateDecimals); },
          [](MachineProfile& m, double value) { m.coordinateDecimals = static_cast<int>(std::lround(value)); }}});
    addNumbers("maximum_line_length", tr("Characters per line"), tr("Maximum that the control reads"),
               {{Quantity::count,
                 {shortestLine, longestLine},
                 false,
                 [](const MachineProfile& m) { return static_cast<double>(m.maximumLineLength); },
                 [](MachineProfile& m, double value) { m.maximumLineLength = static_cast<int>(std::lround(value)); }}});
}

void MachineForm::addArcs() {
    using namespace machine_range;
    addTitle(tr("Arcs"));
    constexpr double degree = pi / 180.0;
    const auto rule = [](Quantity quantity, NumberRange range, double ArcRules::*member) {
        return Number{quantity, range, false, [member](const MachineProfile& m) { return m.arcs.*member; },
                      [member](MachineProfile& m, double value) { m.arcs.*member = value; }};
    };
    addNumbers("arcs", tr("Largest sweep"), tr("Of one block; 360° is a full circle"),
               {rule(Quantity::angle, {sweep.low * degree, sweep.high * degree}, &ArcRules::largestSweep)});
    addNumbers("arcs.smallest_radius_mm", tr("Smallest radius"), tr("Below the largest radius"),
               {rule(Quantity::length, radius, &ArcRules::smallestRadius)}, false);
    addNumbers("arcs.largest_radius_mm", tr("Largest radius"), tr("Larger arcs are written as lines"),
               {rule(Quantity::length, radius, &ArcRules::largestRadius)}, false);
    addNumbers("arcs.radius_mismatch_mm", tr("Difference of the radii"), tr("Allowed between start and end of an arc"),
               {rule(Quantity::length, tolerance, &ArcRules::radiusMismatch)}, false);
}

void MachineForm::addTorque() {
    torque_ = new TorqueTable(this);
    const int row =
        beginRow(tr("Torque over speed"), torque_,
                 tr("Continuous torque of the spindle. Between two points the power follows a straight line; without "
                    "points: not stated"));
    placeWide(torque_, row);
    connect(torque_, &TorqueTable::edited, this, [this](const std::vector<SpindlePoint>& points) {
        record_.spindleTorque = points;
        changed("spindle_torque");
    });
    onRefresh([this] { torque_->showPoints(record_.spindleTorque); });
    addSource("spindle_torque", tr("Torque over speed"), row);
}

void MachineForm::setDialects(const QStringList& names, const QStringList& ids) {
    dialectNames_ = QStringList{tr("Not stated")} + names;
    dialectIds_ = QStringList{QString()} + ids;
    refresh();
}

void MachineForm::showMachine(const MachineProfile& machine, bool locked) {
    record_ = machine;
    lock(locked);
    torque_->setEnabled(true); // enabled, so that it can be viewed
    torque_->setReadOnly(locked);
    refresh();
}

} // namespace burin
