// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/nc/apt_reader.h"

#include "core/base/numbers.h"
#include "core/base/trimmed.h"
#include "core/machine/kinematics.h"
#include "core/nc/line_walker.h"
#include "core/nc/problem.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

namespace burin {

namespace {

constexpr std::string_view spaces = " \t\r\f\v";
constexpr double millimetresPerInch = 25.4;
constexpr double uprightWithin = 1e-6;      // of a unit vector's components
constexpr double unitWithin = 1e-3;         // of its length, rounded
constexpr double onCircleWithin = 0.01;     // mm by which the ends of an arc may lie off its circle
constexpr double farthest = 1e6;            // mm from zero, of a position
constexpr double fastest = 1e9;             // mm/min
constexpr std::size_t longestRecord = 4096; // characters, continued lines included

/// "GOTO / 1, 2, 3": the word before the slash, and what follows it. In capitals.
struct Record {
    std::string word;
    std::vector<std::string> data;
    std::uint32_t line = 0; ///< in the text, from 1, at which it begins

    bool has(std::string_view wanted) const { return std::ranges::find(data, wanted) != data.end(); }
    /// The numbers from position `from` on, up to the first item that is not a number.
    std::vector<double> numbers(std::size_t from = 0) const {
        std::vector<double> read;
        for (std::size_t i = from; i < data.size(); ++i) {
            const std::optional<double> number = parseNumber(data[i]);
            if (!number) break;
            read.push_back(*number);
        }
        return read;
    }
};

std::string inCapitals(std::string_view text) {
    std::string capitals(trimmed(text, spaces));
    std::ranges::transform(capitals, capitals.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return capitals;
}

/// Words followed by text, with or without a slash; the text may contain slashes.
constexpr std::array textWords{std::string_view("PARTNO"), std::string_view("PPRINT"), std::string_view("REMARK")};

Record recordOf(std::string_view text, std::uint32_t line) {
    Record record;
    record.line = line;
    const std::string first = inCapitals(text.substr(0, text.find_first_of(" \t/")));
    if (std::ranges::find(textWords, first) != textWords.end()) {
        record.word = first;
        record.data.emplace_back(text.substr(first.size()));
        return record;
    }
    const std::size_t slash = text.find('/');
    record.word = inCapitals(text.substr(0, slash));
    if (slash == std::string_view::npos) return record;
    for (std::string_view rest = text.substr(slash + 1);;) {
        const std::size_t comma = rest.find(',');
        record.data.push_back(inCapitals(rest.substr(0, comma)));
        if (comma == std::string_view::npos) return record;
        rest.remove_prefix(comma + 1);
    }
}

/// Joins continued lines and skips comments.
class RecordReader {
public:
    explicit RecordReader(std::string_view text) : lines_(text) {}

    /// Returns the next record. Empty at the end of the text; a record with an empty word if it is too long.
    std::optional<Record> next() {
        std::string text;
        std::uint32_t first = 0;
        while (const std::optional<std::string_view> line = lines_.next()) {
            std::string_view part = *line;
            part = trimmed(part.substr(0, part.find("$$")), spaces);
            if (part.empty() && text.empty()) continue;
            if (text.empty()) first = lines_.number();
            const bool goesOn = part.ends_with('$');
            if (goesOn) part.remove_suffix(1);
            text += part;
            if (text.size() > longestRecord) return Record{{}, {}, first};
            if (!goesOn) break;
        }
        if (text.empty()) return std::nullopt;
        return recordOf(text, first);
    }

private:
    LineWalker lines_;
};

constexpr std::array motionWords{std::string_view("GOTO"), std::string_view("GODLTA"), std::string_view("FEDRAT"),
                                 std::string_view("LOADTL"), std::string_view("PARTNO")};

/// Whether a record does not affect where the tool goes and at which feed.
bool movesNothing(const Record& record) {
    if (std::ranges::find(textWords, record.word) != textWords.end()) return true;
    // MSYS gives the position of the coordinate frame in the model; that frame is the program's zero here.
    constexpr std::array words{"MACHIN", "CUTTER", "INTOL",   "OUTTOL", "TOLER",     "TPRINT", "PAINT",  "DISPLY",
                               "CLDIST", "TOOLNO", "CLEARP",  "SELECT", "OPSTOP",    "STOP",   "MULTAX", "REWIND",
                               "UNLOAD", "LINTOL", "CATMAT",  "SEQNO",  "TOOL PATH", "TLDATA", "MSYS",   "END-OF-PATH",
                               "AUXFUN", "DATE",   "LOADLIB", "END",    "FINI"};
    return std::ranges::find(words, record.word) != words.end();
}

/// Converts records to motions, one after the other.
class CutterLocations {
public:
    /// @param kinematics for tilted tools, with the program's zero at the origin; null: refuses them
    explicit CutterLocations(const Kinematics* kinematics) : kinematics_(kinematics) {}

    /// Empty if the record was accepted, otherwise the reason why it can't be.
    std::optional<std::string> take(const Record& record) {
        const std::string& word = record.word;
        if (word == "GOTO" || word == "FROM") return go(record, word == "FROM");
        if (word == "GODLTA") return goBy(record);
        if (word == "RAPID") {
            rapid_ = true;
            return {};
        }
        if (word == "CIRCLE" || word == "MOVARC") return turn(record);
        if (word == "FEDRAT") return feed(record);
        if (word == "SPINDL") return spindle(record);
        if (word == "UNITS") return units(record);
        if (word == "LOADTL" || word == "LOAD") return load(record);
        if (word == "COOLNT") return coolant(record);
        if (word == "DELAY") return dwell(record);
        if (word == "TLAXIS") return setAxis(record.numbers());
        if ((word == "CYCLE" || word == "CUTCOM") && (record.has("OFF") || record.has("NOMORE"))) return {};
        if (word == "END" || word == "FINI") made_.ended = true;
        if (movesNothing(record)) return {};
        return "a record that Burin can't follow: " + shownWords(word, 0, word.size());
    }
    ParsedProgram finish(std::size_t records) {
        made_.blocks = records;
        return std::move(made_);
    }

private:
    using Problem = std::optional<std::string>;

    Problem tilted() const {
        const bool never = kinematics_ == nullptr || kinematics_->axes() == linearAxes;
        return never ? "a tool axis other than +Z" : "a tool axis that the machine can't reach";
    }
    Problem setAxis(const std::vector<double>& numbers) {
        if (numbers.size() != 3) return incomplete();
        const glm::dvec3 axis(numbers[0], numbers[1], numbers[2]);
        const double length = glm::length(axis);
        if (!(std::abs(length - 1.0) <= unitWithin)) return "a tool axis that is not of unit length";
        const bool upright = std::abs(axis.x) <= uprightWithin && std::abs(axis.y) <= uprightWithin && axis.z > 0.0;
        if (!upright && (kinematics_ == nullptr || !kinematics_->axesOf({glm::dvec3(0.0), axis / length})))
            return tilted();
        axis_ = upright ? uprightAxis : axis / length;
        return {};
    }
    /// The values of the axes for a tip, with the tool axis in force.
    AxisValues valuesAt(const glm::dvec3& tip) const {
        if (axis_ == uprightAxis && values_.onlyLinear()) return AxisValues(tip);
        Result<AxisValues> values = kinematics_->axesNear({tip, axis_}, values_); // setAxis has tried it
        return values ? std::move(*values) : AxisValues(tip);
    }
    static Problem incomplete() { return "numbers are missing"; }

    NcMotion begin(const Record& record, NcMotionKind kind) const {
        NcMotion motion;
        motion.kind = kind;
        motion.spindle = spindle_;
        motion.spindleSpeed = speed_;
        motion.mist = mist_;
        motion.flood = flood_;
        motion.tool = tool_;
        motion.line = record.line;
        motion.column = 1;
        motion.from = values_;
        motion.from.setLinear(place_.value_or(glm::dvec3(0.0)));
        // Without a tool axis, cutter locations say nothing about rotary axes: these stay as they are set up.
        motion.fromKnown = place_ ? allAxes : AxisSet{};
        motion.toKnown = allAxes;
        return motion;
    }
    Problem go(const Record& record, bool from) {
        const std::vector<double> numbers = record.numbers();
        if (numbers.size() != record.data.size() || (numbers.size() != 3 && numbers.size() != 6)) return incomplete();
        if (numbers.size() == 6)
            if (const Problem problem = setAxis({numbers.begin() + 3, numbers.end()})) return problem;
        const glm::dvec3 to = unit_ * glm::dvec3(numbers[0], numbers[1], numbers[2]);
        if (from) {
            if (!inReach(to)) return "a position more than 1e6 mm away";
            place_ = to;
            values_ = valuesAt(to);
            return {};
        }
        return goTo(record, to);
    }
    Problem goBy(const Record& record) {
        const std::vector<double> by = record.numbers();
        if (by.size() != record.data.size() || (by.size() != 3 && by.size() != 1)) return incomplete();
        if (!place_) return "a step from a position that is not stated";
        return goTo(record,
                    *place_ + unit_ * (by.size() == 1 ? glm::dvec3(0.0, 0.0, by[0]) : glm::dvec3(by[0], by[1], by[2])));
    }
    static bool inReach(const glm::dvec3& place) {
        return std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) <= farthest;
    }

    Problem goTo(const Record& record, const glm::dvec3& to) {
        if (!inReach(to)) return "a position more than 1e6 mm away";
        const auto arc = std::exchange(arc_, std::nullopt);
        NcMotion motion = begin(record, rapid_ ? NcMotionKind::rapid : arc ? NcMotionKind::arc : NcMotionKind::line);
        rapid_ = false;
        motion.to = values_ = valuesAt(to);
        if (motion.kind != NcMotionKind::rapid) {
            motion.feed = feedPerTurn_ ? feed_ * speed_ : feed_;
            if (!(motion.feed > 0.0)) return "a move without a feed";
            if (!(motion.feed <= fastest)) return "a feed beyond 1e9 mm/min";
        }
        if (motion.kind == NcMotionKind::arc) {
            if (!place_) return "an arc from a position that is not stated";
            motion.centre = arc->centre;
            motion.clockwise = arc->clockwise;
            for (const glm::dvec3& end : {*place_, to})
                if (std::abs(std::hypot(end.x - arc->centre.x, end.y - arc->centre.y) - arc->radius) > onCircleWithin)
                    return "an arc whose ends do not lie on its circle";
        }
        place_ = to;
        made_.motions.push_back(std::move(motion));
        return {};
    }
    /// CIRCLE or MOVARC / centre, axis, radius: ends at the next GOTO.
    Problem turn(const Record& record) {
        const std::vector<double> numbers = record.numbers();
        if (numbers.size() < 7) return incomplete();
        const glm::dvec3 axis(numbers[3], numbers[4], numbers[5]);
        if (std::abs(axis.x) > uprightWithin || std::abs(axis.y) > uprightWithin ||
            std::abs(std::abs(axis.z) - 1.0) > uprightWithin)
            return "an arc about an axis other than Z";
        if (!inReach(unit_ * glm::dvec3(numbers[0], numbers[1], numbers[2])) ||
            !(std::abs(unit_ * numbers[6]) <= farthest))
            return "a position more than 1e6 mm away";
        arc_ = Turn{unit_ * glm::dvec3(numbers[0], numbers[1], numbers[2]), unit_ * numbers[6], axis.z < 0.0};
        return {};
    }
    Problem feed(const Record& record) {
        const std::vector<double> numbers = record.numbers();
        if (numbers.empty()) return record.has("RAPID") ? setRapid() : incomplete();
        const double inches = record.has("IPM") || record.has("IPR")     ? millimetresPerInch
                              : record.has("MMPM") || record.has("MMPR") ? 1.0
                                                                         : unit_;
        feed_ = numbers[0] * inches;
        feedPerTurn_ = record.has("MMPR") || record.has("IPR") || record.has("PERREV");
        if (record.has("INVERS")) return "a feed by inverse time";
        if (!(feed_ > 0.0)) return "a feed that is not above 0";
        return {};
    }
    Problem setRapid() {
        rapid_ = true;
        return {};
    }
    Problem spindle(const Record& record) {
        if (record.has("OFF")) {
            spindle_ = SpindleState::off;
            return {};
        }
        if (record.has("SFM") || record.has("SMM")) return "a spindle speed as surface speed";
        for (const std::string& word : record.data)
            if (const std::optional<double> number = parseNumber(word)) speed_ = *number;
        if (!(speed_ >= 0.0)) return "a spindle speed below 0";
        if (record.has("CCLW")) clockwise_ = false;
        if (record.has("CLW")) clockwise_ = true;
        spindle_ = clockwise_ ? SpindleState::clockwise : SpindleState::anticlockwise;
        made_.maximumSpindleSpeed = std::max(made_.maximumSpindleSpeed, speed_);
        return {};
    }
    Problem units(const Record& record) {
        if (record.has("MM"))
            unit_ = 1.0;
        else if (record.has("INCHES") || record.has("INCH"))
            unit_ = millimetresPerInch;
        else
            return "a unit other than MM and INCHES";
        return {};
    }
    Problem load(const Record& record) {
        const std::vector<double> numbers = record.numbers(record.word == "LOAD" ? 1 : 0);
        if (numbers.empty()) return incomplete();
        if (!(numbers[0] >= 0.0 && numbers[0] < 1e6 && numbers[0] == std::floor(numbers[0])))
            return "a tool number that is not whole";
        tool_ = static_cast<int>(numbers[0]);
        place_.reset(); // the tool change takes place somewhere else
        return {};
    }
    Problem coolant(const Record& record) {
        mist_ = record.has("MIST");
        flood_ = !mist_ && !record.has("OFF");
        return {};
    }
    Problem dwell(const Record& record) {
        const std::vector<double> numbers = record.numbers();
        if (numbers.empty()) return incomplete();
        NcMotion motion = begin(record, NcMotionKind::dwell);
        motion.to = motion.from;
        motion.toKnown = motion.fromKnown;
        motion.seconds = numbers[0];
        made_.motions.push_back(std::move(motion));
        return {};
    }

    struct Turn {
        glm::dvec3 centre;
        double radius; ///< mm
        bool clockwise;
    };
    ParsedProgram made_;
    std::optional<glm::dvec3> place_; ///< position of the tip, mm
    const Kinematics* kinematics_;
    glm::dvec3 axis_{uprightAxis};    ///< of the tool
    AxisValues values_;               ///< at the last position
    std::optional<Turn> arc_;         ///< of the next move
    double unit_ = 1.0;               ///< mm
    double feed_ = 0.0, speed_ = 0.0; ///< mm/min, or mm per turn; 1/min
    SpindleState spindle_ = SpindleState::off;
    int tool_ = 0;
    bool rapid_ = false, feedPerTurn_ = false, clockwise_ = true, mist_ = false, flood_ = false;
};

} // namespace

bool isCutterLocations(std::string_view text) {
    if (text.find('\0') != std::string_view::npos) return false;
    RecordReader records(text);
    std::size_t motions = 0, read = 0;
    for (std::optional<Record> record = records.next(); record && read < 2000; record = records.next(), ++read)
        if (!record->data.empty() && std::ranges::find(motionWords, record->word) != motionWords.end()) ++motions;
    return motions > 0 && 2 * motions + 20 >= read;
}

Result<ParsedProgram> parseCutterLocations(std::string_view text, const std::string& origin,
                                           const Kinematics* kinematics) {
    CutterLocations locations(kinematics);
    RecordReader records(text);
    std::size_t count = 0;
    while (const std::optional<Record> record = records.next()) {
        const std::optional<std::string> problem =
            record->word.empty() ? std::string(wordingOf(ProgramProblem::lineTooLong)) : locations.take(*record);
        if (problem) return Error{ErrorCode::programSyntax, origin, "line " + std::to_string(record->line), *problem};
        ++count;
        if (record->word == "FINI") break;
    }
    return locations.finish(count);
}

} // namespace burin
