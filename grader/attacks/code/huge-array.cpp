// A library of eight gigabytes.
char huge[std::size_t{1} << 33] = {1};
