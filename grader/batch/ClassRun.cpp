#include "grader/batch/ClassRun.h"

#include <set>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "grader/batch/ClassProgress.h"

namespace radlab::grader {

namespace {

constexpr int takeTries = 3;
constexpr std::size_t mostNotes = 100;  // that are lost where the run is killed, and found out again by the next

class ClassRun {
public:
    ClassRun(const std::vector<Submission>& all, Store& into, const ClassRules& how)
        : submissions(all), store(into), rules(how), progress(all.size()) {
        std::set<std::string> ids;
        for (const Submission& one : submissions) ids.insert(one.student.id);
        RADLAB_CHECK(ids.size() == submissions.size());
    }

    ClassCounts grade(Engine& engine) {
        const Interrupts interrupts;
        store.begin(rules.key);
        doneWhole([&] {
            engine.grade({[&] { return next(); }, [&](const Job& job, const Graded& graded) { save(job, graded); },
                          [&](const Job& job, const std::string& reason, bool last) { fail(job, reason, last); }});
        });
        store.note(notes);
        counts.interrupted = Interrupts::caught();
        if (!counts.interrupted) store.finish();
        return counts;
    }

private:
    std::optional<Job> next() {
        while (at < submissions.size() && !Interrupts::caught())
            if (std::optional<Job> job = jobOf(submissions[at++])) return job;
        return std::nullopt;
    }

    // What is to be graded of a submission; nothing where it is settled already, or will be with one that is alike.
    std::optional<Job> jobOf(const Submission& submission) {
        StudentNote entry;
        entry.student = submission.student;
        Taken taken;
        if (!take(submission, taken, entry.fault)) {
            entry.outcome = Outcome::error;
            settle(entry, counts.errors);
            return std::nullopt;
        }
        entry.student.remarks.insert(entry.student.remarks.end(), taken.remarks.begin(), taken.remarks.end());
        entry.outcome = taken.outcome;
        entry.hash = taken.hash;
        if (taken.outcome != Outcome::graded) {
            settle(entry, taken.outcome == Outcome::nothing ? counts.nothing : counts.refused);
            return std::nullopt;
        }
        if (store.isGraded(taken.hash)) {
            settle(entry, counts.kept);
            return std::nullopt;
        }
        std::vector<Student>& alike = waiting[taken.hash];
        alike.push_back(entry.student);
        if (alike.size() > 1) return std::nullopt;
        return Job{taken.hash, std::move(taken.files)};
    }

    bool take(const Submission& submission, Taken& taken, std::string& fault) {
        for (int i = 0; i < takeTries; ++i) {
            try {
                taken = rules.take(submission);
                return true;
            } catch (const Error& error) {
                fault = error.what();
                store.addFault(submission.student.id, fault);
            }
        }
        return false;
    }

    void settle(const StudentNote& entry, std::size_t& count) {
        ++count;
        notes.push_back(entry);
        if (notes.size() == mostNotes) writeNotes();
        if (entry.outcome == Outcome::error)
            progress.done(true);
        else
            progress.skip();
    }

    void writeNotes() {
        store.note(notes);
        notes.clear();
    }

    void save(const Job& job, const Graded& graded) {
        const std::vector<Student> students = std::move(waiting.at(job.hash));
        waiting.erase(job.hash);
        store.save(job.hash, graded, students);
        counts.graded += students.size();
        if (rules.saved) rules.saved(job.hash);
        for (std::size_t i = 0; i < students.size(); ++i) progress.done(false);
    }

    void fail(const Job& job, const std::string& reason, bool last) {
        store.addFault(job.hash, reason);
        if (!last) return;
        for (const Student& student : waiting.at(job.hash))
            settle({student, Outcome::error, job.hash, reason}, counts.errors);
        waiting.erase(job.hash);
    }

    const std::vector<Submission>& submissions;
    Store& store;
    const ClassRules& rules;
    ClassProgress progress;
    ClassCounts counts;
    std::size_t at = 0;
    std::vector<StudentNote> notes;
    std::map<std::string, std::vector<Student>> waiting;  // by the hash of what is being graded
};

}  // namespace

ClassCounts gradeClass(const std::vector<Submission>& submissions, Store& store, Engine& engine,
                       const ClassRules& rules) {
    return ClassRun(submissions, store, rules).grade(engine);
}

}  // namespace radlab::grader
