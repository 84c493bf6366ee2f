#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = mirrorStage();

}  // namespace

TEST_CASE("mirror: the right way passes") { checkRightWaysPass(*stage, 10); }

TEST_CASE("mirror: every mistake fails and is named") { checkMistakesAreNamed(*stage, 3); }

TEST_CASE("mirror: no two mistakes are the same") { checkMistakesDiffer(*stage, 1); }

TEST_CASE("mirror: texts are sentences") { checkWording(*stage); }
