#pragma once

#include <memory>

#include "gl/Context.h"

namespace radlab::grader {

/// A context in which IDs have been drawn already, so that its programs are compiled: what is forked from here starts with it.
///
/// @return nullptr where there is no OpenGL; whoever needs it will find out why
/// @cost 60 ms, which each context would take at its first drawing
std::unique_ptr<GlContext> warmOpenGl();

}  // namespace radlab::grader
