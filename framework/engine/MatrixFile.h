#pragma once

#include <filesystem>
#include <string>

#include "engine/FormFactorMatrix.h"

namespace radlab::engine {

/// Makes sure that a matrix can be written to a file of that name, before anyone waits for the matrix.
///
/// Errors: an ending other than .csv and .npy.
void requireMatrixFile(const std::filesystem::path& file);

/// Writes a matrix, whole or not at all: row i, column j is F(i→j).
///
/// .csv: the comment, each line after "# ", then a line a row, 17 digits, no header. .npy: NumPy's format, doubles in rows.
///
/// Errors: another ending; a file that cannot be written.
void writeMatrix(const std::filesystem::path& file, const FormFactorMatrix& matrix, const std::string& comment);

}  // namespace radlab::engine
