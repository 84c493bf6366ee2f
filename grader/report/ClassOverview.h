#pragma once

#include <vector>

#include <kainjow/mustache.hpp>

#include "grader/report/ClassFigures.h"

namespace radlab::grader {

/// Gives the template class.mustache what it says about a class as a whole: figures, histograms, common mistakes.
void setOverview(kainjow::mustache::data& values, const ClassFigures& figures,
                 const std::vector<StudentResult>& results);

/// Where a student's page is, and what the link to it says.
kainjow::mustache::data linkTo(const Student& student);

}  // namespace radlab::grader
