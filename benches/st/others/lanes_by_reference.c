/* The same in C: a structure by value or by reference is a pointer there. */
#include "others/pack11_structs.c"
