// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace burin::testing {

/// One device of the stand-in for libHD. Its own frame: x right, y up, z towards the user.
struct HdDevice {
    std::array<double, 16> transform{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; ///< column-major, mm
    int buttons = 0;
    double heat = 0.0;
    bool plugged = true;
    int outputFreedoms = 3;
    double stiffness = 0.5;            ///< N/mm
    unsigned int calibration = 0x5000; ///< what hdCheckCalibration returns
    unsigned int afterUpdate = 0x5000; ///< what it returns after an update
    int calibrationStyles = 4;
    unsigned int updatedWith = 0; ///< style of the latest update
    bool initialised = false, forcesOn = false;
    std::array<double, 3> force{}, torque{}; ///< N, mN·m: output of the motors
    std::array<double, 3> setForce{};        ///< of the current frame
    int frames = 0;
};

/// State behind the functions, which a test sets and reads, and complaints about calls that the reference forbids. All
/// fields are protected by `mutex`, except from the test while nothing runs.
class HdStandIn {
public:
    std::recursive_mutex mutex;
    std::map<std::string, HdDevice> devices; ///< by the name passed to hdInitDevice
    std::vector<std::string> complaints;
    unsigned long rate = 0;
    int initialisations = 0;
    bool byHand = true; ///< without a thread: `step` is the scheduler's tick
    /// A hand moves the device along a circle 20 mm wide, once a second, and holds its first button. A program that is
    /// started with BURIN_STAND_IN_TOUCH set begins in this state, with a device and without `byHand`.
    bool circles = false;

    virtual ~HdStandIn() = default;
    virtual void reset();
    /// One tick of the scheduler, if it is started.
    virtual void step();
    /// Behaves as if the last call had failed. @param device  0: the current one
    virtual void raise(unsigned int code, unsigned int device = 0);
    bool schedulerRuns() const { return running_; }

    struct Scheduled {
        unsigned int (*callback)(void*) = nullptr;
        void* self = nullptr;
    };
    HdDevice* find(unsigned int handle);
    void complain(const std::string& what) { complaints.push_back(what); }
    unsigned int connect(const char* name);
    void start();
    void stop();

    std::vector<std::pair<unsigned int, unsigned int>> errors_; ///< code and device
    std::map<unsigned int, std::string> handles_;
    std::map<unsigned long, Scheduled> scheduled_;
    unsigned int current_ = 0xffffffffU, framed_ = 0xffffffffU;
    bool running_ = false;
    unsigned long next_ = 1;
};

/// The single instance in the process, inside the library; a test finds it there as "burinHdStandIn" by means of
/// StandIn.
extern "C" HdStandIn* burinHdStandIn();

} // namespace burin::testing
