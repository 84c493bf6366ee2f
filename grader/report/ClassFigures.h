#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "grader/protocol/Student.h"

namespace radlab::grader {

/// How a class did in one check.
struct CheckFigures {
    std::string id, name;
    std::size_t passed = 0;
    std::size_t judged = 0;  ///< passed or failed; what was not started or blocked is neither
};

/// How a class did in one stage.
struct StageFigures {
    int number = 0;
    std::string stage;  ///< the function's name
    double maxScore = 0.0;
    std::vector<double> scores;  ///< of all students whose result has the stage
    std::size_t passed = 0;
    std::size_t notStarted = 0;
    std::vector<CheckFigures> checks;
};

/// A mistake, and who made it.
struct Misconception {
    std::string stage;
    Diagnosis diagnosis;
    std::vector<std::size_t> students;  ///< numbers in the class
};

/// What a class did as a whole. Only those with a mark count in scores, stages and misconceptions.
struct ClassFigures {
    std::size_t students = 0;
    std::map<std::string, std::size_t> outcomes;  ///< how many by outcomeWord
    std::size_t late = 0;
    double maxScore = 0.0;
    std::vector<double> scores;
    double mean = 0.0, median = 0.0;            ///< of the scores; 0 where there is none
    std::vector<StageFigures> stages;           ///< by number, all together included
    std::vector<Misconception> misconceptions;  ///< those of most students first
};

/// @cost linear in the checks of all students
ClassFigures figuresOf(const std::vector<StudentResult>& results);

/// The mean of some scores, 0 of none.
double meanOf(const std::vector<double>& scores);

}  // namespace radlab::grader
