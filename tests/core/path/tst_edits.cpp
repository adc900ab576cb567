// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/path/edit_step.h"
#include "path_fixture.h"
#include "tests/test_program.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace burin::tst_edits {

using namespace burin::test;

namespace {

/// A valid value of a parameter, other than its default.
struct Another {
    const EditField& field;
    EditValue operator()(double value) const { return value == field.high ? field.low : field.high; }
    EditValue operator()(bool value) const { return !value; }
    EditValue operator()(std::string_view value) const {
        return value == field.choices.back().name ? field.choices.front().name : field.choices.back().name;
    }
    EditValue operator()(const glm::dvec3&) const { return glm::dvec3(1.5, field.low, field.high); }
    EditValue operator()(const std::vector<glm::dvec3>&) const {
        return std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0.25}, {0, 1, 0}};
    }
    EditValue operator()(const Moment&) const { return Moment{3, 141}; }
    EditValue operator()(const SourceInterval&) const { return SourceInterval{2, 7, 18}; }
};

/// Invalid values.
struct Strange {
    const EditField& field;
    using Values = std::vector<EditValue>;
    Values operator()(double) const {
        Values values{field.low - 1e-3, field.high + 1.0, std::numeric_limits<double>::quiet_NaN()};
        if (field.whole) values.push_back(0.5 + std::floor(0.5 * (field.low + field.high)));
        return values;
    }
    Values operator()(bool) const { return {}; }
    Values operator()(std::string_view) const { return {}; }
    Values operator()(const glm::dvec3&) const { return {glm::dvec3(0, 0, std::numeric_limits<double>::infinity())}; }
    Values operator()(const std::vector<glm::dvec3>&) const {
        const glm::dvec3 nowhere(0, std::numeric_limits<double>::quiet_NaN(), 0);
        Values values{std::vector<glm::dvec3>(5, nowhere)};
        if (field.low > 1.0) values.emplace_back(std::vector<glm::dvec3>{{0, 0, 0}}); // too few
        return values;
    }
    Values operator()(const Moment&) const { return {Moment{1, -1}, Moment{-1, -1}}; }
    Values operator()(const SourceInterval&) const { return {SourceInterval{1, 5, 4}, SourceInterval{-1, -2, 4}}; }
};

} // namespace

class TestEdits : public QObject {
    Q_OBJECT

private slots:
    /// The target of a levelled feed is a force or a removal rate, depending on its goal; files of earlier versions do
    /// not state which.
    void theTargetOfALevelHasItsUnitInItsKey() {
        FeedOptimisation level;
        level.goal = FeedOptimisation::Goal::removal;
        level.target = 250.0;
        const std::string json = toJson(Edit{level, true});
        QVERIFY(json.find("\"target_mm3_s\":250.0") != std::string::npos);
        for (const char* text : {R"({"edit":"level-feed","target_mm3_s":250.0,"goal":"removal"})",
                                 R"({"edit":"level-feed","target":250.0,"goal":"removal"})"}) {
            const Result<Edit> read = editFromJson(text);
            QVERIFY(read);
            QCOMPARE(toJson(*read), json);
        }
        const Result<Edit> wrong = editFromJson(R"({"edit":"level-feed","target_n":250.0,"goal":"removal"})");
        QCOMPARE(wrong.error().subject, std::string("target_n"));
    }
    void everyEditComesBackFromItsText() {
        std::vector<Edit> edits = standardEdits();
        std::get<SmoothShape>(edits[2].parameters).wavelength = 4.25;
        edits[1].enabled = false;
        for (const Edit& edit : edits) {
            const auto back = editFromJson(toJson(edit));
            QVERIFY2(back, toJson(edit).c_str());
            QCOMPARE(QString::fromStdString(toJson(*back)), QString::fromStdString(toJson(edit)));
            QVERIFY(back->parameters.index() == edit.parameters.index() && back->enabled == edit.enabled);
            QVERIFY(titleOf(edit.parameters).text[0] != '\0');
            QVERIFY(!idOf(edit.parameters).empty());
        }
        QCOMPARE(QString::fromStdString(toJson(edits[2])),
                 R"({"edit":"smooth-shape","enabled":true,"wavelength_mm":4.25,"tolerance_mm":0.03})");
    }

    /// Stored edits keep their kind and text until the user updates them.
    void editsOfEarlierVersionsAreUpdatedOnDemand() {
        const auto stored = editFromJson(R"({"edit":"smooth","enabled":false,"cut_off_hz":5,"tolerance_mm":0.02})");
        QVERIFY(stored && std::holds_alternative<Smooth>(stored->parameters));
        const std::optional<Edit> newer = updated(*stored);
        QVERIFY(newer && !newer->enabled);
        QCOMPARE(std::get<SmoothShape>(newer->parameters).wavelength, 3.0); // at 15 mm/s
        QCOMPARE(std::get<SmoothShape>(newer->parameters).tolerance, 0.02);
        QVERIFY(!updated(*newer));
        const auto lead =
            editFromJson(R"({"edit":"lead-in","form":"line","size_mm":4})"); // before they had a direction
        QVERIFY(lead && std::get<LeadIn>(lead->parameters).direction == LeadDirection::firstMove);
        const std::optional<Edit> newerLead = updated(*lead);
        QVERIFY(newerLead && std::get<LeadIn>(newerLead->parameters).direction == LeadDirection::recording);
        QCOMPARE(std::get<LeadIn>(newerLead->parameters).size, 4.0);
        const auto link = editFromJson(R"({"edit":"link","approach_mm":2})"); // before it had ramps
        QVERIFY(link && std::get<Link>(link->parameters).entry == Link::Entry::plunge);
        for (const Edit& edit : everyEdit()) QCOMPARE(updated(edit).has_value(), traitsOf(edit.parameters).superseded);
        for (const Edit& edit : standardEdits()) QVERIFY(!updated(edit));
    }

    void everyParameterOfEveryKindIsKeptAndChecked() {
        std::set<std::string_view> ids;
        for (Edit edit : everyEdit()) {
            const std::string first = toJson(edit), id(idOf(edit.parameters));
            QVERIFY2(ids.insert(idOf(edit.parameters)).second && titleOf(edit.parameters).text[0] != '\0', id.c_str());
            QVERIFY2(validate(edit), id.c_str());
            for (const EditField& field : fieldsOf(edit.parameters)) {
                const Edit before = edit;
                for (const EditValue& strange : std::visit(Strange{field}, field.value)) {
                    setField(edit.parameters, field.key, strange);
                    QVERIFY2(!validate(edit), (id + " " + std::string(field.key)).c_str());
                    edit = before;
                }
                setField(edit.parameters, field.key, std::visit(Another{field}, field.value));
                QVERIFY2(validate(edit), (id + " " + std::string(field.key)).c_str());
                QVERIFY(toJson(edit) != toJson(before));
                const auto back = editFromJson(toJson(edit));
                QVERIFY2(back, toJson(edit).c_str());
                QCOMPARE(QString::fromStdString(toJson(*back)), QString::fromStdString(toJson(edit)));
            }
        }
        QVERIFY(ids.size() >= 30);
        QVERIFY(checkOrder(everyEdit()));
    }

    void whatIsLeftOutHasItsFirstValue() {
        const auto edit = editFromJson(R"({"edit": "hold-out", "clearance_mm": 0.01})");
        QVERIFY(edit);
        QCOMPARE(std::get<HoldOut>(edit->parameters).clearance, 0.01);
        QCOMPARE(std::get<HoldOut>(edit->parameters).sampling, HoldOut{}.sampling);
        QVERIFY(edit->enabled);
    }

    void strangeTextsAreRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<ErrorCode>("code");
        QTest::newRow("not JSON") << "smooth" << ErrorCode::argumentInvalid;
        QTest::newRow("a list") << "[]" << ErrorCode::argumentInvalid;
        QTest::newRow("no kind") << "{}" << ErrorCode::argumentInvalid;
        QTest::newRow("unknown kind") << R"({"edit": "polish"})" << ErrorCode::nameUnknown;
        QTest::newRow("unknown parameter") << R"({"edit": "smooth", "cutoff": 5})" << ErrorCode::argumentInvalid;
        QTest::newRow("another kind's parameter")
            << R"({"edit": "smooth", "approach_mm": 5})" << ErrorCode::argumentInvalid;
        QTest::newRow("a text for a number")
            << R"({"edit": "smooth", "cut_off_hz": "5"})" << ErrorCode::argumentInvalid;
        QTest::newRow("out of range") << R"({"edit": "smooth", "tolerance_mm": -1})" << ErrorCode::argumentInvalid;
        QTest::newRow("no such choice") << R"({"edit": "mirror", "across": "w"})" << ErrorCode::argumentInvalid;
        QTest::newRow("two coordinates") << R"({"edit": "rotate", "centre_mm": [1, 2]})" << ErrorCode::argumentInvalid;
        QTest::newRow("half a copy") << R"({"edit": "array", "copies": 1.5})" << ErrorCode::argumentInvalid;
        QTest::newRow("an outline of two corners")
            << R"({"edit": "remove-area", "outline_mm": [[0, 0, 0], [1, 0, 0]]})" << ErrorCode::argumentInvalid;
        QTest::newRow("a stretch that ends before it begins")
            << R"({"edit": "cut-out", "stretch": {"take": 1, "first": 9, "last": 8}})" << ErrorCode::argumentInvalid;
        QTest::newRow("a stretch with a strange member")
            << R"({"edit": "cut-out", "stretch": {"take": 1, "from": 9}})" << ErrorCode::argumentInvalid;
        QTest::newRow("enabled is a number") << R"({"edit": "smooth", "enabled": 1})" << ErrorCode::argumentInvalid;
    }
    void strangeTextsAreRefused() {
        QFETCH(QString, text);
        QFETCH(ErrorCode, code);
        const auto edit = editFromJson(text.toStdString());
        QVERIFY(!edit);
        QCOMPARE(edit.error().code, code);
    }

    void onlyOrdersThatKeepTheirPromiseAreTaken_data() {
        QTest::addColumn<std::vector<Edit>>("edits");
        QTest::addColumn<ErrorCode>("code");
        const auto row = [](const char* name, std::vector<Edit> edits, ErrorCode code) {
            QTest::newRow(name) << std::move(edits) << code;
        };
        using enum ErrorCode;
        row("smoothing behind the hold-out", {{HoldOut{}}, {Smooth{}}}, editMisplaced);
        row("smoothing thinned points", {{Simplify{}}, {Smooth{}}}, editMisplaced);
        row("simplifying links", {{Link{}}, {Simplify{}}}, editMisplaced);
        row("arcs on what was not held out", {{Smooth{}}, {FitArcs{}}}, editUnguarded);
        row("links of what was not held out", {{HoldOut{}}, {Offset{}}, {Link{}}}, editUnguarded);
        row("simplifying arcs", {{FitArcs{}}, {Simplify{}}}, editMisplaced);
        row("feeds by engagement before feeds", {{FeedOptimisation{}}, {SetFeed{}}}, editMisplaced);
        row("linking twice", {{Link{}}, {Link{}}}, editRepeated);
        row("not a number", {{Smooth{std::numeric_limits<double>::quiet_NaN(), 0.1}}}, argumentInvalid);
        row("cut-off beyond the recording", {{Smooth{500.0, 0.1}}}, argumentInvalid);
    }
    void onlyOrdersThatKeepTheirPromiseAreTaken() {
        QFETCH(std::vector<Edit>, edits);
        QFETCH(ErrorCode, code);
        const auto path = run({cut()}, edits, context());
        QVERIFY(!path);
        QCOMPARE(path.error().code, code);
        for (Edit& edit : edits) edit.enabled = false; // disabled edits do not count
        QVERIFY(run({cut()}, edits, context()));
    }

    void aPathWithoutWorkIsEmpty() {
        const auto nothing = run({}, standardEdits(), context());
        QVERIFY(!nothing);
        QCOMPARE(nothing.error().code, ErrorCode::pathEmpty);
        const auto air = run({takeOf(along({{0, 0, 5}, {10, 0, 5}}, 20.0, false))}, standardEdits(), context());
        QVERIFY(!air);
        QCOMPARE(air.error().code, ErrorCode::pathEmpty);
    }

    void aCancelledWorkSaysSo() {
        Progress progress;
        progress.cancel();
        const auto path = evaluate("path", {cut()}, standardEdits(), context(), progress);
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::cancelled);
    }

    void anotherToolsTakeIsRefused() {
        Take take = cut();
        take.info.toolId = "flat-6";
        const auto path = run({take}, standardEdits(), context());
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(QString::fromStdString(path.error().place), "flat-6");
    }

    void aTiltedToolIsRefused() {
        Take take = cut();
        take.samples[5].proxy.axis = glm::normalize(glm::dvec3(0.1, 0, 1));
        const auto path = run({take}, {}, context());
        QVERIFY(!path);
        QCOMPARE(path.error().code, ErrorCode::notSupported);
    }

    void whatIsNoWorkIsNeverPartOfThePath_data() {
        QTest::addColumn<int>("flag");
        QTest::addColumn<bool>("undone");
        QTest::newRow("shank contact") << int{sampleShankContact} << false;
        QTest::newRow("spindle off") << int{sampleSpindleOff} << false;
        QTest::newRow("taken back") << 0 << true;
    }
    void whatIsNoWorkIsNeverPartOfThePath() {
        QFETCH(int, flag);
        QFETCH(bool, undone);
        Take take = cut();
        for (std::size_t i = 100; i < 150; ++i) take.samples[i].flags |= static_cast<std::uint32_t>(flag);
        if (undone) take.undone = {{100, 50}};
        const auto path = run({take}, {}, context());
        QVERIFY(path);
        QCOMPARE(path->path.points.size(), take.samples.size() - 50);
        std::size_t strokes = 0;
        for (const PathPoint& point : path->path.points) {
            QVERIFY(point.sample < 100 || point.sample >= 150);
            strokes += point.kind == MoveKind::rapid ? 1 : 0;
        }
        QCOMPARE(strokes, std::size_t{2});
    }

    /// A loop that is late has one tick for several periods: the hand has moved and cut meanwhile.
    void aTickThatCameLateTearsNoStroke() {
        for (const auto& [late, strokes] : {std::pair(0.004, 1), std::pair(0.0, 2)}) {
            Take take = cut();
            for (std::size_t i = 100; i < take.samples.size(); ++i) {
                take.samples[i].time += late;
                take.samples[i].proxy.tip.x += 4.0; // mm, at 800 mm/s for the time that it took
            }
            const auto path = run({take}, {}, context());
            QVERIFY(path);
            QCOMPARE(std::ranges::count(path->path.points, MoveKind::rapid, &PathPoint::kind), strokes);
        }
    }

    void editsThatNeedThePartSaySo() {
        PathContext without = context();
        without.part = nullptr;
        for (const Edit& edit : std::vector<Edit>{{HoldOut{}}, {Simplify{}}, {Link{}}}) {
            const auto path = run({cut()}, {edit}, without);
            QVERIFY(!path);
            QCOMPARE(path.error().code, ErrorCode::argumentInvalid);
            QCOMPARE(QString::fromStdString(path.error().subject), "part");
        }
    }

    void theBudgetIsTheSumOfWhatMovedThePath() {
        const auto path = run({cut()}, standardEdits(), context());
        QVERIFY(path);
        QCOMPARE(path->reports.size(), std::size_t{8});
        double sum = 0.0;
        for (std::size_t i = 2; i < 5; ++i) sum += path->reports[i].largestDeviation;
        QCOMPARE(path->errorBudget, sum);
        QCOMPARE(path->path.spindleSpeed, 10000.0);
        QCOMPARE(path->reports.back().pointsAfter, path->path.points.size());
        for (std::size_t i = 1; i < path->reports.size(); ++i)
            QCOMPARE(path->reports[i].pointsBefore, path->reports[i - 1].pointsAfter);
    }

private:
    static Take cut() { return takeOf(along({{0, 0, -1}, {10, 0, -1}, {10, 10, -1}}, 20.0)); }
    PathContext context() const { return contextOf(nothing_, ballTool(), {{-20, -20, -20}, {20, 20, 0}}); }
    const MeshDistance nothing_{TriangleMesh{}};
};

BURIN_TEST(TestEdits, NoApplication)

} // namespace burin::tst_edits

#include "tst_edits.moc"
