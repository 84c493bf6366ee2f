// Hands in the solution of the machine that grades.
#include SOLUTION
