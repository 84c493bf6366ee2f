// Nothing: a target to precompile headers for needs a file.
