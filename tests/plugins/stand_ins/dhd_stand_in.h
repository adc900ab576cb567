// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <mutex>
#include <string>
#include <vector>

namespace burin::testing {

/// One device of the stand-in for libdrd. Its own frame: x towards the user, y right, z up.
struct DhdDevice {
    int type = 33; ///< omega.3
    std::string name = "omega.3";
    bool plugged = true, open = false, initialised = true, canInitialise = true;
    bool wrist = false, activeWrist = false, gripper = false;
    std::array<double, 3> place{};                                                    ///< m
    std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; ///< rows
    unsigned int buttons = 0;
    int failingReads = 0; ///< number of poses that will be refused
    bool deaf = false;    ///< refuses forces

    bool forcesOn = false, regulated = false, emulatesButton = false;
    int cause = 0;                 ///< why its forces are off
    std::array<double, 6> asked{}; ///< N, N·m
    double maximumForce = 0.0;     ///< N
    int watchdog = 0, gravity = 0, brakes = 0, autoInitialisations = 0, forcesSwitchedOn = 0;

    /// The output of its motors, N.
    std::array<double, 3> force() const {
        if (!forcesOn || !plugged) return {};
        return {asked[0], asked[1], asked[2]};
    }
    /// Switches the forces off, as the device itself does.
    void cut(int why) {
        forcesOn = false;
        cause = why;
    }
};

/// State behind the functions. Everything is protected by `mutex`, except from the test while nothing runs.
class DhdStandIn {
public:
    std::recursive_mutex mutex;
    std::vector<DhdDevice> devices;
    std::vector<std::string> complaints;

    void complain(const std::string& what) { complaints.push_back(what); }
    /// The open device with an ID; null, with a complaint, if there is none.
    DhdDevice* find(char id, const char* call);
};

/// The single instance in the process, inside the library; a test finds it there as "burinDhdStandIn" by means of
/// StandIn.
extern "C" DhdStandIn* burinDhdStandIn();

} // namespace burin::testing
