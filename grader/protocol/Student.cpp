#include "grader/protocol/Student.h"

namespace radlab::grader {

std::string outcomeText(Outcome outcome) {
    switch (outcome) {
        case Outcome::graded: return "graded";
        case Outcome::nothing: return "nothing";
        case Outcome::refused: return "refused";
        case Outcome::error: return "error";
    }
    return "error";
}

}  // namespace radlab::grader
