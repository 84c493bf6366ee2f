#pragma once

#include <string>
#include <vector>

#include "study/Measurement.h"
#include "study/ParetoFront.h"
#include "study/Plot.h"
#include "study/StudyPlan.h"

namespace radlab::study {

/// The whole error against seconds, with the Pareto front marked: joined are the rows that differ in patches alone.
Plot wholePlot(const std::string& file, const std::vector<const Measurement*>& rows, const StudyPlan& plan);

/// The solver's error against seconds, with the Pareto front marked.
Plot solverPlot(const std::string& file, const std::vector<const Measurement*>& rows);

/// The solver's error against shots, of the methods that shoot.
Plot shotsPlot(const std::string& file, const std::vector<const Measurement*>& rows);

/// Seconds, and memory, against patches: one setting of each method, with the exponent that fits.
Plot secondsPlot(const std::string& file, const std::vector<const Measurement*>& rows, const StudyPlan& plan);
Plot memoryPlot(const std::string& file, const std::vector<const Measurement*>& rows, const StudyPlan& plan);

}  // namespace radlab::study
