// What is counted where an Assistant's answers may allocate nothing; a file of its own, as there.
#include "atlas/allocations.cpp"
