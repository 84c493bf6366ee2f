#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/protocol/Message.h"
#include "grader/protocol/Result.h"

namespace radlab::grader {

/// Calls of a stage's function on a state that the judge made; the first step brings the state.
struct Case {
    std::string what;  ///< for messages: "two tilted patches"
    std::vector<Step> steps;
};

/// The cases behind one line of the manifest; one process performs them.
struct Check {
    std::string id;
    std::vector<Case> cases;
};

/// What a function finds when it is called.
struct Situation {
    const State& before;
    const Step& step;
    const StepAnswer& answer;  ///< what the submission did in this step: which way up it turned its hemicube
    const Situation* earlier;  ///< the step before in the same case, or nullptr
};

/// What a function leaves behind.
struct Outcome {
    State state;
    int returned = 0;  ///< as in StepAnswer
    std::vector<double>
        pixels;  ///< red · 65536 + green · 256 + blue, row by row from the bottom; of what is drawn in floats:
                 ///< each channel by itself, row by row from the top
    std::vector<double> slack;  ///< how far pixels or form factors may be off by what OpenGL leaves open; may be empty
    Stop stop;                  ///< where it throws; text is a part of what it says
};

/// A way to do what a function does, right or wrong.
using Computation = std::function<Outcome(const Situation&)>;

/// A misconception: what is believed, and the computation that follows from it.
struct Mistake {
    std::string id;    ///< "missing-inverse-pi"
    std::string text;  ///< what is believed, and why it is wrong
    std::string hint;  ///< leads on, without the code
    Computation computation;
};

/// Numbers out of an outcome, and how far each may be off.
struct Numbers {
    std::vector<double> values;
    std::vector<double> slack;  ///< infinity: it does not matter
};

/// A submission's numbers for one step beside those that are right.
struct Comparison {
    const State& before;
    const Step& step;
    const Numbers& found;
    const Numbers& expected;
};

/// One of the six functions, or an extension: its cases, what is right, and what people believe instead.
class Stage {
public:
    virtual ~Stage() = default;

    virtual std::string function() const = 0;

    /// The checks in the manifest's order, their cases drawn from the seed: the same for the same seed.
    virtual std::vector<Check> checks(std::uint64_t seed) const = 0;

    /// The right ways; a submission passes where it agrees with the same one throughout.
    virtual std::vector<Computation> right() const = 0;

    /// What is compared, the same count for every outcome of a step.
    virtual Numbers numbers(const Step& step, const State& before, const Outcome& outcome) const = 0;

    /// What value k of numbers is called in C++: "polygons[3]->formF".
    virtual std::string name(const Step& step, std::size_t k) const = 0;

    /// A value in words.
    virtual std::string show(const Step& step, std::size_t k, double value) const;

    /// Where the tolerance comes from: "0.03 %: π to 4 digits, float arithmetic".
    virtual std::string tolerance() const = 0;

    /// Special ones before general ones: the first that fits is named.
    virtual std::vector<Mistake> mistakes() const = 0;

    /// Names what no catalogued mistake explains.
    virtual std::optional<Diagnosis> fit(const std::vector<Comparison>& comparisons) const;

    /// The members of a state that the function reads, for printing a case as C++.
    virtual std::vector<std::string> inputs() const = 0;
};

/// The stages that are judged apart, in the order of the exercise.
std::vector<std::unique_ptr<Stage>> allStages();

/// The extensions, in the manifest's order.
std::vector<std::unique_ptr<Stage>> extensionStages();

std::unique_ptr<Stage> maxenergyStage();
std::unique_ptr<Stage> analyticalStage();
std::unique_ptr<Stage> distributeStage();
std::unique_ptr<Stage> colorStage();
std::unique_ptr<Stage> patchIdStage();
std::unique_ptr<Stage> hemicubeStage();
std::unique_ptr<Stage> hemisphereStage();
std::unique_ptr<Stage> antialiasStage();
std::unique_ptr<Stage> mirrorStage();

}  // namespace radlab::grader
