#include "engine/MatrixFile.h"

#include <bit>
#include <ostream>
#include <sstream>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/NumberText.h"
#include "base/WholeFile.h"

namespace radlab::engine {

namespace {

constexpr std::size_t npyAlignment = 64;

void writeCsv(std::ostream& out, const FormFactorMatrix& matrix, const std::string& comment) {
    std::istringstream lines(comment);
    for (std::string line; std::getline(lines, line);) out << "# " << line << '\n';
    std::string text;
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        Interrupts::check();
        text.clear();
        for (std::size_t j = 0; j < matrix.size(); ++j) {
            if (j > 0) text += ',';
            appendNumber(text, matrix.at(i, j), 17);
        }
        out << text << '\n';
    }
}

// NumPy's format 1.0: a magic word, the header's length in two bytes, and a Python dictionary padded to 64 bytes.
void writeNpy(std::ostream& out, const FormFactorMatrix& matrix) {
    static_assert(std::endian::native == std::endian::little);
    const std::string count = std::to_string(matrix.size());
    std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + count + ", " + count + "), }";
    constexpr std::size_t before = 10;
    header.append(npyAlignment - 1 - (before + header.size()) % npyAlignment, ' ');
    header += '\n';
    out.write("\x93NUMPY\x01\x00", 8);
    out.put(static_cast<char>(header.size() & 255)).put(static_cast<char>(header.size() >> 8));
    out << header;
    const std::size_t bytes = matrix.size() * sizeof(double);
    for (std::size_t i = 0; i < matrix.size(); ++i) {
        Interrupts::check();
        out.write(reinterpret_cast<const char*>(matrix.row(i)), static_cast<std::streamsize>(bytes));
    }
}

}  // namespace

void requireMatrixFile(const std::filesystem::path& file) {
    const std::string ending = file.extension().string();
    if (ending != ".csv" && ending != ".npy")
        throw Error(file.string() + ": found the ending '" + ending + "', expected .csv or .npy");
}

void writeMatrix(const std::filesystem::path& file, const FormFactorMatrix& matrix, const std::string& comment) {
    requireMatrixFile(file);
    writeFile(file, [&](std::ostream& out) {
        if (file.extension() == ".npy")
            writeNpy(out, matrix);
        else
            writeCsv(out, matrix, comment);
    });
}

}  // namespace radlab::engine
