// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/haptics/force/suggested_gains.h"
#include "ui/theme/length_unit.h"
#include "ui/theme/theme.h"

#include <QMap>
#include <QSettings>
#include <QString>
#include <QStringList>

#include <string>
#include <utility>

namespace burin {

/// Settings of a user for all projects.
struct Preferences {
    Theme theme = Theme::dark;
    LengthUnit unit = LengthUnit::millimetre;
    QString language; ///< "en", "de", "zh_CN"; empty: the system's
    friend bool operator==(const Preferences&, const Preferences&) = default;
};

/// Stores preferences, recent files and the window's position: one file in the user's configuration folder.
class UserSettings {
public:
    UserSettings();

    Preferences preferences() const;
    void setPreferences(const Preferences& preferences);

    static constexpr int maximumRecentFiles = 8;
    QStringList recentFiles() const; ///< newest first
    void addRecentFile(const QString& file);
    void removeRecentFile(const QString& file);
    bool isRecentFile(const QString& file) const; ///< even if it no longer exists

    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);
    QByteArray panelWidth() const; ///< state of the splitter between view and panel
    void setPanelWidth(const QByteArray& state);
    QByteArray viewDocks() const; ///< state of the docks next to the view
    void setViewDocks(const QByteArray& state);
    bool programDocked() const; ///< whether the program's text is next to the view
    void setProgramDocked(bool docked);
    bool timelineShown() const;
    void setTimelineShown(bool shown);
    QStringList timelineCurves() const; ///< names of the enabled curves
    void setTimelineCurves(const QStringList& curves);
    /// Shortcuts that the user assigned to actions, by object name; an empty text: none.
    QMap<QString, QString> shortcuts() const;
    void setShortcuts(const QMap<QString, QString>& shortcuts);
    bool metersFolded() const;
    void setMetersFolded(bool folded);
    bool parallelView() const;
    void setParallelView(bool parallel);
    bool placementHandles() const; ///< whether the view shows handles that move the part or a fixture
    void setPlacementHandles(bool shown);
    int transparency() const; ///< of the workpiece, %
    void setTransparency(int percent);
    /// Id and mode of the stylus chosen last; both empty: the mouse.
    std::pair<std::string, std::string> chosenDevice() const;
    void setChosenDevice(const std::string& id, const std::string& mode);
    std::string viewDevice() const; ///< id of the device that moves the view; empty: none
    void setViewDevice(const std::string& id);
    FeltCutting felt(const std::string& device) const; ///< rendering of the cutting forces by one device
    void setFelt(const std::string& device, const FeltCutting& felt);
    KeptGains gains(const std::string& device) const; ///< of one device
    /// @return the file that could not be written; empty: it was
    QString setGains(const std::string& device, const KeptGains& gains);
    /// Whether, and how far, shank and holder keep away from the stock.
    StockLayer stockLayer() const;
    void setStockLayer(const StockLayer& layer);
    /// Whether the pressure of a pen makes the tool sink instead of setting its depth.
    bool penSinks() const;
    void setPenSinks(bool sinks);
    double penSinkSpeed() const; ///< mm/s at full pressure, 0.1 … 50
    void setPenSinkSpeed(double speed);
    /// Assignment and calibration of a device's axes as toJson (core/device/axis_map_json.h) wrote them; empty: the
    /// usual.
    std::string axisMap(const std::string& device) const;
    /// @return the file that could not be written; empty: it was
    QString setAxisMap(const std::string& device, const std::string& map);
    bool firstJobFinished() const; ///< whether the user has completed the guided first job
    void setFirstJobFinished(bool finished);
    QString lastFolder() const; ///< folder of the file chosen last; empty: none yet
    void setLastFolder(const QString& folder);

private:
    QSettings settings_;
};

} // namespace burin
