// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/verify/program_settings.h"

#include "core/machine/kinematics.h"
#include "core/nc/control.h"

#include <algorithm>
#include <memory>

namespace burin {

namespace {

bool feeds(const NcMotion& motion) noexcept {
    return motion.kind == NcMotionKind::line || motion.kind == NcMotionKind::arc;
}

/// Follows the program, setting by setting and move by move.
class SettingsJudge {
public:
    SettingsJudge(const VerifyRequest& request, Findings& findings)
        : request_(request)
        , findings_(findings)
        , kinematics_(kinematicsOf(request.machine, request.setup.workOffset))
        , lengths_(request.control != nullptr && request.control->readsG(gcode::lengthOffset))
        , changes_(request.control != nullptr && request.control->readsM(60)) {}

    void run() {
        const ParsedProgram& program = *request_.program;
        auto setting = program.settings.begin();
        for (std::size_t i = 0; i < program.motions.size(); ++i) {
            for (; setting != program.settings.end() && setting->motions <= i; ++setting) take(*setting);
            look(program.motions[i]);
        }
    }

private:
    void take(const NcSetting& setting) {
        switch (setting.kind) {
        case NcSettingKind::toolSelected:
            named_ = true;
            break;
        case NcSettingKind::toolChange:
            toolLine_ = setting.line;
            lengthTold_ = false;
            judgeTool(setting);
            break;
        case NcSettingKind::lengthOffset:
            lengthLine_ = setting.line;
            lengthTold_ = false;
            named_ = named_ || setting.value > 0;
            break;
        case NcSettingKind::workOffset:
            offsetLine_ = setting.line;
            break;
        case NcSettingKind::spindle:
            spindleLine_ = setting.line;
            break;
        case NcSettingKind::shift:
        case NcSettingKind::distance:
        case NcSettingKind::pathControl:
            break;
        }
    }

    void judgeTool(const NcSetting& setting) {
        if (request_.tools.empty() || setting.value == 0 ||
            std::ranges::find(request_.tools, setting.value, &Tool::number) != request_.tools.end())
            return;
        const std::vector<NcMotion>& motions = request_.program->motions;
        const glm::dvec3 place =
            setting.motions < motions.size() ? placeOf(motions[setting.motions]) : request_.setup.workOffset;
        findings_.add(FindingKind::toolUnknown, setting.line, place, setting.value);
    }

    void look(const NcMotion& motion) {
        if (motion.takesAny() && motion.workOffset != request_.workOffset)
            findings_.add(FindingKind::workOffsetOther, offsetLine_, placeOf(motion), motion.workOffset);
        if (lengths_ && motion.takes(Axis::z)) judgeLength(motion);
        if (!feeds(motion)) return;
        if (changes_ && motion.tool == 0 && named_ && !loadTold_) {
            loadTold_ = true;
            findings_.add(FindingKind::toolNotLoaded, motion.line, placeOf(motion), 0.0);
        }
        if (motion.spindle == SpindleState::anticlockwise && motion.spindleOn())
            findings_.add(FindingKind::spindleReversed, spindleLine_, placeOf(motion), motion.spindleSpeed);
    }

    /// A length that the program states itself (G43.1) is accepted.
    void judgeLength(const NcMotion& motion) {
        if (lengthTold_ || motion.tool == 0 || motion.lengthOffset < 0 || motion.lengthOffset == motion.tool) return;
        lengthTold_ = true;
        if (motion.lengthOffset > 0 && lengthLine_ >= toolLine_)
            findings_.add(FindingKind::lengthOffsetOfOther, lengthLine_, placeOf(motion), motion.lengthOffset);
        else
            findings_.add(FindingKind::lengthOffsetMissing, motion.line, placeOf(motion), motion.tool);
    }

    /// Where a motion ends, setup frame.
    glm::dvec3 placeOf(const NcMotion& motion) const { return kinematics_->poseOf(motion.to).tip; }

    const VerifyRequest& request_;
    Findings& findings_;
    std::unique_ptr<const Kinematics> kinematics_;
    bool lengths_;       ///< the control has length offsets by number
    bool changes_;       ///< the control has M6
    bool named_ = false; ///< a tool was named, by T or H
    bool loadTold_ = false, lengthTold_ = false;
    std::uint32_t toolLine_ = 0, lengthLine_ = 0, offsetLine_ = 1, spindleLine_ = 0; ///< lines of the settings in force
};

} // namespace

void judgeSettings(const VerifyRequest& request, Findings& findings) {
    SettingsJudge(request, findings).run();
}

} // namespace burin
