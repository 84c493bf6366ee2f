#pragma once

#include <filesystem>

#include <SQLiteCpp/SQLiteCpp.h>

namespace radlab::grader {

/// Opens the database of a class' grades to read it.
///
/// Errors: no such file, one that is no store or damaged, one that a newer radlab wrote.
SQLite::Database openStore(const std::filesystem::path& file);

/// The same to write it; made where there is none. What is committed survives the end of this process, and a loss of
/// power.
SQLite::Database openStoreForWriting(const std::filesystem::path& file);

/// What an exception of SQLite means for whoever uses the store: an Error, or a MachineError.
[[noreturn]] void throwStoreError(const std::filesystem::path& file, const SQLite::Exception& failure);

/// Works on a store; exceptions of SQLite become errors that name the file.
template <class Work>
auto onStore(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const SQLite::Exception& failure) {
        throwStoreError(file, failure);
    }
}

}  // namespace radlab::grader
