#include "grader/stages/StageTestHelp.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

const std::unique_ptr<Stage> stage = antialiasStage();

}  // namespace

TEST_CASE("antialias: the right way passes") { checkRightWaysPass(*stage, 10); }

TEST_CASE("antialias: every mistake fails and is named") { checkMistakesAreNamed(*stage, 3); }

TEST_CASE("antialias: no two mistakes are the same") { checkMistakesDiffer(*stage, 1); }

TEST_CASE("antialias: texts are sentences") { checkWording(*stage); }
