// SPDX-FileCopyrightText: 2026 The Burin authors
// SPDX-License-Identifier: Apache-2.0
#include "core/document/mesh_blob.h"
#include "core/document/project.h"
#include "core/document/setup_record.h"
#include "tests/core/document/sample_project.h"
#include "tests/places.h"
#include "tests/test_program.h"

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <filesystem>
#include <limits>
#include <span>

namespace burin::tst_project {

namespace fs = std::filesystem;

namespace {

QByteArray contentOf(const fs::path& file) {
    QFile stream(QString::fromStdString(file.string()));
    return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
}

fs::path fileIn(const QTemporaryDir& folder, const char* name = "p.burin") {
    return folder.filePath(name).toStdString();
}

/// As text: equal exactly if the stored forms are. The content of the forms themselves is tested where they are made.
template <class Value>
std::vector<std::string> texts(const std::vector<Value>& values) {
    std::vector<std::string> result;
    for (const Value& value : values) result.push_back(toJson(value));
    return result;
}

} // namespace

class TestProject : public QObject {
    Q_OBJECT
private slots:
    /// Everything that a project contains is read back by a second program: saved, closed, opened.
    void everythingComesBack() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        QVERIFY(project && !project->recovered() && !*project->unsaved());
        QVERIFY(fixture::holdsFixture(*project));
    }

    /// Colours of faces come back, and the mesh before them is as without: as older versions read it.
    void coloursOfFacesComeBack() {
        const QTemporaryDir folder;
        Model model = fixture::model();
        FaceColours& colours = model.bodies.back().faceColours;
        colours = {{0, 2, {1, 2, 3}}, {2, 1, {255, 254, 253}}, {7, 5, {1, 2, 3}}}; // of twelve triangles
        {
            Result<Project> project = Project::create(fileIn(folder));
            QVERIFY(project && project->setModel(model) && project->save());
        }
        Result<Project> project = Project::open(fileIn(folder));
        QVERIFY(project);
        const Result<Model> read = project->model();
        QVERIFY(read && fixture::identical(*read, model));
        const std::string mesh = encodeMesh(model.bodies.back().mesh), blob = mesh + encodeFaceColours(colours);
        QVERIFY(decodeMesh(blob)->triangles == decodeMesh(mesh)->triangles);
        QVERIFY(decodeMesh(blob)->vertices == decodeMesh(mesh)->vertices);
        QVERIFY(decodeFaceColours(blob, 12) == colours && decodeFaceColours(mesh, 12)->empty());
        // Colours of triangles that the mesh does not have, and a blob that was cut off.
        QVERIFY(!decodeFaceColours(blob, 11));
        QVERIFY(!decodeMesh(std::string_view(blob).substr(0, blob.size() - 1)));
    }

    /// Files written by each version, kept in the repository.
    void aProjectOfEachVersionOpens_data() {
        QTest::addColumn<int>("version");
        QTest::newRow("first") << 1;
        QTest::newRow("with strokes that were taken back") << 2;
        QTest::newRow("with fixtures, a chosen axis and guides") << 3;
        QTest::newRow("with several setups") << 4;
        QTest::newRow("with roles and layers") << 5;
        QTest::newRow("with a stock from a file") << 6;
        QTest::newRow("with a turned part") << 7;
        QTest::newRow("with a program zero") << 8;
        QTest::newRow("with a computed pass") << 9;
        QTest::newRow("with a stretch switched off, a marker and a kept workpiece") << 10;
        QTest::newRow("with moves of a program") << 11;
        QTest::newRow("with the torque of a device") << 12;
        QTest::newRow("with the coolant of a program's moves") << 13;
    }
    void aProjectOfEachVersionOpens() {
        QFETCH(int, version);
        const QTemporaryDir folder;
        fs::copy_file(fs::path(BURIN_FIXTURES) / ("projects/v" + std::to_string(version)) / "small.burin",
                      fileIn(folder));
        const QByteArray written = contentOf(fileIn(folder));
        Result<Project> project = Project::open(fileIn(folder));
        QVERIFY(project);
        QVERIFY(fixture::holdsFixture(*project, version));
        // And accepts data that only today's version knows.
        const std::int64_t take = project->takes()->front().id;
        QVERIFY(project->undoInterval(take, {400, 10}) && project->setObstacles(fixture::obstacles()) &&
                project->save());
        QCOMPARE(project->take(take)->undone.back(), (SampleRange{400, 10}));
        QVERIFY(*project->obstacles() == fixture::obstacles());
        // The original file is kept for users who still have the version that wrote it.
        const fs::path kept = project->keptEarlier();
        QCOMPARE(kept.empty(), version == 13);
        if (!kept.empty()) QCOMPARE(kept.filename().string(), "p.format-" + std::to_string(version) + ".burin");
        if (!kept.empty()) QCOMPARE(contentOf(kept), written);
        QVERIFY(project->setAxisMode({}) && project->save());
        QVERIFY(project->keptEarlier().empty()); // only once
    }

    /// Nothing is stored in a setup that does not exist, and a path's takes belong to its own setup.
    void setupsAreKeptApart() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        const SetupId second = project->setups()->back().id, unknown{99};
        const std::int64_t take = project->takes()->front().id;
        const StoredPath astray{0, "a", {{take}}, {}, second}, nowhere{0, "b", {}, {}, unknown};
        QCOMPARE(project->addPath(astray).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(project->addPath(nowhere).error().code, ErrorCode::nameUnknown);
        QCOMPARE(project->setAxisMode({}, unknown).error().code, ErrorCode::nameUnknown);
        QCOMPARE(project->setup(unknown).error().code, ErrorCode::nameUnknown);
        TakeInfo info = fixture::takeInfo("c");
        info.setup = unknown;
        QCOMPARE(project->beginTake(info).error().code, ErrorCode::nameUnknown);
        info.setup = second;
        QVERIFY(project->beginTake(info) && project->takes(second)->back().setup == second);
        QVERIFY(project->setObstacles({}, second) && *project->obstacles() == fixture::obstacles());
        QCOMPARE(project->setup(*project->addSetup("d")).error().code, ErrorCode::projectIncomplete);
    }

    /// Queries without a setup's id refer to the one in use, and so does storing.
    void oneSetupIsInUse() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        const SetupId second = project->setups()->back().id;
        QCOMPARE(project->usedSetup(), firstSetup);
        QCOMPARE(project->useSetup(SetupId{99}).error().code, ErrorCode::nameUnknown);
        QCOMPARE(project->usedSetup(), firstSetup);
        const std::int64_t digest = *project->jobDigest();
        QVERIFY(project->setKeptProgram("front") && project->setProgramDraft("G0 X1"));
        QVERIFY(project->useSetup(second));
        QVERIFY(project->takes()->empty() && project->paths()->size() == 1 && project->programs()->size() == 1);
        QVERIFY(project->keptProgram()->empty() && project->programDraft()->empty());
        QVERIFY(project->setKeptProgram("back"));
        QVERIFY(project->beginTake(fixture::takeInfo("c")) && project->takes()->front().setup == second);
        QCOMPARE(project->addPath({0, "of the back", {{project->takes()->front().id}}, {}}).hasValue(), true);
        QCOMPARE(project->paths()->back().setup, second);
        QVERIFY(project->setObstacles({}) && project->obstacles(firstSetup)->size() == fixture::obstacles().size());
        // Changes in one setup do not affect the digest by which another one's program was judged.
        QCOMPARE(*project->jobDigest(firstSetup), digest);
        QVERIFY(*project->jobDigest() != digest);
        QVERIFY(project->useSetup(firstSetup) && *project->keptProgram() == "front");
        QCOMPARE(*project->programDraft(), std::string("G0 X1"));
    }

    /// A setup can be removed if no work is lost with it.
    void aSetupIsNamedAndRemoved() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        const SetupId second = project->setups()->back().id, third = *project->addSetup("third");
        QVERIFY(project->nameSetup(third, "Seite") && project->setups()->back().name == "Seite");
        QCOMPARE(project->removeSetup(firstSetup).error().code, ErrorCode::argumentInvalid); // in use
        QCOMPARE(project->removeSetup(second).error().code, ErrorCode::argumentInvalid);     // has a path
        Setup left = fixture::setup();
        left.leftBy = LeftBy{third, 5};
        QVERIFY(project->setSetup(left, firstSetup) && project->setObstacles(fixture::obstacles(), third) &&
                project->setAxisMode({true, {0.0, 0.0, 1.0}}, third));
        QCOMPARE(project->removeSetup(third).error().code, ErrorCode::argumentInvalid); // its workpiece is a stock
        QVERIFY(project->setSetup(fixture::setup(), firstSetup));
        TakeInfo info = fixture::takeInfo("there");
        info.setup = third;
        {
            Result<Project::TakeWriter> writer = project->beginTake(info);
            QVERIFY(writer && writer->append(fixture::handSamples(0, 20)) && writer->finish());
            QCOMPARE(project->removeSetup(third).error().code, ErrorCode::argumentInvalid); // has a take
            QVERIFY(project->removeTake(writer->id()));
        }
        QVERIFY(project->removeSetup(third)); // a deleted take is removed with it
        QCOMPARE(project->setups()->size(), std::size_t{2});
        QCOMPARE(project->setup(third).error().code, ErrorCode::nameUnknown);
        QVERIFY(project->save() && Project::openForReading(fileIn(folder)));
    }

    /// Each setup's materials are available, whichever was stored last.
    void materialsOfOtherSetupsStay() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        const std::vector<Property> all = fixture::materials();
        Setup first = fixture::setup(), second = fixture::setup();
        for (Setup* setup : {&first, &second}) {
            setup->regions.clear();
            setup->bodyMaterials.clear();
            setup->form = StockForm::box; // one from a file brings its own
            setup->volume = nullptr;
        }
        first.stockMaterial = all[0].id;
        second.stockMaterial = all[1].id;
        QVERIFY(project->setSetup(first) && project->setMaterials({all[0]}));
        QVERIFY(project->useSetup(*project->addSetup("back")));
        QVERIFY(project->setSetup(second) && project->setMaterials({all[1]}));
        QCOMPARE(project->materials()->size(), std::size_t{2});
        second.stockMaterial = all[0].id;
        QVERIFY(project->setSetup(second) && project->setMaterials({all[0]}));
        QCOMPARE(texts(*project->materials()), texts(std::vector{all[0]}));
    }

    /// A placement that does not preserve lengths would be another part.
    void aPlacementComesBackAndIsSound() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        QVERIFY(project->setModel(fixture::model()));
        Setup setup = fixture::setup();
        setup.placement = combined(turnedAbout({1.0, 2.0, 3.0}, 0.7, {4.0, 5.0, 6.0}), movedBy({0.1, -7.0, 1e-3}));
        setup.leftBy = LeftBy{firstSetup, -42};
        QVERIFY(project->setSetup(setup));
        const Result<Setup> stored = project->setup();
        QVERIFY(stored && stored->placement == setup.placement);
        QVERIFY(stored->leftBy && stored->leftBy->setup == firstSetup && stored->leftBy->digest == -42);
        const Result<Model> model = project->model();
        const auto lying = project->placedModel();
        QVERIFY(model && lying && (*lying)->brepPlacement == setup.placement);
        QCOMPARE((*lying)->bodies[0].mesh.vertices[1], setup.placement.point(model->bodies[0].mesh.vertices[1]));
        setup.placement.turn[0] *= 1.01;
        QCOMPARE(project->setSetup(setup).error().code, ErrorCode::argumentInvalid);
        QVERIFY(project->setup()->placement != setup.placement);
    }

    /// A mirrored part is stored as such: its exact surface is no longer that of the file.
    void aMirroredModelComesBack() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        const auto mirrored =
            placed(std::make_shared<const Model>(fixture::model()), mirroredAcross(0, {1.0, 2.0, 3.0}));
        QVERIFY(project->setModel(*mirrored) && project->save());
        const Result<Project> again = Project::openForReading(fileIn(folder));
        QVERIFY(again && again->model()->brepPlacement == mirrored->brepPlacement);
    }

    /// The unit that the file states is stored together with the one that is used, and colours without the model.
    void unitsAndColoursComeBack() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Model model = fixture::model();
        model.lengthUnit = "inch";
        model.statedUnit = 25.4;
        for (const double used : {25.4, 1.0, 1.0 / 3.0}) {
            model.unitScale = used;
            QVERIFY(project->setModel(model));
            const Result<Model> stored = project->model();
            QVERIFY(stored && stored->lengthUnit == "inch");
            QCOMPARE(stored->statedUnit, 25.4);
            QCOMPARE(stored->unitScale, used);
        }
        model.lengthUnit = "none";
        model.statedUnit = 0.0;
        QVERIFY(project->setModel(model) && project->model()->lengthUnit == "none");
        QCOMPARE(project->model()->statedUnit, 0.0);
        std::vector<BodyColour> colours(model.bodies.size(), BodyColour({1, 2, 255}));
        colours.back().reset();
        QVERIFY(project->setBodyColours(colours) && project->save());
        const Result<Project> again = Project::openForReading(fileIn(folder));
        for (std::size_t i = 0; i < colours.size(); ++i) QVERIFY(again->model()->bodies[i].colour == colours[i]);
    }

    /// A loop that misses ticks has fewer samples than periods, in one chunk or in several.
    void howLongATakeIsComesFromItsTimes() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("late"));
        QCOMPARE(project->takes()->front().seconds, std::optional(0.0));
        std::vector<Sample> samples = fixture::handSamples(0, 40);
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i].time = 0.0025 * static_cast<double>(i);
        QVERIFY(writer->append(std::span(samples).first(15)));
        QCOMPARE(project->takes()->front().seconds, std::optional(0.0025 * 14.0));
        QVERIFY(writer->append(std::span(samples).subspan(15)) && writer->finish());
        QCOMPARE(project->takes()->front().seconds, std::optional(0.0025 * 39.0));
        QCOMPARE(project->take(writer->id())->info.seconds, std::optional(0.0025 * 39.0));
    }

    /// Hours of samples are visited in parts; the visitor may stop early.
    void aTakeIsVisitedInItsOrder() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("long"));
        const std::int64_t id = writer->id();
        const std::vector<Sample> hand = fixture::handSamples(0, 40000);
        QVERIFY(writer->append(std::span(hand).first(100)) && writer->append(std::span(hand).subspan(100)));
        QVERIFY(project->undoInterval(id, {90, 60}));
        std::vector<Sample> seen;
        std::size_t largest = 0;
        QVERIFY(project->visitSamples(id, [&](std::span<const Sample> part) -> Result<void> {
            seen.insert(seen.end(), part.begin(), part.end());
            largest = std::max(largest, part.size());
            return {};
        }));
        QVERIFY(fixture::identical(seen, hand));
        QVERIFY(largest < hand.size());
        const Result<TakeOutline> outline = project->takeOutline(id);
        QVERIFY(outline);
        QCOMPARE(outline->info.sampleCount, std::uint64_t{40000});
        QCOMPARE(outline->undone, (std::vector<SampleRange>{{90, 60}}));
        QCOMPARE(outline->info.seconds, project->take(id)->info.seconds);

        int calls = 0;
        const Result<void> broken = project->visitSamples(id, [&](std::span<const Sample>) -> Result<void> {
            ++calls;
            return Error{ErrorCode::cancelled, "looking", {}, {}};
        });
        QVERIFY(!broken);
        QCOMPARE(broken.error().subject, std::string("looking"));
        QCOMPARE(calls, 1);
        const SampleVisitor nobody = [](std::span<const Sample>) -> Result<void> { return {}; };
        QCOMPARE(project->visitSamples(id + 1, nobody).error().code, ErrorCode::nameUnknown);
        QCOMPARE(project->takeOutline(id + 1).error().code, ErrorCode::nameUnknown);
    }

    /// Undone samples stay in the file, are listed, and can be redone.
    void whatIsTakenBackIsKept() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("a"));
        const std::int64_t id = writer->id();
        QVERIFY(writer->append(fixture::handSamples(0, 100)));
        // During the recording, and ahead of the samples that are on the disk.
        QVERIFY(project->undoInterval(id, {90, 60}) && project->undoInterval(id, {10, 5}));
        QVERIFY(writer->append(fixture::handSamples(100, 30)));
        Result<Take> take = project->take(id);
        QVERIFY(take);
        QCOMPARE(take->samples.size(), std::size_t{130});
        QCOMPARE(take->undone, (std::vector<SampleRange>{{10, 5}, {90, 40}})); // no more than exist
        QCOMPARE(project->takes()->front().undoneCount, std::uint64_t{45});
        QVERIFY(writer->append(fixture::handSamples(130, 70)) && writer->finish() && project->save());
        QCOMPARE(project->take(id)->undone.back(), (SampleRange{90, 60}));
        QVERIFY(project->redoInterval(id, {10, 5}));
        take = project->take(id);
        QCOMPARE(take->undone, (std::vector<SampleRange>{{90, 60}}));
        QVERIFY(fixture::identical(take->samples, fixture::handSamples(0, 200)));
        QVERIFY(*project->unsaved());
        QVERIFY(project->removeTake(id) && project->save());
    }

    void anIntervalThatCantBeTakenBackChangesNothing() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        const std::int64_t id = project->takes()->front().id;
        constexpr std::uint64_t beyond = ~std::uint64_t{0};
        for (const SampleRange& wrong :
             {SampleRange{5, 0}, SampleRange{149, 10}, SampleRange{90, 11}, SampleRange{0, 500}, SampleRange{120, 5},
              SampleRange{beyond, 1}, SampleRange{1, beyond}})
            QCOMPARE(project->undoInterval(id, wrong).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(project->undoInterval(99, {0, 1}).error().code, ErrorCode::nameUnknown);
        QCOMPARE(project->redoInterval(id, {100, 49}).error().code, ErrorCode::argumentInvalid);
        QCOMPARE(project->redoInterval(99, {100, 50}).error().code, ErrorCode::argumentInvalid);
        QVERIFY(fixture::holdsFixture(*project) && !*project->unsaved());
    }

    void obstaclesThatCantBeAreRefusedAndNothingChanges() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        std::vector<Obstacle> wrong = fixture::obstacles();
        wrong.back().shape = Box{{0.0, 0.0, 0.0}, {1.0, 0.0, 1.0}};
        QCOMPARE(project->setObstacles(wrong).error().code, ErrorCode::argumentInvalid);
        wrong = fixture::obstacles();
        std::get<TriangleMesh>(wrong.front().shape).triangles.pop_back();
        const Result<void> open = project->setObstacles(wrong);
        QCOMPARE(open.error().code, ErrorCode::modelNotWatertight);
        QCOMPARE(open.error().subject, wrong.front().name);
        QCOMPARE(project->setAxisMode({false, {0.0, 0.0, 2.0}}).error().code, ErrorCode::argumentInvalid);
        KeptGuides guides = fixture::guides();
        guides.guides.front().lead = std::numeric_limits<double>::infinity(); // unused for a plane
        QCOMPARE(project->setGuides(guides).error().code, ErrorCode::argumentInvalid);
        QVERIFY(fixture::holdsFixture(*project) && !*project->unsaved());
    }

    void anUnplacedStockComesBackEmpty() {
        const auto setup = setupFromJson(*toJson(Setup{}));
        QVERIFY(setup && setup->stock.empty());
        QVERIFY(fixture::identical(*setup, Setup{}));
    }

    void theRunAxisComesBack() {
        Setup setup;
        for (const RunAxis axis : {RunAxis::x, RunAxis::y, RunAxis::z}) {
            setup.runs = axis;
            const auto back = setupFromJson(*toJson(setup));
            QVERIFY(back && back->runs == axis);
        }
        std::string text = *toJson(setup); // along z
        const std::string key = R"("run_axis":"z",)";
        const std::size_t at = text.find(key);
        QVERIFY(at != std::string::npos);
        std::string older = text, wrong = text;
        QVERIFY(setupFromJson(older.erase(at, key.size()))->runs == RunAxis::z);
        QVERIFY(!setupFromJson(wrong.replace(at, key.size(), R"("run_axis":"w",)")));
    }

    void aSetupThatIsNotFiniteIsRefused() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Setup setup = fixture::setup();
        setup.voxel = std::numeric_limits<double>::quiet_NaN();
        const Result<void> stored = project->setSetup(setup);
        QVERIFY(!stored);
        QCOMPARE(stored.error().code, ErrorCode::argumentInvalid);
        QCOMPARE(stored.error().subject, std::string("voxel_mm"));
        QVERIFY(!*project->unsaved());
    }

    void anEmptyProjectSaysWhatIsMissing() {
        const QTemporaryDir folder;
        const Result<Project> project = Project::create(fileIn(folder));
        QVERIFY(project);
        const Error model = project->model().error(), setup = project->setup().error();
        QCOMPARE(model.code, ErrorCode::projectIncomplete);
        QCOMPARE(model.subject, std::string("model"));
        QCOMPARE(setup.code, ErrorCode::projectIncomplete);
        QCOMPARE(setup.place, std::string("burin embed"));
        QCOMPARE(project->materials().error().code, ErrorCode::projectIncomplete);
        QCOMPARE(project->take(1).error().subject, std::string("recording"));
        QVERIFY(project->takes()->empty() && project->tools()->empty() && project->paths()->empty() &&
                project->programs()->empty());
    }

    void whatIsThereOnceIsReplaced() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Model smaller = fixture::model();
        smaller.bodies.pop_back();
        smaller.notes.clear();
        QVERIFY(project->setModel(fixture::model()) && project->setModel(smaller));
        QVERIFY(fixture::identical(*project->model(), smaller));
        QVERIFY(project->setMaterials(fixture::materials()) && project->setMaterials({fixture::materials().front()}));
        QCOMPARE(project->materials()->size(), std::size_t{1});
        Tool longer = fixture::tool();
        longer.cutter.stickOut = 40.0;
        QVERIFY(project->setTool(fixture::tool()) && project->setTool(longer));
        QCOMPARE(texts(*project->tools()), texts(std::vector{longer}));
    }

    void whatProgramsAreForComesBack() {
        const QTemporaryDir folder;
        const ProgramTarget wanted{"haas-mill", "fanuc", NcUnits::inch};
        const std::string draft = "G21\n(\"Gr\xc3\xbc\xc3\x9f\" \\ 100 %)\nM2\n";
        {
            Result<Project> project = Project::create(fileIn(folder));
            QVERIFY(project->programTarget()->units == NcUnits::millimetre && project->programDraft()->empty());
            QVERIFY(project->setProgramTarget(wanted) && project->setProgramDraft(draft) && project->save());
        }
        Result<Project> project = Project::open(fileIn(folder));
        QVERIFY(*project->programTarget() == wanted);
        QCOMPARE(*project->programDraft(), draft);
        QVERIFY(project->setProgramDraft({}));
        QVERIFY(project->programDraft()->empty());
    }

    /// The user's current position is saved with the project, and does not require saving by itself.
    void whereItWasLeftComesBack() {
        const QTemporaryDir folder;
        const auto file = std::filesystem::path(folder.filePath("left.burin").toStdString());
        {
            Result<Project> project = Project::create(file);
            QVERIFY(project && project->save());
            QCOMPARE(project->leftAt().value(), std::string());
            QVERIFY(project->setLeftAt("{\"step\":\"mill\"}"));
            QVERIFY(!*project->unsaved());
        }
        {
            Result<Project> project = Project::open(file); // there was nothing to save
            QVERIFY(project && !project->recovered());
            QCOMPARE(project->leftAt().value(), std::string());
            QVERIFY(project->setLeftAt("{\"step\":\"path\"}") && project->save());
        }
        const Result<Project> project = Project::open(file);
        QVERIFY(project && !*project->unsaved());
        QCOMPARE(project->leftAt().value(), std::string("{\"step\":\"path\"}"));
    }

    void pathsKnowTheirTakes() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        QVERIFY(project);
        StoredPath path = project->paths()->front();
        const std::int64_t used = path.sources.front().id;

        const Result<void> removed = project->removeTake(used);
        QVERIFY(!removed);
        QCOMPARE(removed.error().code, ErrorCode::argumentInvalid);
        path.sources = {{used}, {99}};
        QCOMPARE(project->setPath(path).error().code, ErrorCode::nameUnknown);
        QCOMPARE(project->addPath(path).error().place, std::string("99"));
        QVERIFY(fixture::holdsFixture(*project)); // none of the kept data

        path.sources.clear();
        path.edits.pop_back();
        QVERIFY(project->setPath(path));
        QCOMPARE(project->paths()->front().edits.size(), path.edits.size());
        QVERIFY(project->removeTake(used));
        QCOMPARE(project->take(used).error().code, ErrorCode::nameUnknown);
        QCOMPARE(project->removeTake(used).error().code, ErrorCode::nameUnknown);
        path.id = 77;
        QCOMPARE(project->setPath(path).error().subject, std::string("path"));
    }

    /// Bitwise equal, including strokes of several chunks; a path can be made of them as of takes, and they are removed
    /// only if no path uses them.
    void whatAPlannerMadeIsKept() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        GeneratedMoves moves = fixture::generatedMoves();
        std::vector<GeneratedPoint>& longest = moves.strokes.emplace_back();
        for (int i = 0; i < 40000; ++i)
            longest.push_back({{{0.1 * i, std::sin(i), -1.0 / (i + 1)}}, 1000 + 3 * i, i % 3 != 0, i % 5 == 0});
        std::int64_t id = 0, path = 0;
        {
            Result<Project> project = Project::open(fileIn(folder));
            const std::int64_t take = project->takes()->front().id;
            id = *project->addGenerated(moves);
            QVERIFY(id < -1); // the fixture contains some
            path = *project->addPath({0, "both", {{id}, {take}, {id}}, {}, firstSetup});
            QVERIFY(project->save());
        }
        Result<Project> project = Project::open(fileIn(folder));
        QVERIFY(fixture::identical(*project->generatedMoves(id), moves));
        QCOMPARE(project->generated()->back().pointCount, std::uint64_t{40006});
        StoredPath both = project->paths()->back();
        QVERIFY(both.id == path && both.sources.front() == PathSource{id} && both.sources[1].isTake());
        QCOMPARE(project->removeGenerated(id).error().code, ErrorCode::argumentInvalid);
        QVERIFY(project->removePath(path) && project->restorePath(both));
        both.sources.erase(both.sources.begin());
        both.sources.pop_back();
        QVERIFY(project->setPath(both) && project->removeGenerated(id));
        QCOMPARE(project->generatedMoves(id).error().code, ErrorCode::nameUnknown);
        both.sources = {{id}};
        QCOMPARE(project->setPath(both).error().code, ErrorCode::nameUnknown);
        QVERIFY(*project->addGenerated(moves) < id); // a number is never reused
    }

    void movesThatNoPlannerMakesAreRefused() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        Result<Project> project = Project::open(fileIn(folder));
        const std::size_t before = project->generated()->size();
        const auto refused = [&](const std::function<void(GeneratedMoves&)>& spoil) {
            GeneratedMoves moves = fixture::generatedMoves();
            spoil(moves);
            return project->addGenerated(moves).error().code;
        };
        constexpr double endless = std::numeric_limits<double>::infinity();
        QCOMPARE(refused([](auto& moves) { moves.strokes[0].clear(); }), ErrorCode::argumentInvalid);
        QCOMPARE(refused([](auto& moves) { moves.strokes[0][1].pose.tip.y = endless; }), ErrorCode::argumentInvalid);
        QCOMPARE(refused([](auto& moves) { moves.strokes[0][1].pose.axis.z = 0.9; }), ErrorCode::argumentInvalid);
        QCOMPARE(refused([](auto& moves) { moves.strokes[0][1].moment = moves.strokes[0][0].moment; }),
                 ErrorCode::argumentInvalid);
        QCOMPARE(refused([](auto& moves) { moves.strokes[0].back().moment = moves.strokes[1].back().moment + 1; }),
                 ErrorCode::argumentInvalid);
        QCOMPARE(refused([](auto& moves) { moves.strokes[0].front().moment = -1; }), ErrorCode::argumentInvalid);
        QCOMPARE(refused([](auto& moves) { moves.info.allowance = -0.5; }), ErrorCode::argumentInvalid);
        QCOMPARE(refused([](auto& moves) { moves.info.setup = SetupId{77}; }), ErrorCode::nameUnknown);
        QCOMPARE(project->generated()->size(), before);
    }

    /// With its number, its takes and its edits, so that references to it are valid again; the file reads it all back.
    void aPathGoesAndComesBackAsItWas() {
        const QTemporaryDir folder;
        QVERIFY(fixture::fillProject(fileIn(folder)));
        {
            Result<Project> project = Project::open(fileIn(folder));
            const StoredPath path = project->paths()->front();
            const std::size_t all = project->paths()->size();
            QVERIFY(project->removePath(path.id));
            QCOMPARE(project->paths()->size(), all - 1);
            QCOMPARE(project->removePath(path.id).error().code, ErrorCode::nameUnknown);
            QVERIFY(project->restorePath(path));
            QVERIFY(fixture::holdsFixture(*project));
            QVERIFY(!project->restorePath(path)); // it exists
            QVERIFY(project->removePath(path.id));
            const std::int64_t newer = *project->addPath(path);
            QVERIFY(newer > path.id);
            for (const PathSource source : path.sources)
                QVERIFY(!project->removeTake(source.id)); // the new one uses it
            QVERIFY(project->removePath(newer));
            QVERIFY(project->restorePath(path));
        }
        Result<Project> again = Project::open(fileIn(folder));
        QVERIFY(fixture::holdsFixture(*again));
    }

    /// A take's number is never reused, so that no path and no program can refer to another take by it.
    void numbersOfTakesAreNotReused() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        const std::int64_t first = project->beginTake(fixture::takeInfo("a"))->id();
        QVERIFY(project->removeTake(first));
        QVERIFY(project->beginTake(fixture::takeInfo("b"))->id() > first);
    }

    /// A minute at 1 kHz, journalled every 50 ms, stays below 8 MB (five minutes below 40).
    void aMinuteOfRecordingStaysSmall() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("long"));
        const std::vector<Sample> hand = fixture::handSamples(0, 60000);
        for (std::size_t first = 0; first < hand.size(); first += 50)
            QVERIFY(writer->append(std::span(hand).subspan(first, 50)));
        QVERIFY(writer->finish() && project->save());
        const auto size = fs::file_size(fileIn(folder));
        qInfo("%.1f bytes a sample", static_cast<double>(size) / static_cast<double>(hand.size()));
        QVERIFY(size < 8'000'000);
        QVERIFY(fixture::identical(project->take(writer->id())->samples, hand));
    }

    void oneAppendMayBringManySamples() {
        const QTemporaryDir folder;
        Result<Project> project = Project::create(fileIn(folder));
        Result<Project::TakeWriter> writer = project->beginTake(fixture::takeInfo("fast"));
        const std::vector<Sample> hand = fixture::handSamples(0, 40000); // more than fits into a chunk
        QVERIFY(writer->append(hand) && writer->append({}) && writer->append(std::span(hand).first(1)));
        const Result<Take> take = project->take(writer->id());
        QVERIFY(take);
        QCOMPARE(take->samples.size(), hand.size() + 1);
        QCOMPARE(take->info.sampleCount, std::uint64_t{hand.size() + 1});
    }
};

BURIN_TEST(TestProject, NoApplication)

} // namespace burin::tst_project

#include "tst_project.moc"
