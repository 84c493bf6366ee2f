// The grader's own proof: judges all mutants of the solution, and counts how many verdicts are right.

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <map>
#include <set>

#include "apps/CommandLine.h"
#include "base/Interrupts.h"
#include "base/ProgressBar.h"
#include "base/WholeFile.h"
#include "grader/judge/Judge.h"
#include "grader/mutants/Mutant.h"

using namespace radlab::grader;

namespace {

struct Row {
    int wrong = 0, caught = 0, alone = 0, nameable = 0, named = 0, right = 0, kept = 0, steady = 0, sameMarks = 0;
};

// What a verdict says of the stage that a mutant changes.
struct Verdict {
    std::set<std::string> failing;  // checks, but not those of pictures, which know no seed
    std::string name;               // of the mistake
    bool error = false;
    bool operator==(const Verdict& other) const = default;
};

Verdict verdictOf(const Result& result, const std::string& stage, const Manifest& manifest) {
    std::set<std::string> pictures;
    for (const ManifestCheck& check : manifest.find(stage).checks)
        if (!check.references.empty()) pictures.insert(check.id);
    Verdict verdict;
    for (const StageResult& one : result.stages) {
        verdict.error = verdict.error || one.status == Status::error;
        if (one.stage != stage) continue;
        for (const CheckResult& check : one.checks) {
            if (check.status == Status::fail && !pictures.count(check.id)) verdict.failing.insert(check.id);
            if (check.diagnosis) verdict.name = check.diagnosis->id;
        }
    }
    return verdict;
}

std::map<std::string, double> lostMarks(const Result& result) {
    std::map<std::string, double> lost;
    for (const StageResult& stage : result.stages)
        if (stage.score < stage.maxScore) lost[stage.stage] = stage.maxScore - stage.score;
    return lost;
}

// All that is said of a mutant: of the whole file with the first seed, of its stage with every seed.
struct Judged {
    std::map<std::string, double> lost;
    std::vector<Verdict> verdicts;

    // Right or wrong, and the same name, with every seed.
    bool steady() const {
        const Verdict& first = verdicts.front();
        return std::all_of(verdicts.begin(), verdicts.end(), [&](const Verdict& v) {
            return v.failing.empty() == first.failing.empty() && v.name == first.name && !v.error;
        });
    }

    // The same checks failing, too, so the same marks.
    bool sameMarks() const {
        return std::all_of(verdicts.begin(), verdicts.end(), [&](const Verdict& v) { return v == verdicts.front(); });
    }
};

struct Settings {
    std::string stage, id;
    int seeds = 1;
    std::uint64_t firstSeed = 1;
    bool list = false;
};

class Proof {
public:
    explicit Proof(const Settings& how)
        : settings(how), toolchain(readToolchain(RADLAB_TOOLCHAIN)), manifest(readManifest(manifestFile())) {}

    void run() {
        std::vector<Mutant> mutants = projectMutants();
        for (const Mutant& mutant : extensionMutants()) mutants.push_back(mutant);
        std::erase_if(mutants, [&](const Mutant& mutant) {
            return (!settings.stage.empty() && mutant.stage != settings.stage) ||
                   (!settings.id.empty() && mutant.id != settings.id);
        });
        radlab::ProgressBar bar("mutants", static_cast<double>(mutants.size()));
        for (std::size_t i = 0; i < mutants.size(); ++i) {
            bar.show(static_cast<double>(i), mutants[i].stage + " " + mutants[i].id);
            judge(mutants[i]);
        }
    }

    bool print() const {
        std::cout << "| stage | wrong | lost marks there | and in no other | to name | named | right | kept all | same "
                     "verdict "
                     "for all seeds | same marks |\n"
                     "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
        Row sum;
        for (const std::vector<ManifestStage>* stages : {&manifest.stages, &manifest.extensions})
            for (const ManifestStage& stage : *stages)
                if (const auto found = rows.find(stage.stage); found != rows.end()) {
                    print(stage.stage, found->second);
                    add(sum, found->second);
                }
        print("all", sum);
        return sum.caught == sum.wrong && sum.alone == sum.wrong && sum.kept == sum.right &&
               sum.steady == sum.wrong + sum.right && 20 * sum.named >= 19 * sum.nameable;
    }

private:
    static void print(const std::string& name, const Row& row) {
        std::cout << "| " << name << " | " << row.wrong << " | " << row.caught << " | " << row.alone << " | "
                  << row.nameable << " | " << row.named << " | " << row.right << " | " << row.kept << " | "
                  << row.steady << " of " << row.wrong + row.right << " | " << row.sameMarks << " |\n";
    }

    static void add(Row& sum, const Row& row) {
        sum.wrong += row.wrong;
        sum.caught += row.caught;
        sum.alone += row.alone;
        sum.nameable += row.nameable;
        sum.named += row.named;
        sum.right += row.right;
        sum.kept += row.kept;
        sum.steady += row.steady;
        sum.sameMarks += row.sameMarks;
    }

    // The other stages are those of the solution: one seed is enough for them.
    Judged judged(const Mutant& mutant) const {
        const TemporaryFolder folder;
        const std::filesystem::path source = folder.path() / mutant.file, library = folder.path() / "submission.so";
        const ManifestStage& stage = manifest.find(mutant.stage);
        const Manifest within = stage.isExtension() ? manifest.of(stage) : manifest;
        radlab::writeFile(source, mutant.source);
        compileSubmission(source, library, toolchain, within);
        Judged all;
        for (int i = 0; i < settings.seeds; ++i) {
            JudgeOptions options;
            options.seed = settings.firstSeed + static_cast<std::uint64_t>(i);
            options.pictures = i == 0;
            if (i > 0) options.stages = {mutant.stage};
            const Result result = Judge(within, toolchain, options).judge(library);
            if (i == 0) all.lost = lostMarks(result);
            all.verdicts.push_back(verdictOf(result, mutant.stage, manifest));
        }
        return all;
    }

    void judge(const Mutant& mutant) {
        const Judged all = judged(mutant);
        const std::string& name = all.verdicts.front().name;
        const bool named = std::count(mutant.names.begin(), mutant.names.end(), name) > 0;
        Row& row = rows[mutant.stage];
        row.steady += all.steady();
        row.sameMarks += all.sameMarks();
        bool asWanted = all.steady();
        if (mutant.wrong) {
            const bool caught = all.lost.count(mutant.stage) > 0, alone = all.lost.size() == (caught ? 1u : 0u);
            ++row.wrong;
            row.caught += caught;
            row.alone += alone;
            row.nameable += !mutant.names.empty();
            row.named += named;
            asWanted = asWanted && caught && alone && (named || mutant.names.empty());
        } else {
            ++row.right;
            row.kept += all.lost.empty();
            asWanted = asWanted && all.lost.empty();
        }
        if (!asWanted || settings.list) tell(mutant, all);
    }

    static void tell(const Mutant& mutant, const Judged& all) {
        std::cerr << (mutant.wrong ? "wrong " : "right ") << mutant.stage << ' ' << mutant.id << ':';
        for (const auto& [stage, marks] : all.lost) std::cerr << " -" << marks << ' ' << stage;
        for (const Verdict& verdict : all.verdicts) {
            if (&verdict != &all.verdicts.front() && verdict == all.verdicts.front()) continue;
            std::cerr << " (" << (verdict.name.empty() ? "unnamed" : verdict.name) << (verdict.error ? ", ERROR" : "");
            for (const std::string& check : verdict.failing) std::cerr << ' ' << check;
            std::cerr << ")";
        }
        std::cerr << std::endl;
    }

    const Settings& settings;
    Toolchain toolchain;
    Manifest manifest;
    std::map<std::string, Row> rows;
};

}  // namespace

int main(int argc, char** argv) {
    CLI::App flags("Judges wrong and right variants of the solution and counts the verdicts that are right.");
    Settings settings;
    flags.add_option("--stage", settings.stage, "Only the mutants of this stage");
    flags.add_option("--id", settings.id, "Only this mutant");
    flags.add_option("--seeds", settings.seeds, "Seeds to judge each one with")->check(CLI::PositiveNumber);
    flags.add_option("--seed", settings.firstSeed, "The first seed");
    flags.add_flag("--list", settings.list, "Tell every verdict, not only those that are not as they should be");
    return radlab::runCommandLine(flags, argc, argv, [&] {
        const radlab::Interrupts interrupts;
        Proof proof(settings);
        proof.run();
        return proof.print() ? 0 : 1;
    });
}
