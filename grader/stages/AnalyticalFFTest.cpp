#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = analyticalStage();

}  // namespace

TEST_CASE("analytical: the right way passes") { checkRightWaysPass(*stage, 50); }

TEST_CASE("analytical: every mistake fails and is named") { checkMistakesAreNamed(*stage, 5); }

TEST_CASE("analytical: no two mistakes are the same") { checkMistakesDiffer(*stage, 1); }

TEST_CASE("analytical: texts are sentences") { checkWording(*stage); }
